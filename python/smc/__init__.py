# SPDX-License-Identifier: Apache-2.0
"""State machines for rockets: compiles machines of the language smc, steps them, and replays flights through them.

    import smc

    program = smc.compile("tank.sm")
    tank = program.machine(dt=10)
    print(tank.step(tankPressure=780.0).valveOpen)      # True
    run = tank.run({"tankPressure": pressures})         # numpy arrays
    print(run.transitions())
"""
from ._native import version
from .diagnostics import Diagnostic, Edit, Note, Place
from .errors import ClosedError, CompileError, Error, RunError, UnknownName
from .machine import Machine, Values
from .program import Program, ScriptResult, compile, explain
from .runs import Run, Transition

__version__ = version()

__all__ = [
    "ClosedError", "CompileError", "Diagnostic", "Edit", "Error", "Machine", "Note", "Place", "Program", "Run", "RunError", "ScriptResult",
    "Transition", "UnknownName", "Values", "compile", "explain", "version",
]  # fmt: skip
