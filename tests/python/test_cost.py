# SPDX-License-Identifier: MIT
"""What Python costs, in processor time, as others may use the machine."""
import gc
import time

import numpy
from support import frostfill, unittest

STEPS = 10_000
MICROSECOND = 1e-6


def processor_time(work):
    gc.collect()
    begin = time.process_time()
    work()
    return time.process_time() - begin


def best(work, times=3):
    return min(processor_time(work()) for _ in range(times))


class Cost(unittest.TestCase):
    def simulation(self):
        # A short step: one sphere that falls slowly. It lasts for many more steps than are taken.
        simulation = frostfill.Simulation("sphere", count=1, radius=0.01, dt=1e-6, threads=1)
        simulation.step()
        return simulation

    def test_of_a_step_from_python_is_below_two_microseconds_beside_the_step(self):
        def alone():
            simulation = self.simulation()
            return lambda: self.assertEqual(simulation.advance(STEPS), STEPS)

        def stepped():
            simulation = self.simulation()

            def work():
                for _ in range(STEPS):
                    simulation.step()
            return work

        def snapshots():
            simulation = self.simulation()

            def work():
                for _, snapshot in zip(range(STEPS), simulation):
                    pass
                self.assertEqual(len(snapshot), 1)
            return work

        base, step, snapshot = best(alone), best(stepped), best(snapshots)
        of_step = (step - base) / STEPS / MICROSECOND
        of_snapshot = (snapshot - base) / STEPS / MICROSECOND
        print(f"a step: {base / STEPS / MICROSECOND:.2f} us; beside it from Python: {of_step:.2f} us, "
              f"with a snapshot {of_snapshot:.2f} us")
        self.assertLess(of_step, 2)
        self.assertLess(of_snapshot, 2)

    def test_of_a_million_centres_is_at_most_ten_milliseconds(self):
        run = frostfill.fill("cube", radius=0.0102, motion="descend", threads=1)
        count = len(run.centres)
        self.assertGreater(count, 1_000_000)
        seconds = best(lambda: lambda: run.centres)
        copied = best(lambda: lambda: run.centres.copy())
        print(f"{count} centres: {1e3 * seconds:.3f} ms as a view, {1e3 * copied:.1f} ms as a copy")
        self.assertLess(seconds, 0.010)
        self.assertTrue(numpy.isfinite(run.centres).all())


if __name__ == "__main__":
    unittest.main()
