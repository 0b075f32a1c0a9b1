# SPDX-License-Identifier: Apache-2.0
"""A session of libsmc, which one thread at a time can use."""
from __future__ import annotations

import threading
import weakref
from typing import Any

from ._native import ffi, lib, text
from .errors import ClosedError, Error


def _close(pointer: Any) -> None:
    lib.smc_close(pointer)


class Session:
    """Owns an SmcSession.  `lock` is held during each call, and until the texts that it stores have been copied."""

    def __init__(self) -> None:
        opened = ffi.new("SmcSession **")
        if lib.smc_open(ffi.NULL, 0, opened) != lib.SMC_OK:
            raise MemoryError("there is no memory for a session of libsmc")
        self._pointer = opened[0]
        self._finalizer = weakref.finalize(self, _close, self._pointer)
        self.lock = threading.RLock()

    @property
    def pointer(self) -> Any:
        if not self._finalizer.alive:
            raise ClosedError("the program has been closed")
        return self._pointer

    @property
    def is_open(self) -> bool:
        return self._finalizer.alive

    def error(self, result: int) -> Error:
        """The exception for a result.  Call it before any other function of the session."""
        return Error(text(lib.smc_error_text(self.pointer)), result)

    def check(self, result: int) -> None:
        if result == lib.SMC_E_MEMORY:
            raise MemoryError("libsmc is out of memory")
        if result != lib.SMC_OK:
            raise self.error(result)

    def close(self) -> None:
        with self.lock:
            self._finalizer()
