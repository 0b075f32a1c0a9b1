# SPDX-License-Identifier: Apache-2.0
"""Compiling, diagnostics, scripts, pages."""
import json

import pytest

import smc
from conftest import TANK, TREE

BROKEN = "[state_vector]\nU64 G\nU32 S\nF64 p\n[A]\n.step\n    q = 3\n"
WARNED = "[state_vector]\nU64 G\nU32 S\nF64 p\nbool v\n[local]\nF64 n = 0\n[A]\n.step\n    v = p > 3\n    p > 5: -> A\n"


def test_error_shows_carets():
    with pytest.raises(smc.CompileError) as caught:
        smc.compile({"a.sm": BROKEN})
    assert str(caught.value) == "a.sm:7:5: error: unknown element 'q' [E0204]\n    7 |     q = 3\n      |     ^\n1 error\n"
    (diagnostic,) = caught.value.diagnostics
    assert diagnostic.is_error and diagnostic.code == "E0204" and diagnostic.message == "unknown element 'q'"
    assert diagnostic.place == smc.Place("a.sm", 7, 5, 7, 6, 47, 1)
    assert str(diagnostic) == "a.sm:7:5: error: unknown element 'q' [E0204]"


def test_error_in_every_example_with_a_letter_removed():
    """A broken source is an exception, whatever is broken; and it never ends the process."""
    text = TANK.read_text()
    refused = 0
    for at in range(0, len(text), 7):
        try:
            smc.compile({"tank.sm": text[:at] + text[at + 1 :]}).close()
        except smc.CompileError as error:
            refused += 1
            assert "tank.sm:" in str(error) and any(d.is_error for d in error.diagnostics)
    assert refused > 20


def test_warnings_are_a_list():
    with smc.compile({"a.sm": WARNED}) as program:
        assert program.warnings and all(d.severity == "warning" and d.warning for d in program.warnings)
        assert program.warnings[0].place is not None and "warning" in program.render()
        assert json.loads(program.render("sarif"))["version"] == "2.1.0"
    with smc.compile({"a.sm": WARNED}, warnings=["no-all"]) as program:
        assert not program.warnings


def test_warning_as_error():
    with smc.compile({"a.sm": WARNED}) as program:
        name = program.warnings[0].warning
    with pytest.raises(smc.CompileError):
        smc.compile({"a.sm": WARNED}, warnings=["error=" + name])


def test_unknown_warning():
    with pytest.raises(smc.Error, match="output-left-on"):
        smc.compile({"a.sm": WARNED}, warnings=["output-left-off"])


def test_files_that_are_no_sources(tmp_path):
    with pytest.raises(FileNotFoundError):
        smc.compile(tmp_path / "none.sm")
    with pytest.raises(smc.Error, match="is no source"):
        smc.compile({"tank.txt": ""})
    with pytest.raises(smc.Error, match="no source to compile"):
        smc.compile()


def test_state_vector_of_its_own():
    folder = TREE / "examples/recovery"
    scripts = folder / "recovery.ss", folder / "recovery-altimeter-frozen.ss"
    with smc.compile(folder / "recovery.sv", folder / "recovery.sm", *scripts) as program:
        assert program.machines == ("recovery",) and len(program.scripts) == 2
        assert all(program.run_scripts(engines=("vm", "ref", "vm-soft")))


def test_scripts():
    with smc.compile(TANK, TANK.with_suffix(".ss")) as program:
        result = program.run_script(trace=True)
        assert result and result.outcome == "passed" and result.steps == 111 and result.asserts == 110
        assert "110 asserts passed" in result.report and len(result.trace.splitlines()) == 112
        assert program.run_script("tank", max_steps=5).outcome == "endless"
        with pytest.raises(smc.UnknownName, match="did you mean 'tank'"):
            program.run_script("tnak")
        with pytest.raises(smc.UnknownName, match="did you mean 'ref'"):
            program.run_script(engines=["reff"])


def test_failing_script():
    script = "[options]\ndelta_t 10\n[all_states]\nG == 20 {\n    @assert tankPressure > 1\n    @stop\n}\n"
    with smc.compile(TANK, {"fails.ss": script}) as program:
        result = program.run_script()
        assert not result and result.outcome == "failed" and result.diagnostics[0].place.line == 5


def test_pages():
    with smc.compile(TANK, TANK.with_suffix(".ss")) as program:
        assert program.diagram().startswith("<svg") and program.diagram("mermaid").startswith("stateDiagram")
        assert "TankVentControl" in program.report("text") and json.loads(program.report("json"))
        assert program.report().lower().startswith("<!doctype html")
        assert sorted(program.emit()) == ["tank.c", "tank.h"] and program.emit("image")["tank.smb"][:3] == b"smb"
        with pytest.raises(smc.UnknownName):
            program.diagram("png")


def test_explain():
    assert "element" in smc.explain("E0204") and smc.explain("E9999") == ""


def test_closed():
    program = smc.compile(TANK)
    machine = program.machine()
    program.close()
    program.close()
    machine.close()
    for use in (program.render, program.machine, lambda: program.warnings, machine.step, lambda: machine.state, lambda: machine["counter"], program.cancel):
        with pytest.raises(smc.ClosedError, match="closed"):
            use()
    assert "(closed)" in repr(program) and "(closed)" in repr(machine)
