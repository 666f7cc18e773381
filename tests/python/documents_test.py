# SPDX-License-Identifier: Apache-2.0
"""The Python blocks of the documents run, one after the other, as a reader would run them."""
import importlib.util
import os
import re
import shutil

import pytest

from conftest import SOURCES

BLOCK = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def blocks(page):
    text = (SOURCES / "docs" / page).read_text(encoding="utf-8")
    return [(text.count("\n", 0, found.start(1)) + 1, found[1]) for found in BLOCK.finditer(text)]


@pytest.fixture
def folder(tmp_path):
    """A folder with the files that the page names."""
    for name in ("cornell-box.obj", "cornell-box.mtl"):
        shutil.copy(SOURCES / "scenes" / name, tmp_path)
    shutil.copy(SOURCES / "scenes" / "luminaires" / "led-panel.ies", tmp_path)
    rows = ["place test", "latitude 48", "longitude -11", "time_zone -15", "site_elevation 500", "weather_data_file_units 1"]
    rows += [f"6 21 {hour + 0.5:.1f} 500 150" for hour in range(9, 15)]
    (tmp_path / "day.wea").write_text("\n".join(rows) + "\n", encoding="utf-8")
    before = os.getcwd()
    os.chdir(tmp_path)
    yield tmp_path
    os.chdir(before)


def run_blocks(page):
    names = {}
    for line, code in blocks(page):
        if "tqdm" in code and importlib.util.find_spec("tqdm") is None:
            continue
        exec(compile("\n" * (line - 1) + code, f"docs/{page}", "exec"), names)


def test_every_block_runs(folder, capsys):
    run_blocks("python.md")
    printed = capsys.readouterr().out
    assert "missing.obj: no such file" in printed
    assert {"box.vtkhdf", "box.glb", "box.png", "kept.glb", "factors.h5"} <= set(os.listdir(folder))
    assert len(blocks("python.md")) >= 15


def test_the_tutorial_prints_what_it_shows(folder, capsys):
    run_blocks("tutorial-python.md")
    text = (SOURCES / "docs" / "tutorial-python.md").read_text(encoding="utf-8")
    shown = "".join(found[1] for found in re.finditer(r"^```text\n(.*?)^```$", text, re.MULTILINE | re.DOTALL))
    assert capsys.readouterr().out == shown
    assert (folder / "desk.png").exists()
