# SPDX-License-Identifier: MIT
"""Ctrl-C, and other threads."""
import _thread
import os
import signal
import threading
import time

from support import FolderCase, frostfill, unittest

LONG = {"mesh": "torus", "radius": 0.01}  # some minutes


class Interruption(FolderCase):
    def interrupt_after(self, seconds):
        timer = threading.Timer(seconds, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        self.addCleanup(timer.join)

    def test_stops_a_fill_after_the_step_and_leaves_a_run_to_resume(self):
        out = self.folder / "run"
        self.interrupt_after(3)
        begun = time.process_time()
        with self.assertRaises(KeyboardInterrupt):
            frostfill.fill(**LONG, out=out)
        self.assertLess(time.process_time() - begun, 60)
        if (out / "summary.json").exists():  # it had begun to simulate
            stopped = frostfill.load(out)
            self.assertEqual(stopped.summary["outcome"], "stopped")

    def test_stops_steps_that_python_does_not_see(self):
        simulation = frostfill.Simulation(**LONG)
        self.interrupt_after(1)
        with self.assertRaises(KeyboardInterrupt):
            simulation.advance()
        self.assertGreater(simulation.steps, 0)
        self.assertTrue(simulation.step())  # and it goes on where it was

    def test_stops_an_estimate(self):
        self.interrupt_after(1)
        with self.assertRaises(KeyboardInterrupt):
            frostfill.volume("torus", radius=0.01)

    def test_is_what_the_handler_of_the_signal_makes_of_it(self):
        class Enough(Exception):
            pass

        def handler(_number, _frame):
            raise Enough

        before = signal.signal(signal.SIGINT, handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        self.interrupt_after(1)
        with self.assertRaises(Enough):
            frostfill.Simulation(**LONG).advance()


class Threads(unittest.TestCase):
    def test_work_while_others_do(self):
        """The interpreter is free: a second thread counts while the first one fills."""
        done = threading.Event()
        counted = 0

        def fill():
            frostfill.Simulation("torus", count=2000, motion="skip").advance()
            done.set()

        worker = threading.Thread(target=fill)
        worker.start()
        while not done.is_set():
            counted += 1
            time.sleep(0.001)
        worker.join()
        self.assertGreater(counted, 20)

    def test_get_the_same_from_simulations_of_their_own(self):
        hashes = []

        def fill():
            simulation = frostfill.Simulation("cube", count=100)
            simulation.advance()
            hashes.append(simulation.state_hash())

        workers = [threading.Thread(target=fill) for _ in range(4)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        self.assertEqual(len(hashes), 4)
        self.assertEqual(len(set(hashes)), 1)

    def test_are_kept_from_one_object_at_the_same_time(self):
        simulation = frostfill.Simulation("torus", count=3000, motion="skip")
        refused = threading.Event()
        worker = threading.Thread(target=simulation.advance)
        worker.start()
        while worker.is_alive() and not refused.is_set():
            try:
                simulation.step()
            except frostfill.Usage as error:
                self.assertIn("another thread", str(error))
                refused.set()
            except AssertionError:
                _thread.interrupt_main()
        worker.join()
        self.assertTrue(refused.is_set())


if __name__ == "__main__":
    unittest.main()
