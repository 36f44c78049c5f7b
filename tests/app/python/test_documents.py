"""The examples of the documentation run as they are printed, with a small film."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

import dipwright
import pytest
from conftest import QUICK, SOURCES

PAGE = SOURCES / "docs/python.md"
EXAMPLES = SOURCES / "docs/examples/python"


@pytest.fixture
def quick(monkeypatch, samples, tmp_path):
    """Gives every project of an example a small film, and the example a folder with the turtle."""
    def made_quick(function):
        def quick_function(*arguments, **options):
            job = function(*arguments, **options)
            job.update(QUICK)
            return job
        return quick_function
    monkeypatch.setattr(dipwright, "open", made_quick(dipwright.open))
    monkeypatch.setattr(dipwright, "new", made_quick(dipwright.new))
    monkeypatch.chdir(tmp_path)
    shutil.copy(samples / "turtle.dipw", tmp_path)
    for model in (samples / "models").iterdir():
        shutil.copy(model, tmp_path)


def blocks_of(page):
    return re.findall(r"^```python\n(.*?)^```$", page.read_text(), re.MULTILINE | re.DOTALL)


def test_page_beginsWithTheFirstLines():
    first = blocks_of(PAGE)[0].splitlines()
    assert first == [
        "import dipwright, numpy", "",
        'job = dipwright.open("turtle.dipw")', "result = job.run()",
        "film = result.immersions[0].film", "numpy.asarray(film.positions)",
        "result.immersions[0].verdict"]


def test_page_everyExample_runs(quick):
    names = {}
    for block in blocks_of(PAGE):
        exec(compile(block, str(PAGE), "exec"), names)


def test_fiveMinutes_makeTheirFiles(package, samples, tmp_path):
    arguments = [f"{path}={value}" for path, value in QUICK.items()]
    run = subprocess.run(
        [sys.executable, EXAMPLES / "five_minutes.py", samples / "models/turtle.obj",
         tmp_path / "out", *arguments],
        env=dict(os.environ, PYTHONPATH=str(package.parent)), capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    assert "best pose" in run.stdout
    for file in ("turtle.dipw", "best.dipw", "sheet.pdf", "results/proof.png",
                 "results/immersion-2/sheet.pdf"):
        assert (tmp_path / "out" / file).stat().st_size > 0, file


def test_toleranceStudy_errorGrowsWithSwellAndTilt(quick, monkeypatch):
    pytest.importorskip("matplotlib", reason="matplotlib is not installed")
    study = (EXAMPLES / "tolerance_study.py").read_text()
    study, count = re.subn(r"^SWELLS = .*$", "SWELLS = (1.02, 1.04)", study, flags=re.MULTILINE)
    assert count == 1
    study, count = re.subn(r"^TILTS = .*?(#.*)?$", "TILTS = (0, 2)", study, flags=re.MULTILINE)
    assert count == 1
    monkeypatch.setattr(sys, "argv", ["tolerance_study.py"])
    names = {"__name__": "__main__"}
    exec(compile(study.replace("(60, 84)", "(24, 32)"), "tolerance_study.py", "exec"), names)
    errors = names["errors"]
    assert errors[0, 0] == 0 and errors[1, 0] > 0.1 and errors[0, 1] > 0.1
    assert errors[1, 1] > max(errors[1, 0], errors[0, 1]) / 2
    assert pathlib.Path("tolerance_study.png").stat().st_size > 10_000
