# SPDX-License-Identifier: Apache-2.0
"""Whole runs through columns."""
import time

import numpy as np
import pytest

import smc
from conftest import TANK


def pressures(rows):
    return 600 + np.arange(rows) * 37 % 180.0


def test_run_is_many_steps(types, tank):
    rows = 500
    p = np.where(np.arange(rows) % 100 < 60, np.arange(rows) % 9, 20.0)
    run = types.run({"p": p}, record=["on", "small", "count", "mean", "ticks", "S", "q"])
    types.reset()
    for i in range(rows):
        after = types.step(p=p[i])
        assert run.g[i] == after.G and run.states[i] == types.state
        for name in ("on", "small", "count", "S", "q"):
            assert run[name][i] == after[name]
        assert run["mean"][i] == types["mean"]
    assert [run[n].dtype.str for n in ("on", "small", "count", "mean", "q")] == ["|b1", "|i1", "<u8", "<f8", "<f4"]
    assert {t.target for t in run.transitions()} == {"First", "Second"}


def test_transitions(tank):
    run = tank.run({"tankPressure": [700, 780, 700, 900, 900]})
    assert run.transitions() == [smc.Transition(3, 30, "TankVentControl", "Abort")]
    assert list(run) == ["tankPressure", "state", "valveOpen"] and list(run["valveOpen"]) == [False, True, False, True, True]
    assert list(run["state"]) == [1, 1, 1, 1, 3] and list(run.state) == [1, 1, 1, 3, 3] and run.rows == 5


def test_continues(tank):
    whole = tank.run({"tankPressure": pressures(300)}, record=["counter"])
    tank.reset()
    first = tank.run({"tankPressure": pressures(300)[:100]}, record=["counter"])
    second = tank.run({"tankPressure": pressures(300)[100:]}, record=["counter"])
    assert list(whole["counter"]) == [*first["counter"], *second["counter"]] and second.g[0] == 1000 and whole.g[-1] == second.g[-1]


def test_more_rows_than_one_call(tank):
    rows = (1 << 20) + 5
    p = np.full(rows, 700.0)
    p[[5, 1 << 20, rows - 1]] = 780
    run = tank.run({"tankPressure": p}, record=["counter", "valveOpen"])
    assert run.rows == rows and run.g[-1] == 10 * (rows - 1) and run["counter"][-1] == 3
    assert list(np.flatnonzero(run["valveOpen"])) == [5, 1 << 20, rows - 1]


def test_strided_and_other_columns(tank):
    matrix = np.array([[780, 1], [700, 2], [790, 3]], dtype=np.int16)
    assert list(tank.run({"tankPressure": matrix[:, 0]})["valveOpen"]) == [True, False, True]
    tank.reset()
    assert list(tank.run({"tankPressure": 780}, g=[1, 5, 7])["valveOpen"]) == [True] * 3 and tank["time"] == 7


def test_times(tank):
    run = tank.run({"time": np.array([3.0, 10.0, 11.0]), "tankPressure": [700] * 3})
    assert list(run.g) == [3, 10, 11]
    run = tank.run({"tankPressure": [700] * 2}, dt=4)
    assert list(run.g) == [21, 25]
    with pytest.raises(smc.Error, match="whole number"):
        tank.run({"tankPressure": [700] * 2}, g=[30.5, 31])
    with pytest.raises(smc.Error, match="whole number"):
        tank.run({"tankPressure": [700] * 2}, g=[-1, 31])
    with pytest.raises(smc.Error, match="cannot advance by 0"):
        tank.run({"tankPressure": [700] * 2}, dt=0)


def test_stops_at_the_row_that_fails(tank):
    with pytest.raises(smc.RunError, match="row 2: G is not above") as caught:
        tank.run({"tankPressure": [780, 700, 1, 1]}, g=[0, 10, 10, 20])
    assert caught.value.row == 2 and list(caught.value.run["valveOpen"]) == [True, False] and tank["tankPressure"] == 700
    assert tank.step().time == 20


def test_bad_columns(tank):
    with pytest.raises(smc.UnknownName, match="did you mean 'tankPressure'"):
        tank.run({"tankpressure": [1]})
    with pytest.raises(smc.UnknownName, match="did you mean 'counter'"):
        tank.run({"tankPressure": [1]}, record=["count"])
    with pytest.raises(smc.Error, match="different lengths"):
        tank.run({"tankPressure": [1], "valveOpen": [1, 2]})
    with pytest.raises(smc.Error, match="no numbers"):
        tank.run({"tankPressure": ["high"]})
    with pytest.raises(smc.Error, match="2 dimensions"):
        tank.run({"tankPressure": [[1, 2]]})
    with pytest.raises(smc.Error, match="needs a column"):
        tank.run({})
    with pytest.raises(smc.Error, match="also passed"):
        tank.run({"time": [1], "tankPressure": [1]}, g=[2])
    with pytest.raises(smc.UnknownName, match="did you mean 'valveOpen'"):
        tank.run({"tankPressure": [1]})["valveopen"]
    assert tank.run({"tankPressure": [1], "noise": [2]}, ignore_unknown=True).rows == 1
    assert tank.run({"tankPressure": []}).transitions() == []


def test_cancelled():
    program = smc.compile(TANK)
    machine = program.machine()
    program.cancel()
    with pytest.raises(smc.RunError, match="cancel") as caught:
        machine.run({"tankPressure": [1, 2]})
    assert caught.value.row == 0 and machine.run({"tankPressure": [1, 2]}).rows == 2


def test_frame_replayed(tank):
    pandas = pytest.importorskip("pandas")
    run = tank.run({"tankPressure": pressures(200)}, record=["valveOpen", "counter"])
    frame = run.frame()
    assert list(frame.columns) == ["time", "tankPressure", "valveOpen", "counter", "state_name"] and isinstance(frame, pandas.DataFrame)
    assert set(frame["state_name"].cat.categories) == set(tank.states)
    tank.reset()
    again = tank.run(frame[["time", "tankPressure"]], record=["valveOpen", "counter"]).frame()
    pandas.testing.assert_frame_equal(frame, again)


def test_plot(tank):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    run = tank.run({"tankPressure": [700, 780, 900, 900]})
    axes = run.plot("tankPressure", "valveOpen")
    assert [a.get_ylabel() for a in axes] == ["tankPressure", "valveOpen", "state"] and len(axes[0].lines) == 1
    assert [t.get_text().strip() for t in axes[2].texts] == ["TankVentControl", "Abort"]
    assert len(run.plot()) == 4
    with pytest.raises(smc.Error, match="need 3 axes"):
        run.plot("tankPressure", "valveOpen", axes=axes[:2])


def test_speed(tank):
    """5 million steps in a second of CPU time; python/README.md has the command that measures it."""
    p = pressures(1 << 19)
    best = 0.0
    for _ in range(5):
        tank.reset()
        begin = time.process_time()
        tank.run({"tankPressure": p})
        best = max(best, len(p) / (time.process_time() - begin))
    assert best > 5e6
