# SPDX-License-Identifier: Apache-2.0
"""Runs the examples of the documents: what a block prints is the text block after it."""
import re
import shutil

import pytest

from conftest import TANK, TREE

BLOCK = re.compile(r"^```(python|text)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("document, blocks", [("docs/python.md", 8), ("python/README.md", 1)])
def test_document(document, blocks, tmp_path, monkeypatch, capsys):
    for needed in ("pandas", "matplotlib"):
        pytest.importorskip(needed).__name__
    monkeypatch.setenv("MPLBACKEND", "Agg")
    shutil.copy(TANK, tmp_path)
    shutil.copy(TANK.with_suffix(".ss"), tmp_path)
    monkeypatch.chdir(tmp_path)
    found = BLOCK.findall((TREE / document).read_text())
    programs = [text for kind, text in found if kind == "python"]
    assert len(programs) >= blocks
    names: dict = {}
    for i, (kind, text) in enumerate(found):
        if kind == "python":
            exec(compile(text, f"{document}, block {i}", "exec"), names)
            expected = found[i + 1][1] if i + 1 < len(found) and found[i + 1][0] == "text" else ""
            assert capsys.readouterr().out == expected
