# SPDX-License-Identifier: Apache-2.0
"""Machines that run on the VM, step by step or on columns."""
from __future__ import annotations

import math
import struct
from types import TracebackType
from typing import TYPE_CHECKING, Any, Iterable, Iterator, Mapping, Optional, Union

import numpy as np

from ._native import ffi, lib, text
from ._session import Session
from .errors import ClosedError, Error, RunError, refuse_name
from .runs import Column, Run

if TYPE_CHECKING:
    import pandas

Value = Union[bool, int, float]

# The types by their numbers in libsmc: the format of struct, and that of numpy.
_FORMATS = ("b", "h", "i", "q", "B", "H", "I", "Q", "f", "d", "?")
_DTYPES = ("i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", "f4", "f8", "?")
_ROWS_PER_CALL = 1 << 20          # of a run: after so many rows, Python handles signals such as Ctrl-C


class Variable:
    """An element of the state vector, or a local."""

    __slots__ = ("name", "number", "type", "is_element")

    def __init__(self, name: str, number: int, type: int, is_element: bool) -> None:
        self.name = name
        self.number = number
        self.type = type
        self.is_element = is_element

    @property
    def is_integer(self) -> bool:
        last: int = lib.SMC_TYPE_U64
        return self.type <= last

    @property
    def dtype(self) -> "np.dtype[Any]":
        return np.dtype(_DTYPES[self.type])


class Values(Mapping[str, Value]):
    """Values of variables as they were when they were read: `v.valveOpen` or `v["valveOpen"]`."""

    __slots__ = ("_values",)
    _values: dict[str, Value]

    def __init__(self, values: dict[str, Value]) -> None:
        object.__setattr__(self, "_values", values)

    def __getitem__(self, name: str) -> Value:
        if name not in self._values:
            refuse_name("variable", name, self._values)
        return self._values[name]

    def __getattr__(self, name: str) -> Value:
        if name.startswith("__"):
            raise AttributeError(name)
        return self[name]

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("these values are a copy: set those of the machine, as in machine['x'] = 1")

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __repr__(self) -> str:
        return "Values(" + ", ".join(f"{name}={value!r}" for name, value in self._values.items()) + ")"


