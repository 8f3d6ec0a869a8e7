# SPDX-License-Identifier: MIT
"""The backend of `pip install .` and `pip wheel .` (PEP 517): CMake's install as a wheel (PEP 427).

It needs nothing but Python, CMake and a compiler. Where patchelf is, the wheel carries copies of the
libraries that it needs and is named for every Linux with the C library that it needs (PEP 600);
without, it is for the machine that made it. pyproject.toml says how scikit-build-core replaces it.
"""
import base64
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tomllib
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
CONFIG = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
PROJECT, SETTINGS = CONFIG["project"], CONFIG["tool"]["scikit-build"]
NAME = f"{PROJECT['name']}-{PROJECT['version']}"
PYTHON = f"cp{sys.version_info.major}{sys.version_info.minor}"
LIBRARIES = f"{PROJECT['name']}.libs"
# What every Linux has, as PEP 600 says.
SYSTEM = re.compile(r"(lib(c|m|dl|rt|pthread|gcc_s|stdc\+\+)|ld-linux.*)\.so\.\d+")


def run(*command):
    print("+", *command, file=sys.stderr, flush=True)
    subprocess.run([str(word) for word in command], check=True, stdout=sys.stderr)


def output(*command):
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True).stdout


def install(staging):
    """Builds, and installs into the folders `platlib` and `scripts` of `staging`."""
    build = ROOT / "build" / f"pip-{PYTHON}"
    defines = SETTINGS["cmake"]["define"] | {
        "Python_EXECUTABLE": sys.executable,
        "CMAKE_INSTALL_PREFIX": staging / "elsewhere",
        "SKBUILD": "2",
        "SKBUILD_PLATLIB_DIR": staging / "platlib",
        "SKBUILD_SCRIPTS_DIR": staging / "scripts",
    }
    options = [f"-D{key}={value}" for key, value in defines.items()] + ["-GNinja"] * bool(shutil.which("ninja"))
    run("cmake", "-S", ROOT, "-B", build, *options)
    # A compiler may take a gigabyte and a half.
    memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    jobs = max(1, min(len(os.sched_getaffinity(0)), memory // (1536 << 20)))
    run("cmake", "--build", build, "--parallel", jobs, "--target", *SETTINGS["build"]["targets"])
    for component in SETTINGS["install"]["components"]:
        run("cmake", "--install", build, "--strip", "--component", component)


def binaries(staging):
    return [path for path in staging.rglob("*") if path.is_file() and path.read_bytes()[:4] == b"\x7fELF"]


def bundle(staging):
    """Copies the libraries that the binaries need, and lets them find each other wherever pip puts them."""
    ours, found = binaries(staging), {}
    for path in ours:
        found.update(re.findall(r"^\s*(\S+) => (/\S+)", output("ldd", path), re.M))
    folder, renamed, licences = staging / "platlib" / LIBRARIES, [], staging / "licenses"
    for name, source in found.items():
        if SYSTEM.fullmatch(name):
            continue
        # A name of its own: another package may load another build of the same library.
        digest = hashlib.sha256(pathlib.Path(source).read_bytes()).hexdigest()[:8]
        stem, version = name.split(".so", 1)
        renamed += ["--replace-needed", name, f"{stem}-{digest}.so{version}"]
        folder.mkdir(parents=True, exist_ok=True)
        copy = shutil.copy(source, folder / renamed[-1])
        run("patchelf", "--set-soname", renamed[-1], "--set-rpath", "$ORIGIN", copy)
        # Debian knows the licence of what is its own.
        search = ["sh", "-c", 'dpkg -S "*/$0" 2>/dev/null', pathlib.Path(source).resolve().name]
        owner = subprocess.run(search, check=False, capture_output=True, text=True).stdout.split(":")[0]
        if owner:
            licences.mkdir(exist_ok=True)
            shutil.copy(f"/usr/share/doc/{owner}/copyright", licences / f"{owner}.txt")
    sites = [f"{lib}/python{sys.version_info.major}.{sys.version_info.minor}/{site}-packages"
             for lib in ("lib", "lib64") for site in ("site", "dist")]
    beside_bin = [f"$ORIGIN/../{site}/{LIBRARIES}" for site in ["lib/python3/dist-packages", *sites, "."]]
    for path in binaries(staging):
        run("patchelf", *renamed, path)
        if path in ours:
            scripts = path.is_relative_to(staging / "scripts")
            run("patchelf", "--set-rpath", ":".join(beside_bin) if scripts else f"$ORIGIN/../{LIBRARIES}", path)


def platform_tag(staging):
    versions = [v for path in binaries(staging) for v in re.findall(rb"GLIBC_2\.(\d+)", path.read_bytes())]
    return f"manylinux_2_{max(map(int, versions))}_{os.uname().machine}"


def metadata():
    lines = ["Metadata-Version: 2.1", f"Name: {PROJECT['name']}", f"Version: {PROJECT['version']}",
             f"Summary: {PROJECT['description']}", f"License: {PROJECT['license']['text']}",
             f"Requires-Python: {PROJECT['requires-python']}", f"Keywords: {','.join(PROJECT['keywords'])}",
             f"Author: {PROJECT['authors'][0]['name']}"]
    lines += [f"Classifier: {name}" for name in PROJECT["classifiers"]]
    lines += [f"Requires-Dist: {name}" for name in PROJECT["dependencies"]]
    return "\n".join(lines) + "\nDescription-Content-Type: text/markdown\n\n" + (ROOT / PROJECT["readme"]).read_text(encoding="utf-8")


def pack(staging, folder, platform):
    """Writes the wheel. Equal files make equal bytes. Returns its name."""
    tag, information = f"{PYTHON}-{PYTHON}-{platform}", f"{NAME}.dist-info"
    members = {}
    for kind, place in (("platlib", ""), ("scripts", f"{NAME}.data/scripts/"), ("licenses", f"{information}/licenses/")):
        for path in sorted((staging / kind).rglob("*")):
            if path.is_file():
                mode = 0o755 if os.access(path, os.X_OK) else 0o644
                members[place + str(path.relative_to(staging / kind))] = (path.read_bytes(), mode)
    for path in (ROOT / "LICENSE", ROOT / "tools/package/copyright"):
        members[f"{information}/licenses/{path.name}"] = (path.read_bytes(), 0o644)
    members[f"{information}/METADATA"] = (metadata().encode(), 0o644)
    wheel = f"Wheel-Version: 1.0\nGenerator: {__name__}\nRoot-Is-Purelib: false\nTag: {tag}\n"
    members[f"{information}/WHEEL"] = (wheel.encode(), 0o644)
    rows = []
    for name, (data, _) in members.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        rows.append(f"{name},sha256={digest},{len(data)}\n")
    members[f"{information}/RECORD"] = ("".join(rows + [f"{information}/RECORD,,\n"]).encode(), 0o644)
    with zipfile.ZipFile(pathlib.Path(folder) / f"{NAME}-{tag}.whl", "w", zipfile.ZIP_DEFLATED) as archive:
        for name, (data, mode) in members.items():
            member = zipfile.ZipInfo(name)
            member.external_attr, member.compress_type = (0o100000 | mode) << 16, zipfile.ZIP_DEFLATED
            archive.writestr(member, data)
    return f"{NAME}-{tag}.whl"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    staging = ROOT / "build" / f"pip-{PYTHON}-install"
    shutil.rmtree(staging, ignore_errors=True)
    install(staging)
    if not shutil.which("patchelf"):
        print("No patchelf: the wheel is for this machine alone.", file=sys.stderr)
        return pack(staging, wheel_directory, f"linux_{os.uname().machine}")
    bundle(staging)
    return pack(staging, wheel_directory, platform_tag(staging))


def build_sdist(sdist_directory, config_settings=None):
    archive = pathlib.Path(sdist_directory) / f"{NAME}.tar.gz"
    run("git", "-C", ROOT, "archive", f"--prefix={NAME}/", f"--add-virtual-file={NAME}/PKG-INFO:{metadata()}", "-o", archive, "HEAD")
    return archive.name
