# SPDX-License-Identifier: MIT
"""Prints the folder under a prefix in which this Python looks for packages, relative to the prefix.

Debian's python3 looks into lib/python3/dist-packages under /usr, and into lib/python3.11/dist-packages
under /usr/local. A prefix where it looks nowhere gets the first of them: add it to PYTHONPATH.
"""
import os
import site
import sys

prefix = os.path.realpath(sys.argv[1])
packages = [os.path.realpath(folder) for folder in site.getsitepackages() + sys.path]
under = [
    os.path.relpath(folder, prefix)
    for folder in packages
    if os.path.basename(folder) in ("dist-packages", "site-packages")
    and os.path.relpath(folder, prefix).startswith("lib/python3")
]
print(under[0] if under else "lib/python3/dist-packages")