class Machine:
    """A machine with a state vector of its own.  `Program.machine` starts one.

    `machine["x"]` reads and `machine["x"] = 1` writes a variable.  `step` runs one step, `run` a whole run.
    """

    def __init__(self, session: Session, source: int, dt: int) -> None:
        opened = ffi.new("SmcMachine *")
        self._session = session
        session.check(lib.smc_machine_open(session.pointer, source, opened))
        self._handle: Optional[int] = opened[0]
        self._name = text(lib.smc_source_name(session.pointer, source))
        self._states = tuple(self._text_of(lib.smc_machine_state_name, 1 + i) for i in range(lib.smc_machine_state_count(*self._own())))
        self._variables = {v.name: v for v in self._list_variables()}
        self._time_element = next(v for v in self._variables.values() if self._is_time(v))
        self._next: int = 0
        self.dt = dt

    # ---- the session ----

    def _own(self) -> tuple[Any, int]:
        """The first two arguments of every function of machines."""
        if self._handle is None:
            raise ClosedError("the machine has been closed")
        return self._session.pointer, self._handle

    def _text_of(self, function: Any, number: int) -> str:
        return text(function(*self._own(), number))

    def _list_variables(self) -> Iterator[Variable]:
        for i in range(lib.smc_machine_variable_count(*self._own())):
            kind = lib.smc_machine_variable_kind(*self._own(), i)
            yield Variable(self._text_of(lib.smc_machine_variable_name, i), i, lib.smc_machine_variable_type(*self._own(), i), kind == lib.SMC_VARIABLE_ELEMENT)

    def _is_time(self, v: Variable) -> bool:
        """Whether a variable is G: smc_machine_run accepts any other one as an input."""
        if not v.is_element or v.type != lib.SMC_TYPE_U64:
            return False
        columns = ffi.new("double *[]", 1)
        done = ffi.new("uint64_t *")
        result = lib.smc_machine_run(*self._own(), 0, ffi.NULL, 1, ffi.new("uint32_t[]", [v.number]), columns, 0, ffi.NULL, ffi.NULL, ffi.NULL, done)
        return bool(result == lib.SMC_E_ARGUMENT)

    def _find(self, name: str) -> Variable:
        v = self._variables.get(name)
        if v is None:
            refuse_name("variable", name, self._variables)
        return v

    # ---- variables ----

    def _get(self, v: Variable) -> Value:
        if v.is_integer:
            size = struct.calcsize(_FORMATS[v.type])
            stored = ffi.new("char[]", size)
            self._session.check(lib.smc_machine_read(*self._own(), v.number, stored, size))
            return int(struct.unpack(_FORMATS[v.type], ffi.buffer(stored, size))[0])
        value = ffi.new("double *")
        self._session.check(lib.smc_machine_get(*self._own(), v.number, value))
        return bool(value[0]) if v.type == lib.SMC_TYPE_BOOL else float(value[0])

    def _set(self, v: Variable, value: Value) -> None:
        if v.is_integer and isinstance(value, int):      # exact, also above 2^53
            info = np.iinfo(v.dtype)
            data = struct.pack(_FORMATS[v.type], min(max(int(value), int(info.min)), int(info.max)))
            self._session.check(lib.smc_machine_write(*self._own(), v.number, data, len(data)))
        else:
            self._session.check(lib.smc_machine_set(*self._own(), v.number, float(value)))

    def __getitem__(self, name: str) -> Value:
        with self._session.lock:
            return self._get(self._find(name))

    def __setitem__(self, name: str, value: Value) -> None:
        with self._session.lock:
            self._set(self._find(name), value)

    @property
    def elements(self) -> Values:
        """The elements of the state vector that the machine lists."""
        return self._values(True)

    @property
    def locals(self) -> Values:
        """The locals of the machine, without constants."""
        return self._values(False)

    def _values(self, are_elements: bool) -> Values:
        with self._session.lock:
            return Values({v.name: self._get(v) for v in self._variables.values() if v.is_element == are_elements})

    # ---- states and time ----

    @property
    def name(self) -> str:
        return self._name

    @property
    def states(self) -> tuple[str, ...]:
        """The names of the states; the first one is where the machine starts."""
        return self._states

    @property
    def state(self) -> str:
        """The state that the next step runs."""
        with self._session.lock:
            number: int = lib.smc_machine_state(*self._own())
            return self._states[number - 1]

    @property
    def time(self) -> int:
        """T: the time since the first step of the current state, in the unit of G."""
        with self._session.lock:
            return int(lib.smc_machine_time(*self._own()))

    @property
    def next_g(self) -> int:
        """G of the next step, unless that is passed to it."""
        return self._next

    def reset(self, state: Optional[str] = None, **inputs: Value) -> None:
        """Starts the machine again: elements are zero, locals have their initial values, and windows are empty.  G starts at 0.

        Then stores `inputs`.  `state`: the name of the first state.
        """
        if state is not None and state not in self._states:
            refuse_name("state", state, self._states)
        with self._session.lock:
            named = [(self._find(name), value) for name, value in inputs.items()]
            self._session.check(lib.smc_machine_start(*self._own(), 1 + self._states.index(state) if state is not None else 1))
            self._next = 0
            for v, value in named:
                self._set(v, value)

    # ---- running ----

    def step(self, g: Optional[int] = None, /, **inputs: Value) -> Values:
        """Stores the inputs in variables of these names, runs a step, and returns the elements after it.

        `g`: the time of the step.  If it is omitted, the first step has G = 0, and each other one advances G by `dt`.
        """
        with self._session.lock:
            named = [(self._find(name), value) for name, value in inputs.items()]
            for v, value in named:
                if v is self._time_element:
                    raise Error(f"'{v.name}' is G: pass the time as the first argument")
                self._set(v, value)
            now = self._next if g is None else int(g)
            if not 0 <= now < 1 << 64:
                raise Error(f"G cannot be {now}: it is a U64")
            self._session.check(lib.smc_machine_step(*self._own(), now))
            self._next = now + self.dt
            return self._values(True)

    def run(
        self,
        columns: Union[Mapping[str, Any], "pandas.DataFrame"],
        *,
        g: Optional[Any] = None,
        dt: Optional[int] = None,
        record: Optional[Iterable[str]] = None,
        ignore_unknown: bool = False,
    ) -> Run:
        """Runs a step for each row of the columns, from the current state of the machine.

        `columns`: a dictionary of arrays, or a pandas frame.  Before a step, the values of its row are stored in the variables of these names.
        `g`: G of each step.  If it is omitted, it is the column of this name, or else it advances by `dt`, or by that of the machine.
        `record`: names of the variables that are recorded after each step; by default all elements that are not columns.
        `ignore_unknown`: columns whose names are not those of variables are ignored, rather than refused.
        """
        given = self._select_columns(columns, ignore_unknown)
        rows = self._count_rows(given, g)
        time = self._times(rows, given.pop(self._time_element.name, None) if g is None else g, dt)
        if self._time_element.name in given:
            raise Error(f"the column '{self._time_element.name}' is G, which is also passed as an argument")
        if record is None:
            recorded = [v for v in self._variables.values() if v.is_element and v.name not in given and v is not self._time_element]
        else:
            recorded = [self._find(name) for name in record]
        inputs = [(self._find(name), _as_column(name, values, rows)) for name, values in given.items()]
        return self._run_columns(time, inputs, [(v, np.zeros(rows)) for v in recorded])

    def _select_columns(self, columns: Union[Mapping[str, Any], "pandas.DataFrame"], ignore_unknown: bool) -> dict[str, Any]:
        selected: dict[str, Any] = {}
        for name in columns.keys():
            if name in self._variables:
                selected[name] = columns[name]
            elif not ignore_unknown:
                refuse_name("variable", str(name), self._variables)
        return selected

    @staticmethod
    def _count_rows(given: Mapping[str, Any], g: Optional[Any]) -> int:
        lengths = {len(values) for values in given.values() if not np.isscalar(values)} | ({len(g)} if g is not None else set())
        if len(lengths) != 1:
            raise Error("the columns have different lengths" if lengths else "a run needs a column with a row for each step")
        return lengths.pop()

    def _times(self, rows: int, g: Optional[Any], dt: Optional[int]) -> Column:
        if g is None:
            step = self.dt if dt is None else dt
            if step < 1 or self._next + rows * step >= 1 << 64:
                raise Error(f"G cannot advance by {step} for {rows} steps")
            times: Column = np.uint64(self._next) + np.arange(rows, dtype=np.uint64) * np.uint64(step)
            return times
        times = np.asarray(g)
        if times.dtype.kind == "f":
            if not np.all((times == np.floor(times)) & (times >= 0) & (times < 2.0**64)):
                raise Error("G of each step has to be a whole number from 0 on: convert the unit of the column first")
        elif times.dtype.kind not in "iu" or (times.dtype.kind == "i" and np.any(times < 0)):
            raise Error("G of each step has to be a whole number from 0 on")
        return np.ascontiguousarray(times, dtype=np.uint64)

    def _run_columns(self, g: Column, inputs: list[tuple[Variable, Column]], outputs: list[tuple[Variable, Column]]) -> Run:
        states = np.zeros(len(g), dtype=np.uint32)
        done = ffi.new("uint64_t *")
        numbers = [ffi.new("uint32_t[]", [v.number for v, _ in columns]) for columns in (inputs, outputs)]
        row, result = 0, lib.SMC_OK
        with self._session.lock:
            while row < len(g) and result == lib.SMC_OK:
                rows = min(_ROWS_PER_CALL, len(g) - row)
                arrays = [ffi.new("double *[]", [_pointer("double *", c, row) for _, c in columns]) for columns in (inputs, outputs)]
                result = lib.smc_machine_run(
                    *self._own(), rows, _pointer("uint64_t *", g, row), len(inputs), numbers[0], arrays[0], len(outputs), numbers[1], arrays[1],
                    _pointer("uint32_t *", states, row), done,
                )  # fmt: skip
                row += done[0]
            error = self._session.error(result) if result != lib.SMC_OK else None
            if row > 0:
                self._next = int(g[row - 1]) + self.dt
        recorded = {v.name: c[:row] for v, c in inputs} | {v.name: _typed(v, c[:row]) for v, c in outputs}
        run = Run(self._time_element.name, g[:row], states[:row], self._states, recorded, frozenset(v.name for v, _ in inputs))
        if error is not None:
            raise RunError(f"row {row}: {error}", result, row, run)
        return run

    # ---- replacing and closing ----

    def continue_from(self, old: Machine) -> None:
        """Continues where `old` is: takes over its state vector, and the state, T, locals and samples that both have by name.

        Both belong to one program, which can have been compiled again in between (`Program.recompile`).  `old` does not change.
        """
        if old._session is not self._session:
            raise Error("both machines have to belong to one program: compile the new sources with Program.recompile")
        with self._session.lock:
            self._session.check(lib.smc_machine_continue(self._session.pointer, old._own()[1], self._own()[1]))
            self._next = old._next

    def close(self) -> None:
        """Closes the machine.  Closing it again does nothing."""
        with self._session.lock:
            if self._handle is not None and self._session.is_open:
                lib.smc_machine_close(*self._own())
            self._handle = None

    def __enter__(self) -> Machine:
        return self

    def __exit__(self, kind: Optional[type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]) -> None:
        self.close()

    def __repr__(self) -> str:
        is_open = self._handle is not None and self._session.is_open
        return f"<smc.Machine {self._name} in {self.state}>" if is_open else f"<smc.Machine {self._name} (closed)>"


def _as_column(name: str, values: Any, rows: int) -> Column:
    """A contiguous array of doubles.  One number is the value of every row."""
    try:
        column = np.ascontiguousarray(np.broadcast_to(np.asarray(values, dtype=np.float64), rows) if np.isscalar(values) else values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise Error(f"the column '{name}' has values that are no numbers: {error}") from None
    if column.ndim != 1:
        raise Error(f"the column '{name}' has {column.ndim} dimensions instead of one")
    return column


def _pointer(type: str, column: Column, row: int) -> Any:
    return ffi.cast(type, column.ctypes.data + row * column.itemsize)


def _typed(v: Variable, column: Column) -> Column:
    """The column in the type of its variable.  A 64-bit integer at its limit may be rounded to 2^63 or 2^64, so it is clamped."""
    if v.dtype.itemsize == 8 and v.is_integer:
        limit = math.nextafter(float(np.iinfo(v.dtype).max) + 1, 0)
        column = np.minimum(column, limit)
    return column.astype(v.dtype)
