# SPDX-License-Identifier: Apache-2.0
"""Compiled sources: their diagnostics, scripts, diagrams, reports and machines."""
from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path, PurePath
from types import TracebackType
from typing import Any, Callable, Iterable, Iterator, Mapping, Optional, Union

from ._native import ffi, lib, text
from ._session import Session
from .diagnostics import Diagnostic, read_diagnostics
from .errors import CompileError, Error, refuse_name
from .machine import Machine

Source = Union[str, "os.PathLike[str]", Mapping[str, str]]

_KINDS = {".sv": lib.SMC_KIND_SV, ".sm": lib.SMC_KIND_SM, ".ss": lib.SMC_KIND_SS, ".io": lib.SMC_KIND_IO,
          ".rq": lib.SMC_KIND_RQ}
_ENGINES = {"vm": lib.SMC_ENGINE_VM, "ref": lib.SMC_ENGINE_REF, "vm-soft": lib.SMC_ENGINE_VM_SOFT}
_OUTCOMES = {0: "none", 1: "passed", 2: "failed", 3: "endless", 4: "time over", 5: "broken", 6: "different"}
_DIAGRAMS = {"svg": lib.SMC_DIAGRAM_SVG, "dot": lib.SMC_DIAGRAM_DOT, "mermaid": lib.SMC_DIAGRAM_MERMAID}
_REPORTS = {"html": lib.SMC_REPORT_HTML, "text": lib.SMC_REPORT_TEXT, "json": lib.SMC_REPORT_JSON}
_RENDERS = {"text": lib.SMC_RENDER_TEXT, "color": lib.SMC_RENDER_COLOR, "json": lib.SMC_RENDER_JSON, "sarif": lib.SMC_RENDER_SARIF}
_EMITS = {"image": lib.SMC_EMIT_IMAGE, "array": lib.SMC_EMIT_ARRAY, "c": lib.SMC_EMIT_C}


@dataclass(frozen=True)
class ScriptResult:
    """What a script did.  It is true if the script passed."""

    name: str
    outcome: str                  # "passed", "failed", "endless", "time over", "broken" or "different"
    steps: int
    asserts: int                  # how many passed
    report: str                   # as smc test prints it
    trace: str                    # CSV with a row for each step, as of smc test --trace; "" unless asked for
    diagnostics: tuple[Diagnostic, ...]

    def __bool__(self) -> bool:
        return self.outcome == "passed"


def _choose(what: str, name: str, table: Mapping[str, Any]) -> Any:
    if name not in table:
        refuse_name(what, name, table)
    return table[name]


def _read_sources(sources: Iterable[Source]) -> Iterator[tuple[str, bytes]]:
    """Pairs of a name and a text.  A string or path is a file; a mapping has texts by their names."""
    for source in sources:
        if isinstance(source, Mapping):
            yield from ((str(name), contents.encode()) for name, contents in source.items())
        else:
            yield os.fspath(source), Path(source).read_bytes()


def _kind_of(name: str) -> int:
    kind = _KINDS.get(PurePath(name).suffix)
    if kind is None:
        raise Error(f"'{name}' is no source: its name ends with none of {', '.join(_KINDS)}")
    return int(kind)


