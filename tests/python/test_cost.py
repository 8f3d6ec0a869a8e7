# SPDX-License-Identifier: MIT
"""What Python adds to a step and to an array, in calls and bytes: times depend on the machine."""
import gc
import sys
import time
import tracemalloc

import numpy
from support import frostfill, unittest

STEPS = 10_000


def calls(work):
    """How many functions of Python, and of C called from Python, run while `work` does."""
    counted = 0

    def count(_frame, event, _argument):
        nonlocal counted
        counted += event in ("call", "c_call")

    sys.setprofile(count)
    try:
        work()
    finally:
        sys.setprofile(None)
    return counted - 2  # `work` itself and the last line of this


def most_bytes(work):
    """How much memory Python's allocator had out at most while `work` ran, beyond before."""
    gc.collect()
    tracemalloc.start()
    try:
        work()
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


class Cost(unittest.TestCase):
    def simulation(self):
        # A short step: one sphere that falls slowly. It lasts for many more steps than are taken.
        simulation = frostfill.Simulation("sphere", count=1, radius=0.01, motion_dt=1e-6, threads=1)
        simulation.step()
        return simulation

    def test_of_a_step_from_python_is_one_call_and_no_memory(self):
        simulation = self.simulation()

        def work():
            for _ in range(STEPS):
                simulation.step()

        begin = time.process_time()
        work()
        print(f"a step from Python: {1e6 * (time.process_time() - begin) / STEPS:.2f} us")
        self.assertLessEqual(calls(work), STEPS)
        self.assertLess(most_bytes(work), 10_000)

    def test_of_a_snapshot_is_one_call_and_the_memory_of_a_few(self):
        simulation = self.simulation()

        def work():
            for _, snapshot in zip(range(STEPS), simulation):
                pass
            self.assertEqual(len(snapshot), 1)

        self.assertLessEqual(calls(work), STEPS + 20)
        self.assertLess(most_bytes(work), 10_000)

    def test_of_all_centres_is_a_copy_of_none_of_them(self):
        run = frostfill.fill("cube", radius=0.0218, motion="descend", threads=1)
        self.assertGreater(len(run.centres), 100_000)
        self.assertTrue(numpy.shares_memory(run.centres, run.centres))
        self.assertGreater(most_bytes(run.centres.copy), 2_400_000)  # numpy tells of its own
        self.assertLess(most_bytes(lambda: [run.centres for _ in range(100)]), 100_000)
        self.assertTrue(numpy.isfinite(run.centres).all())


if __name__ == "__main__":
    unittest.main()
