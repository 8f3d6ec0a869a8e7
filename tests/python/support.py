# SPDX-License-Identifier: MIT
"""What the tests share: where things are, and how a test without its tools ends."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SKIPPED = 77


def require(*modules):
    """Ends the program as skipped, with the reason, where a module is not installed."""
    for module in modules:
        try:
            __import__(module)
        except ImportError as error:
            print(f"skipped: {error}; apt-get install python3-{module}")
            sys.exit(SKIPPED)


require("numpy")

import frostfill  # noqa: E402

SOURCE = pathlib.Path(os.environ["FROSTFILL_SOURCE_DIR"])
PROGRAM = os.environ["FROSTFILL_PROGRAM"]


def run_program(*arguments):
    """The program's standard output."""
    # The sanitizer's library is for the interpreter alone.
    environment = {k: v for k, v in os.environ.items() if k != "LD_PRELOAD"}
    done = subprocess.run(
        [PROGRAM, *map(str, arguments)], env=environment, capture_output=True, text=True, check=False
    )
    if done.returncode != 0:
        raise AssertionError(f"{arguments} ended with {done.returncode}: {done.stderr}")
    return done.stdout


class FolderCase(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="frostfill-test-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


__all__ = ["FolderCase", "PROGRAM", "SOURCE", "frostfill", "require", "run_program", "unittest"]
