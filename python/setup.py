# SPDX-License-Identifier: Apache-2.0
"""Builds libsmc with make and cc, and puts it into the package.

The sources of libsmc are the tree above this folder.  A source distribution contains them in the folder `tree`.
SMC_WINDOWS=x86_64 or i686 makes a wheel for Windows instead, by MinGW-w64.
"""
import os
import re
import shutil
import subprocess
from pathlib import Path

from setuptools import setup
from setuptools.command.build_py import build_py
from setuptools.command.sdist import sdist
from setuptools.dist import Distribution

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:                                   # before setuptools 70
    from wheel.bdist_wheel import bdist_wheel

HERE = Path(__file__).resolve().parent
PARTS = ["Makefile", "LICENSE", "compiler", "stdlib", "bytecode-vm", "runtime-c", "tests/tests.mk"]


def tree() -> Path:
    for root in (HERE / "tree", HERE.parent):
        if (root / "compiler/library/smc.h").is_file():
            return root
    raise SystemExit("smc: the sources of libsmc are missing: install from the folder python/ of the whole tree, with pip 21.3 or later")


def number_in(path: str, pattern: str) -> str:
    found = re.search(pattern, (tree() / path).read_text())
    if not found:
        raise SystemExit(f"smc: {path} has no version")
    return found.group(1)


WINDOWS = os.environ.get("SMC_WINDOWS", "")
WINDOWS_TAGS = {"x86_64": "win_amd64", "i686": "win32"}
if WINDOWS and WINDOWS not in WINDOWS_TAGS:
    raise SystemExit(f"smc: SMC_WINDOWS is x86_64 or i686, not {WINDOWS}")


def build_library() -> Path:
    """Runs make and returns the path of the library.  B is the folder of the objects, as in the Makefile."""
    folder = os.environ.get("B", "build")
    version = number_in("compiler/library/smc.h", r"#define SMC_API_VERSION (\d+)")
    target = f"windows-{WINDOWS}" if WINDOWS else f"{folder}/lib/libsmc.so.{version}"
    subprocess.run(["make", "-s", f"-j{os.cpu_count() or 1}", f"B={folder}", target], cwd=tree(), check=True)
    return tree() / (f"{folder}/windows-{WINDOWS}/smc.dll" if WINDOWS else target)


class BuildPy(build_py):
    def run(self) -> None:
        super().run()
        package = Path(self.build_lib) / "smc"
        package.mkdir(parents=True, exist_ok=True)
        for library in ("libsmc.so", "smc.dll"):      # what an earlier build for another system left
            (package / library).unlink(missing_ok=True)
        shutil.copyfile(build_library(), package / ("smc.dll" if WINDOWS else "libsmc.so"))
        shutil.copyfile(tree() / "compiler/library/smc.h", package / "smc.h")


class Sdist(sdist):
    def make_release_tree(self, base_dir: str, files: "list[str]") -> None:
        super().make_release_tree(base_dir, files)
        for part in PARTS:
            source, to = tree() / part, Path(base_dir) / "tree" / part
            to.parent.mkdir(parents=True, exist_ok=True)
            if source.is_dir():
                shutil.copytree(source, to, dirs_exist_ok=True)
            else:
                shutil.copyfile(source, to)


class Wheel(bdist_wheel):
    """A wheel for every Python 3 of one platform: the library does not use the API of Python."""

    def get_tag(self) -> "tuple[str, str, str]":
        return "py3", "none", WINDOWS_TAGS[WINDOWS] if WINDOWS else super().get_tag()[2]


class Binary(Distribution):
    def has_ext_modules(self) -> bool:
        return True


setup(
    version=number_in("compiler/version.h", r'SMC_VERSION "(.*)"'),
    cmdclass={"build_py": BuildPy, "sdist": Sdist, "bdist_wheel": Wheel},
    distclass=Binary,
)
