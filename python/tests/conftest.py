# SPDX-License-Identifier: Apache-2.0
from pathlib import Path

import pytest

import smc

TREE = Path(__file__).resolve().parents[2]
TANK = TREE / "examples/tank/tank.sm"

# Elements of many types, and a window.
TYPES = """
[state_vector]
U64  G
U32  S
F64  p
F32  q
I8   small
I64  wide
U64  count
bool on

[local]
U64  ticks = 5
F64  mean  = 0

[First] @safe
.step
    ticks = ticks + 1
    mean = roll_avg(p, 30)
    count = count + 1
    on = p > 1
    p > 10: -> Second

[Second] @swap
.step
    small = p
    p < 5: -> First
"""


@pytest.fixture
def tank():
    with smc.compile(TANK) as program:
        yield program.machine(dt=10)


@pytest.fixture
def types():
    with smc.compile({"types.sm": TYPES}) as program:
        yield program.machine(dt=10)
