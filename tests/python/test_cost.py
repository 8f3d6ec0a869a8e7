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


def best(*works, times=7):
    """The least time of each, taken in turns, so that all of them meet the same quiet moments."""
    rounds = [[processor_time(work()) for work in works] for _ in range(times)]
    return [min(taken) for taken in zip(*rounds)]


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

        base, step, snapshot = best(alone, stepped, snapshots)
        of_step = (step - base) / STEPS / MICROSECOND
        of_snapshot = (snapshot - base) / STEPS / MICROSECOND
        print(f"a step: {base / STEPS / MICROSECOND:.2f} us; beside it from Python: {of_step:.2f} us, "
              f"with a snapshot {of_snapshot:.2f} us")
        self.assertLess(of_step, 2)
        self.assertLess(of_snapshot, 2)

    def test_of_a_million_centres_is_a_copy_of_none_of_them(self):
        run = frostfill.fill("cube", radius=0.0102, motion="descend", threads=1)
        count = len(run.centres)
        self.assertGreater(count, 1_000_000)
        self.assertTrue(numpy.shares_memory(run.centres, run.centres))

        def views():
            return lambda: [run.centres for _ in range(100)]

        view, copied = best(views, lambda: lambda: run.centres.copy())
        view /= 100
        print(f"{count} centres: {1e3 * view:.3f} ms as a view, {1e3 * copied:.1f} ms as a copy")
        self.assertLess(view, 0.05 * copied)
        self.assertTrue(numpy.isfinite(run.centres).all())


if __name__ == "__main__":
    unittest.main()
