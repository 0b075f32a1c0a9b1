# SPDX-License-Identifier: Apache-2.0
"""Machines step by step."""
import math
import threading

import pytest

import smc
from conftest import TANK, TYPES


def test_step(tank):
    after = tank.step(tankPressure=774.5)
    assert after.valveOpen is False and after["tankPressure"] == 774.5 and after.time == 0 and after.state == 1
    assert tank.step(tankPressure=775.5).valveOpen is True and tank.time == 10 and tank["counter"] == 1
    assert tank.step(tankPressure=900).time == 20 and tank.state == "Abort" and tank.states == ("TankVentControl", "Idle", "Abort")
    assert dict(after) == {"state": 1, "tankPressure": 774.5, "time": 0, "valveOpen": False}


def test_time(tank):
    tank.step(5)
    assert tank.elements.time == 5 and tank.step().time == 15 and tank.next_g == 25
    for late in (15, 14):
        with pytest.raises(smc.Error, match="not above"):
            tank.step(late)
    with pytest.raises(smc.Error, match="U64"):
        tank.step(-1)
    with pytest.raises(smc.Error, match="first argument"):
        tank.step(time=3)
    assert tank.step(1 << 63).time == 1 << 63


def test_bad_names(tank):
    with pytest.raises(smc.UnknownName, match="did you mean 'tankPressure'"):
        tank.step(tankPresure=1)
    with pytest.raises(smc.UnknownName, match="did you mean 'counter'"):
        tank["Counter"]
    with pytest.raises(AttributeError, match="valveOpen"):
        tank.step().valveOpne
    with pytest.raises(smc.UnknownName, match="did you mean 'Idle'"):
        tank.reset("idle")
    with pytest.raises(smc.UnknownName, match="there are: counter, state"):
        tank["xyz"]
    assert tank["tankPressure"] == 0


def test_values_are_a_copy(tank):
    values = tank.elements
    with pytest.raises(AttributeError, match="copy"):
        values.valveOpen = True
    assert not hasattr(values, "__nothing__") and "valveOpen=False" in repr(values)


def test_types(types):
    assert types.locals.ticks == 5
    types.step(p=0.5)
    assert types["ticks"] == 6 and types["on"] is False
    types["wide"] = -(2**63) - 5
    assert types["wide"] == -(2**63)
    types["count"] = 2**64 - 1
    assert types.step().count == 2**64 - 1
    types["q"] = math.nan
    assert types["q"] == 0
    types["q"] = 0.1
    assert types["q"] != 0.1 and abs(types["q"] - 0.1) < 1e-8
    types["small"] = 300.7
    assert types["small"] == 127


def test_reset(tank):
    tank.step(tankPressure=900)
    tank.step()
    tank.reset(tankPressure=700)
    assert tank.state == "TankVentControl" and tank["tankPressure"] == 700 and tank.step().time == 0
    tank.reset("Idle")
    assert tank.state == "Idle"


def test_continue_from():
    with smc.compile({"m.sm": TYPES}) as program:
        old = program.machine(dt=10)
        for p in (2, 3, 4):
            old.step(p=p)
        program.recompile({"m.sm": TYPES.replace("ticks + 1", "ticks + 100")})
        new = program.machine(dt=10)
        new.continue_from(old)
        assert new["p"] == 4 and new["mean"] == 3 and new.time == old.time and new.state == old.state
        assert new.step().G == 30 and new["ticks"] == old["ticks"] + 100 and old["count"] == 3
        with pytest.raises(smc.CompileError):
            program.recompile({"m.sm": TYPES.replace("ticks", "tocks", 2)})
        assert old.step().count == 4
    with smc.compile({"m.sm": TYPES}) as a, smc.compile({"m.sm": TYPES}) as b:
        with pytest.raises(smc.Error, match="one program"):
            a.machine().continue_from(b.machine())


def test_swap_that_is_not_allowed():
    text = TYPES.replace(" @swap", "")
    with smc.compile({"m.sm": text}) as program:
        old, new = program.machine(), program.machine()
        old.step(p=11)
        with pytest.raises(smc.Error, match="neither @swap nor @safe"):
            new.continue_from(old)


def test_closing_a_machine(tank):
    with tank as machine:
        machine.step()
    with pytest.raises(smc.ClosedError, match="machine has been closed"):
        tank.step()
    tank.close()


def test_threads():
    """One program for each thread, and one program for all of them."""
    shared = smc.compile(TANK)
    found = []

    def fly(number):
        with smc.compile(TANK) as program:
            own, other = program.machine(dt=10), shared.machine(dt=10)
            for i in range(200):
                pressure = 600 + (i * number) % 180
                assert own.step(tankPressure=pressure) == other.step(tankPressure=pressure)
            found.append(own["counter"])

    threads = [threading.Thread(target=fly, args=(n,)) for n in (1, 3, 7, 11)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert len(found) == 4
    shared.close()


def test_program_is_freed_after_its_machines():
    machine = smc.compile(TANK).machine()
    assert machine.step(tankPressure=780).valveOpen
