# SPDX-License-Identifier: Apache-2.0
"""What a whole run recorded."""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Iterator, Mapping, Optional

import numpy as np
import numpy.typing as npt

from .errors import Error, refuse_name

if TYPE_CHECKING:
    import pandas

Column = npt.NDArray[Any]


@dataclass(frozen=True)
class Transition:
    """After the step at `row`, when G was `g`, the machine was in state `target`."""

    row: int
    g: int
    source: str
    target: str


class Run(Mapping[str, Column]):
    """Columns with one value for each step: `run["valveOpen"]`.  `frame()` is a pandas frame, `plot()` a figure."""

    def __init__(self, time_name: str, g: Column, state: Column, state_names: tuple[str, ...], columns: dict[str, Column], inputs: frozenset[str]) -> None:
        self.g = g                            # uint64: G of each step
        self.state = state                    # uint32: the number of the state after each step, from 1
        self.state_names = state_names        # names[i] is that of state i + 1
        self.inputs = inputs
        self._time_name = time_name
        self._columns = columns

    def __getitem__(self, name: str) -> Column:
        if name not in self._columns:
            refuse_name("column", name, self._columns)
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    @property
    def rows(self) -> int:
        return len(self.g)

    @property
    def states(self) -> Column:
        """The name of the state after each step."""
        names: Column = np.array(self.state_names) if self.rows else np.array([], dtype=str)
        return np.take(names, self.state.astype(np.intp) - 1)

    def transitions(self) -> list[Transition]:
        """The transitions to another state after the first step, in their order."""
        name = self.state_names
        rows = np.flatnonzero(self.state[1:] != self.state[:-1]) + 1
        return [Transition(int(i), int(self.g[i]), name[self.state[i - 1] - 1], name[self.state[i] - 1]) for i in rows]

    def frame(self) -> "pandas.DataFrame":
        """A pandas frame with G, the columns, and the name of the state after each step as the categorical column "state_name"."""
        import pandas

        names = pandas.Categorical.from_codes(self.state.astype(np.int64) - 1, categories=list(self.state_names))
        return pandas.DataFrame({self._time_name: self.g, **self._columns, "state_name": names})

    def plot(self, *names: str, axes: Optional[Any] = None) -> Any:
        """Draws columns over G with matplotlib, one below the other, with a bar of the states.  Returns the axes.

        `names`: by default all columns.  `axes`: one more than names, the last one for the states; by default a new figure.
        """
        shown = names or tuple(self._columns)
        columns = [self[name] for name in shown]
        if axes is None:
            import matplotlib.pyplot

            _, axes = matplotlib.pyplot.subplots(
                len(shown) + 1, 1, sharex=True, squeeze=False, figsize=(9, 1.2 + 1.4 * len(shown)), gridspec_kw={"height_ratios": [3] * len(shown) + [1]}
            )
            axes = axes[:, 0]
        if len(axes) != len(shown) + 1:
            raise Error(f"{len(shown)} columns and the states need {len(shown) + 1} axes, not {len(axes)}")
        for axis, name, column in zip(axes, shown, columns):
            axis.plot(self.g, column.astype(float), drawstyle="steps-post" if column.dtype == bool else "default")
            axis.set_ylabel(name)
        self._draw_states(axes[-1])
        return axes

    def _draw_states(self, axis: Any) -> None:
        changes = [0, *(t.row for t in self.transitions()), self.rows - 1] if self.rows else []
        for begin, end in zip(changes, changes[1:]):
            number = int(self.state[begin])
            axis.axvspan(self.g[begin], self.g[end], color=f"C{number % 10}", alpha=0.5)
            axis.text(self.g[begin], 0.5, " " + self.state_names[number - 1], va="center", fontsize="small", clip_on=True)
        axis.set_yticks([])
        axis.set_ylabel("state")
        axis.set_xlabel(self._time_name)
