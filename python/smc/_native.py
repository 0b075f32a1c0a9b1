# SPDX-License-Identifier: Apache-2.0
"""Loads libsmc and declares its functions from the header smc.h itself."""
from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any

import cffi

_PACKAGE = Path(__file__).resolve().parent


def _find(name: str, in_tree: str) -> Path:
    """A file of the package, or the one of the tree if the package is imported from there."""
    for path in (_PACKAGE / name, _PACKAGE.parent.parent / in_tree):
        if path.is_file():
            return path
    raise ImportError(f"smc is not installed: {name} is missing. Install it with: pip install ./python")


def _declarations(header: str) -> str:
    """The header without its preprocessor lines, and without what only C++ and the build of the library see."""
    lines, hidden = [], False
    for line in header.splitlines():
        if line.startswith("#"):
            hidden = line.startswith("#ifdef")
        elif not hidden:
            lines.append(line)
    return "\n".join(lines)


ffi: Any = cffi.FFI()
ffi.cdef(_declarations(_find("smc.h", "compiler/library/smc.h").read_text(encoding="utf-8")))

if sys.platform == "win32":
    _LIBRARY = ("smc.dll", "build/windows-x86_64/smc.dll" if sys.maxsize > 2**32 else "build/windows-i686/smc.dll")
else:
    _LIBRARY = ("libsmc.so", "build/lib/libsmc.so.1")

# SMC_LIBRARY: the path of another libsmc, for tests of one that is not installed.
lib: Any = ffi.dlopen(os.environ.get("SMC_LIBRARY") or str(_find(*_LIBRARY)))

if lib.smc_api_version() != 1:
    raise ImportError(f"this package needs libsmc with version 1 of its interface, not {lib.smc_api_version()}")


def text(pointer: Any) -> str:
    """A text of libsmc.  A byte that is not UTF-8, which only a name of the caller can contain, becomes U+FFFD."""
    raw: bytes = ffi.string(pointer)
    return raw.decode("utf-8", "replace")


def version() -> str:
    """The version of smc, such as "0.1.0"."""
    return text(lib.smc_version())