class Program:
    """Sources that have been compiled together.  `smc.compile` makes one.

    Threads can share a program: their calls take turns.  To run machines at the same time, give each thread a program of its own.
    """

    def __init__(self, sources: Iterable[Source], warnings: Iterable[str], level: int) -> None:
        self._session = Session()
        self._numbers: dict[str, int] = {}
        s = self._session
        s.check(lib.smc_option_set(s.pointer, lib.SMC_OPTION_LEVEL, level))
        s.check(lib.smc_option_set(s.pointer, lib.SMC_OPTION_REVIEW, 1))
        for word in warnings:
            s.check(lib.smc_warning_select(s.pointer, word.encode()))
        self._compile(sources)

    # ---- compiling ----

    def _compile(self, sources: Iterable[Source]) -> None:
        s = self._session
        with s.lock:
            for name, contents in _read_sources(sources):
                if name in self._numbers:
                    s.check(lib.smc_source_replace(s.pointer, self._numbers[name], contents, len(contents)))
                else:
                    number = ffi.new("uint32_t *")
                    s.check(lib.smc_source_add(s.pointer, _kind_of(name), name.encode(), contents, len(contents), number))
                    self._numbers[name] = number[0]
            result = lib.smc_compile(s.pointer)
            if result == lib.SMC_E_SOURCE:
                raise CompileError(self.render(), self.diagnostics, result)
            s.check(result)

    def recompile(self, *sources: Source) -> None:
        """Replaces the sources of these names, adds those with other names, and compiles again.

        Open machines continue to run as they were compiled.  `Machine.continue_from` lets a new one continue where an old one is.
        """
        self._compile(sources)

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """The diagnostics of compiling and of the scripts that have run, then the warnings that an @allow covers."""
        with self._session.lock:
            return read_diagnostics(self._session)

    @property
    def warnings(self) -> tuple[Diagnostic, ...]:
        """The warnings that no @allow covers."""
        return tuple(d for d in self.diagnostics if d.severity == "warning" and not d.allowed)

    def render(self, form: str = "text") -> str:
        """All diagnostics as smc prints them: "text", "color", "json" or "sarif"."""
        return self._stored_text(lib.smc_render, _choose("form", form, _RENDERS))

    def emit(self, what: str = "c") -> dict[str, bytes]:
        """Generates the files of smc build: "c", "image" or "array".  Returns their contents by their names."""
        s = self._session
        with s.lock:
            s.check(lib.smc_emit(s.pointer, _choose("output", what, _EMITS)))
            files: dict[str, bytes] = {}
            for i in range(lib.smc_output_count(s.pointer)):
                at, size = ffi.new("const void **"), ffi.new("uint64_t *")
                s.check(lib.smc_output(s.pointer, i, at, size))
                files[text(lib.smc_output_name(s.pointer, i))] = bytes(ffi.buffer(at[0], size[0]))
            return files

    # ---- names ----

    def _names(self, suffix: str) -> dict[str, int]:
        """Numbers of the sources of a kind, by their names without folders and suffix, and by their full names."""
        of_kind = {name: number for name, number in self._numbers.items() if PurePath(name).suffix == suffix}
        return {**{PurePath(name).stem: number for name, number in of_kind.items()}, **of_kind}

    def _find(self, what: str, name: Optional[str], suffix: str) -> int:
        names = self._names(suffix)
        if name is not None:
            return int(_choose(what, name, names))
        if len(set(names.values())) != 1:
            raise Error(f"the program has {len(set(names.values()))} {what}s: name one of them")
        return next(iter(names.values()))

    @property
    def machines(self) -> tuple[str, ...]:
        """The names of the machines, which are those of their files without the suffix."""
        return tuple(PurePath(name).stem for name in self._numbers if PurePath(name).suffix == ".sm")

    @property
    def scripts(self) -> tuple[str, ...]:
        """The names of the scripts, which are those of their files without the suffix."""
        return tuple(PurePath(name).stem for name in self._numbers if PurePath(name).suffix == ".ss")

    # ---- machines, scripts, pages ----

    def machine(self, name: Optional[str] = None, *, dt: int = 1) -> Machine:
        """Starts a machine in its first state.  `name` can be omitted if there is only one.  `dt`: by how much G advances in a step."""
        with self._session.lock:
            return Machine(self._session, self._find("machine", name, ".sm"), dt)

    def run_script(self, name: Optional[str] = None, *, engines: Iterable[str] = ("vm",), max_steps: int = 0, trace: bool = False) -> ScriptResult:
        """Runs a script on one or several engines in lock step: "vm", "ref", "vm-soft".  `max_steps` 0: 1,000,000."""
        s = self._session
        with s.lock:
            script = self._find("script", name, ".ss")
            s.check(lib.smc_option_set(s.pointer, lib.SMC_OPTION_TRACE, int(trace)))
            result = lib.smc_run(s.pointer, script, sum({_choose("engine", e, _ENGINES) for e in engines}), max_steps)
            if result not in (lib.SMC_OK, lib.SMC_E_FAILED):
                s.check(result)
            full_name = text(lib.smc_source_name(s.pointer, script))
            return ScriptResult(
                name=PurePath(full_name).stem,
                outcome=_OUTCOMES.get(lib.smc_run_outcome(s.pointer, script), "broken"),
                steps=lib.smc_run_steps(s.pointer, script),
                asserts=lib.smc_run_asserts(s.pointer, script),
                report=text(lib.smc_run_report(s.pointer, script)),
                trace=text(lib.smc_run_trace(s.pointer, script)) if trace else "",
                diagnostics=tuple(d for d in read_diagnostics(s) if d.place is not None and d.place.source == full_name),
            )

    def run_scripts(self, **options: Any) -> tuple[ScriptResult, ...]:
        """Runs every script with the options of `run_script`."""
        return tuple(self.run_script(name, **options) for name in self.scripts)

    def diagram(self, form: str = "svg", machine: Optional[str] = None) -> str:
        """The state diagram: "svg", "dot" or "mermaid", with the counts of the scripts that have run."""
        return self._stored_text(lib.smc_diagram, self._find("machine", machine, ".sm"), _choose("form", form, _DIAGRAMS))

    def report(self, form: str = "html", machine: Optional[str] = None) -> str:
        """The page for a design review: "html", "text" or "json".  It runs the scripts that have not run."""
        return self._stored_text(lib.smc_report, self._find("machine", machine, ".sm"), _choose("form", form, _REPORTS))

    def _stored_text(self, function: Callable[..., int], *arguments: int) -> str:
        s = self._session
        with s.lock:
            at, size = ffi.new("const char **"), ffi.new("uint64_t *")
            s.check(function(s.pointer, *arguments, at, size))
            return bytes(ffi.buffer(at[0], size[0])).decode("utf-8", "replace")

    # ---- closing ----

    def cancel(self) -> None:
        """Ends the call of another thread that compiles or runs something now; it raises an Error.  If none runs, the next one does."""
        lib.smc_cancel(self._session.pointer, 1)

    def close(self) -> None:
        """Closes the program and its machines, and frees their memory.  Closing it again does nothing."""
        self._session.close()

    def __enter__(self) -> Program:
        return self

    def __exit__(self, kind: Optional[type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<smc.Program {', '.join(self._numbers)}{'' if self._session.is_open else ' (closed)'}>"


def compile(*sources: Source, warnings: Iterable[str] = (), level: int = 2) -> Program:
    """Compiles sources, and returns the program.

    A string or a path is the path of a file; a dictionary has texts by their names.  Names end with .sv, .sm, .ss or .io.
    `warnings` selects warnings like the option -W does: "flight", "no-dead-code", "error=output-left-on".  `level`: of optimisation.
    Raises CompileError if the sources have errors.
    """
    return Program(sources, warnings, level)


def explain(code: str) -> str:
    """The page of a diagnostic, by its code or its name; "" if no diagnostic has it."""
    return text(lib.smc_explain(code.encode()))
