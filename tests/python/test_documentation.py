# SPDX-License-Identifier: MIT
"""What is written of the module is true of it."""
import doctest
import inspect
import pathlib
import re
import subprocess
import sys
import tempfile
import os

from support import SOURCE, frostfill, unittest

PARTS = [frostfill, frostfill._runs, frostfill._simulation, frostfill._instruments,
         frostfill._pictures, frostfill._progress]


class Documentation(unittest.TestCase):
    def test_examples_in_docstrings_hold(self):
        tried = 0
        for part in PARTS:
            result = doctest.testmod(
                part, optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
            self.assertEqual(result.failed, 0, part.__name__)
            tried += result.attempted
        self.assertGreater(tried, 15)

    def test_everything_public_has_help(self):
        for name in frostfill.__all__:
            value = getattr(frostfill, name)
            self.assertTrue(getattr(value, "__doc__", None), name)
            if inspect.isclass(value) and not issubclass(value, (BaseException, tuple, int)):
                for member in vars(value):
                    if not member.startswith("_"):
                        self.assertTrue(getattr(value, member).__doc__, f"{name}.{member}")

    def test_the_stub_is_what_the_module_has(self):
        printed = subprocess.run(
            [sys.executable, SOURCE / "python" / "make_stub.py"],
            capture_output=True, text=True, check=True).stdout
        kept = (SOURCE / "python" / "frostfill" / "__init__.pyi").read_text()
        self.assertEqual(printed, kept, "print it again: see the head of python/make_stub.py")
        compile(kept, "__init__.pyi", "exec")

    def test_keywords_are_those_of_the_table_and_no_two_are_alike(self):
        keywords = [row["keyword"] for row in frostfill._frostfill.keywords("filling")]
        self.assertEqual(len(keywords), len(set(keywords)))
        self.assertLess({"count", "radius", "spheres_until_full", "color_by", "colour_frozen"}, set(keywords))
        page = (SOURCE / "docs" / "options.md").read_text()
        rows = re.findall(r"^\| `([a-z_.]+)` \| (?:`--([a-z-]+)`)? ?\|", page, re.M)
        self.assertGreater(len(rows), 80)
        names = {flag.replace("-", "_") or key.replace(".", "_") for key, flag in rows}
        self.assertEqual(names - {"object_mesh"}, set(keywords))
        self.assertLessEqual(set(keywords), set(inspect.signature(frostfill.fill).parameters))
        for keyword in keywords:
            self.assertIn(f"\n    {keyword}: ", frostfill.fill.__doc__)

    def test_the_code_on_the_pages_runs(self):
        pages = [SOURCE / "README.md", *sorted((SOURCE / "docs").glob("*.md"))]
        found = {page.name: re.findall(r"```python\n(.*?)```", page.read_text(), re.S) for page in pages}
        for page in ("README.md", "python.md", "tutorial.md", "sizes.md", "analysis.md"):
            self.assertTrue(found[page], page)
        for page, blocks in found.items():
            with tempfile.TemporaryDirectory() as folder:
                here = pathlib.Path.cwd()
                os.chdir(folder)
                try:
                    names = {}
                    for block in blocks:
                        exec(compile(block, page, "exec"), names)  # noqa: S102
                finally:
                    os.chdir(here)


if __name__ == "__main__":
    unittest.main()
