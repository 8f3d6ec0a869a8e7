# SPDX-License-Identifier: MIT
"""The backend of pip: test_wheel.py INSTALLED. It packs an install that CMake has made."""
import base64
import csv
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "tools/pip"))
import wheel_backend as backend  # noqa: E402

INSTALLED = pathlib.Path(sys.argv.pop(1))


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.folder = pathlib.Path(cls.temporary.name)
        staging = cls.folder / "staging"
        shutil.copytree(next(INSTALLED.glob("lib*/python3*/*-packages")), staging / "platlib",
                        ignore=shutil.ignore_patterns("__pycache__"))
        (staging / "scripts").mkdir()
        shutil.copy(INSTALLED / "bin/frostfill", staging / "scripts")
        cls.platform = f"linux_{os.uname().machine}"
        if shutil.which("patchelf"):
            backend.bundle(staging)
            cls.platform = backend.platform_tag(staging)
        cls.file = cls.folder / backend.pack(staging, cls.folder, cls.platform)
        cls.archive = zipfile.ZipFile(cls.file)
        cls.addClassCleanup(cls.archive.close)
        cls.information = f"{backend.NAME}.dist-info"

    def text(self, name):
        return self.archive.read(f"{self.information}/{name}").decode()

    def test_version_is_that_of_cmake_and_of_the_citation(self):
        version = re.search(r"project\(frostfill VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text())[1]
        self.assertEqual(backend.PROJECT["version"], version)
        self.assertIn(f"\nversion: {version}\n", (SOURCE / "CITATION.cff").read_text())

    def test_metadata_say_what_pip_asks_for(self):
        head = self.text("METADATA").split("\n\n")[0].splitlines()
        self.assertTrue({"Metadata-Version: 2.1", "Name: frostfill", f"Version: {backend.PROJECT['version']}",
                         "Requires-Dist: numpy", "Requires-Python: >=3.11"} <= set(head), head)
        tag = f"{backend.PYTHON}-{backend.PYTHON}-{self.platform}"
        self.assertEqual(self.file.name, f"{backend.NAME}-{tag}.whl")
        self.assertEqual(self.text("WHEEL").splitlines()[2:], ["Root-Is-Purelib: false", f"Tag: {tag}"])
        self.assertIn(f"{self.information}/licenses/LICENSE", self.archive.namelist())

    def test_record_has_the_hash_and_size_of_every_file(self):
        rows = {name: rest for name, *rest in csv.reader(self.text("RECORD").splitlines())}
        self.assertEqual(list(rows), self.archive.namelist())
        self.assertEqual(rows.pop(f"{self.information}/RECORD"), ["", ""])
        for name, (digest, size) in rows.items():
            data = self.archive.read(name)
            expected = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            self.assertEqual((digest, int(size)), (f"sha256={expected}", len(data)), name)

    def test_program_may_be_executed_and_nothing_else_is_a_script(self):
        scripts = [m for m in self.archive.infolist() if m.filename.startswith(f"{backend.NAME}.data/")]
        self.assertEqual([m.filename for m in scripts], [f"{backend.NAME}.data/scripts/frostfill"])
        self.assertEqual(scripts[0].external_attr >> 16, 0o100755)
        for name in ("__init__.py", "__init__.pyi", "py.typed"):
            self.assertIn(f"frostfill/{name}", self.archive.namelist())

    def test_equal_files_make_equal_bytes(self):
        again = self.folder / "again"
        again.mkdir()
        backend.pack(self.folder / "staging", again, self.platform)
        self.assertEqual((again / self.file.name).read_bytes(), self.file.read_bytes())

    def test_installed_it_needs_no_library_of_the_system(self):
        if not shutil.which("patchelf"):
            self.skipTest("patchelf is not installed")
        root = self.folder / "prefix"  # as pip lays it out
        packages = root / f"lib/python{sys.version_info.major}.{sys.version_info.minor}/site-packages"
        self.archive.extractall(packages)
        (packages / f"{backend.NAME}.data/scripts").rename(root / "bin")
        (root / "bin/frostfill").chmod(0o755)
        environment = {k: v for k, v in os.environ.items() if k != "LD_LIBRARY_PATH"} | {"PYTHONPATH": str(packages)}
        code = "import frostfill; frostfill.fill('cube', count=5); print(frostfill._frostfill.__file__)"
        module = subprocess.run([sys.executable, "-c", code], env=environment, check=True, capture_output=True,
                                text=True, cwd=self.folder).stdout.split()[-1]
        self.assertTrue(module.startswith(str(packages)), module)
        program = root / "bin/frostfill"
        subprocess.run([program, "--version"], env=environment, check=True, capture_output=True)
        for binary in (module, program):
            text = subprocess.run(["ldd", binary], env=environment, check=True, capture_output=True, text=True).stdout
            for name, place in re.findall(r"^\s*(\S+) => (\S+)", text, re.M):
                if not backend.SYSTEM.fullmatch(name):
                    self.assertIn(f"/{backend.LIBRARIES}/", place, f"{name} of {binary}")


if __name__ == "__main__":
    unittest.main(verbosity=2)
