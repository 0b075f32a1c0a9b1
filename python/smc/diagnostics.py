# SPDX-License-Identifier: Apache-2.0
"""Diagnostics as data."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Optional

from ._native import lib, text
from ._session import Session


@dataclass(frozen=True)
class Place:
    """Characters of a source.  Lines and columns count from 1, in bytes; the end is after the last character."""

    source: str
    line: int
    column: int
    end_line: int
    end_column: int
    offset: int
    length: int


@dataclass(frozen=True)
class Note:
    """A sentence that belongs to a diagnostic.  `step` above 0: its position on the path that leads to the finding."""

    message: str
    step: int
    place: Optional[Place]


@dataclass(frozen=True)
class Edit:
    """Replaces the characters at `place` by `text`.  All edits of a diagnostic belong together."""

    text: str
    place: Optional[Place]


@dataclass(frozen=True)
class Diagnostic:
    """An error, a warning or a note of the compiler."""

    severity: str                 # "error", "warning" or "note"
    code: str                     # "E0204"
    warning: str                  # the name after -W: "unused-element"; "" for an error
    message: str
    label: str                    # what text output prints beside the underlined characters; or ""
    allowed: str                  # the reason of the @allow that covers the warning; or ""
    place: Optional[Place]        # None: it is about no source
    notes: tuple[Note, ...]
    edits: tuple[Edit, ...]

    @property
    def is_error(self) -> bool:
        return self.severity == "error"

    def __str__(self) -> str:
        where = f"{self.place.source}:{self.place.line}:{self.place.column}: " if self.place else ""
        return f"{where}{self.severity}: {self.message} [{self.warning or self.code}]"


_SEVERITIES = {0: "error", 1: "warning", 2: "note"}


def _read_place(s: Session, diag: int, part: int, item: int) -> Optional[Place]:
    numbers = [lib.smc_diag_place(s.pointer, diag, part, item, what, lib.SMC_COLUMN_BYTES) for what in range(7)]
    if numbers[0] < 0:
        return None
    return Place(text(lib.smc_source_name(s.pointer, numbers[0])), *numbers[1:])


def _read_diagnostic(s: Session, i: int) -> Diagnostic:
    p = s.pointer
    notes = tuple(
        Note(text(lib.smc_diag_note(p, i, k)), lib.smc_diag_note_step(p, i, k), _read_place(s, i, lib.SMC_PART_NOTE, k))
        for k in range(lib.smc_diag_note_count(p, i))
    )
    edits = tuple(Edit(text(lib.smc_diag_edit(p, i, k)), _read_place(s, i, lib.SMC_PART_EDIT, k)) for k in range(lib.smc_diag_edit_count(p, i)))
    return Diagnostic(
        severity=_SEVERITIES.get(lib.smc_diag_severity(p, i), "note"),
        code=text(lib.smc_diag_code(p, i)),
        warning=text(lib.smc_diag_warning(p, i)),
        message=text(lib.smc_diag_message(p, i)),
        label=text(lib.smc_diag_label(p, i)),
        allowed=text(lib.smc_diag_allowed(p, i)),
        place=_read_place(s, i, lib.SMC_PART_DIAG, 0),
        notes=notes,
        edits=edits,
    )


def read_diagnostics(s: Session) -> tuple[Diagnostic, ...]:
    """The diagnostics of a session, then the warnings that an @allow covers."""
    count = lib.smc_diag_count(s.pointer) + lib.smc_diag_allowed_count(s.pointer)
    return tuple(_read_diagnostic(s, i) for i in range(count))
