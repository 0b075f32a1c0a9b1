# SPDX-License-Identifier: Apache-2.0
"""What this package raises.  Every exception of it is an `smc.Error`."""
from __future__ import annotations

import difflib
from typing import TYPE_CHECKING, Iterable, NoReturn

if TYPE_CHECKING:
    from .diagnostics import Diagnostic
    from .runs import Run


class Error(Exception):
    """A call of libsmc failed.  `result` is its SMC_E_ number, or 0."""

    def __init__(self, message: str, result: int = 0) -> None:
        super().__init__(message)
        self.result = result


class CompileError(Error):
    """The sources have errors.  The message shows them as `smc check` does, with the characters underlined.

    `diagnostics` are the errors and warnings as data.
    """

    def __init__(self, message: str, diagnostics: tuple[Diagnostic, ...], result: int) -> None:
        super().__init__(message, result)
        self.diagnostics = diagnostics


class UnknownName(Error, LookupError, AttributeError):
    """There is no variable, state, machine or script of this name.  The message proposes the nearest ones."""


class ClosedError(Error, ValueError):
    """The program or machine has been closed."""


class RunError(Error):
    """A run on columns ended early.  `row` is the row that failed; `run` has the complete rows before it."""

    def __init__(self, message: str, result: int, row: int, run: Run) -> None:
        super().__init__(message, result)
        self.row = row
        self.run = run


def refuse_name(what: str, name: str, names: Iterable[str]) -> NoReturn:
    """Raises UnknownName with the names that are most similar to `name`, or else with all names."""
    all_names = sorted(names)
    near = difflib.get_close_matches(name, all_names, 3, 0.6)
    folded = [n for n in all_names if n.casefold() == name.casefold()]
    near = folded + [n for n in near if n not in folded]
    if near:
        hint = "did you mean " + " or ".join(f"'{n}'" for n in near) + "?"
    else:
        hint = "there are: " + ", ".join(all_names) if all_names else "there are none"
    raise UnknownName(f"no {what} is named '{name}'; {hint}")
