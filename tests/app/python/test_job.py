"""Jobs: opened, made, changed, run, cancelled, searched and saved."""
import os
import shutil
import signal
import subprocess
import sys
import threading
import time

import dipwright
import numpy
import pytest


def test_value_text_isReadAsBySet(ball):
    ball["film.swell"] = "1.02;1.03"
    assert ball["film.swell"] == (1.02, 1.03)
    ball["film.size_mm"] = "8in x 300mm"
    assert ball["film.size_mm"] == (203.2, 300.0)


@pytest.mark.parametrize("value", [
    (1.02, 1.03), [1.02, 1.03], numpy.array([1.02, 1.03]), ("1.02", 1.03)])
def test_value_sequence_setsItsParts(ball, value):
    ball["film.swell"] = value
    assert ball["film.swell"] == (1.02, 1.03)


def test_value_kinds_areThoseOfPython(ball):
    ball["film.relaxation_time_s"] = None
    assert ball["film.relaxation_time_s"] is None
    ball["film.relaxation_time_s"] = numpy.float32(2)
    assert ball["film.relaxation_time_s"] == 2.0 and isinstance(ball["film.relaxation_time_s"], float)
    ball["share.enabled"] = False
    assert ball["share.enabled"] is False
    ball["share.enabled"] = numpy.True_
    assert ball["share.enabled"] is True
    ball["share.enabled"] = numpy.False_
    assert ball["share.enabled"] is False
    assert ball["film.points"] == (24, 32) and isinstance(ball["film.points"][0], int)
    ball["immersions[0].name"] = "Öl – 油"
    assert ball["immersions[0].name"] == "Öl – 油"


def test_value_ofEveryPath_canBeSetToItself(ball):
    for path in ball:
        ball[path] = ball[path]
    assert len(ball) == len(ball.keys()) > 100
    assert [path for path in ball if path.startswith("model.")] == ["model.tessellation_mm"]


def test_marks_listOfDicts_isSetAsAWhole(ball):
    ball["masks"] = [{"extent": "face", "place_mm": [0, 0, 10]}]
    assert ball["masks"][0]["place_mm"] == [0, 0, 10]
    with pytest.raises(dipwright.Error, match=r"keys are extent, .* \(masks\[0\]\.foo\)"):
        ball["masks"] = [{"foo": 1}]
    assert len(ball["masks"]) == 1
    ball["masks"] = []
    assert ball["masks"] == []


@pytest.mark.parametrize("path, value, says", [
    ("film.swell", "abc", "expected 2 values"),
    ("film.swell", (9, 9), "from 0.5 to 2"),
    ("film.swel", 1, "no such setting"),
    ("immersions[7].name", "x", "no such dip"),
    ("immersions[00].name", "x", "no such setting"),
    ("model.unit_mm", 1, "no such setting"),
    ("film.lattice", "cubic", "expected one of"),
])
def test_value_refused_isAnErrorAndChangesNothing(ball, path, value, says):
    before = {known: ball[known] for known in ball}
    with pytest.raises(dipwright.Error, match=says) as refused:
        ball[path] = value
    assert refused.value.where.startswith(path) and refused.value.message in str(refused.value)
    assert {known: ball[known] for known in ball} == before


@pytest.mark.parametrize("value", [object(), b"AB", bytearray(b"A")])
def test_value_ofAnotherType_isATypeError(ball, value):
    with pytest.raises(TypeError):
        ball["film.points"] = value


def test_value_notUnicode_isAUnicodeError(ball):
    with pytest.raises(UnicodeError):
        ball["name"] = "a\ud800b"


def test_update_oneRefused_setsNone(ball):
    with pytest.raises(dipwright.Error):
        ball.update({"film.swell": "1.02x1.02", "sheet.dpi": -1})
    assert ball["film.swell"] == (1.0, 1.0)


def test_update_order_doesNotMatter(ball):
    ball.update({"film.points": "30x40", "film.size_mm": "100x120"})
    assert ball["film.points"] == (30, 40) and ball["film.size_mm"] == (100.0, 120.0)


def test_field_ofANumber_hasUnitAndLimits(ball):
    field = ball.field("film.size_mm")
    assert (field.unit, field.parts, field.kind) == ("mm", 2, "number")
    assert field.minimum < field.maximum
    assert "isotropic" in ball.field("film.lattice").choices
    assert ball.field("film.lattice").minimum is None


def test_immersions_addAndRemove_keepOneOrTwo(ball):
    ball.add_immersion({"name": "Shell", "rotation_deg": (0, 0, 180)})
    assert ball["immersions[1].rotation_deg"] == (0, 0, 180)
    with pytest.raises(dipwright.Error, match="once or twice"):
        ball.add_immersion()
    ball.remove_immersion(0)
    assert ball["immersions[0].name"] == "Shell"
    with pytest.raises(dipwright.Error):
        ball.remove_immersion(0)


def test_open_missingOrDamaged_isAnError(tmp_path):
    with pytest.raises(dipwright.Error):
        dipwright.open(tmp_path / "none.dipw")
    (tmp_path / "damaged.dipw").write_bytes(b"PK\x03\x04 nothing")
    with pytest.raises(dipwright.Error, match="damaged.dipw"):
        dipwright.open(tmp_path / "damaged.dipw")


def test_new_model_isReadByTheReader(samples, tmp_path, monkeypatch):
    job = dipwright.new(samples / "models/sphere.obj", size_mm=40,
                        immersions=[{"name": "Top"}, {"rotation_deg": (180, 0, 0)}])
    size = job.model_positions.max(axis=0) - job.model_positions.min(axis=0)
    assert size.max() == pytest.approx(40, abs=0.01)
    assert job.path is None and job.immersion_count == 2 and job["immersions[1].name"] == "Dip 2"
    (tmp_path / "hostile.glb").write_bytes(b"glTF" + bytes(40))
    with pytest.raises(dipwright.Error, match="hostile.glb"):
        dipwright.new(tmp_path / "hostile.glb")


def test_save_changedByAnother_isRefused(ball, tmp_path):
    ball.save(tmp_path / "ball.dipw")
    other = dipwright.open(ball.path)
    other["immersions[0].name"] = "Other"
    other.save()
    with pytest.raises(dipwright.Error, match="Another program has changed"):
        ball.save()
    assert dipwright.open(ball.path)["immersions[0].name"] == "Other"


def test_save_emptyName_isRefused(ball):
    with pytest.raises(dipwright.Error, match="name of the file is empty"):
        ball.save("")


def test_save_afterAChangeOfFolder_writesTheSameFile(ball, tmp_path, monkeypatch):
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path)
    ball.save("ball.dipw")
    opened = dipwright.open("ball.dipw")
    monkeypatch.chdir(tmp_path / "elsewhere")
    opened.save()
    assert opened.path == str(tmp_path / "ball.dipw")
    assert list((tmp_path / "elsewhere").iterdir()) == []


def test_save_elsewhereFails_canStillBeSaved(ball, tmp_path):
    ball.save(tmp_path / "ball.dipw")
    ball["film.swell"] = "1.02;1.03"
    with pytest.raises(dipwright.Error):
        ball.save(tmp_path / "no folder" / "copy.dipw")
    ball.save()
    assert dipwright.open(tmp_path / "ball.dipw")["film.swell"] == (1.02, 1.03)


def test_save_opened_hasTheSameValues(ball, tmp_path):
    ball["film.swell"] = "1.02;1.03"
    ball.save(tmp_path / "copy.dipw")
    copy = dipwright.open(tmp_path / "copy.dipw")
    assert {path: copy[path] for path in copy} == {path: ball[path] for path in ball}
    assert ball.path == str(tmp_path / "copy.dipw")


def test_run_sameJob_givesTheSameBits(ball, tmp_path):
    first = ball.copy().run(certainty=False, threads=1)
    ball.save(tmp_path / "ball.dipw")
    again = dipwright.open(ball.path).run(certainty=False)
    assert numpy.array_equal(first.immersions[0].sheet.pixels, again.immersions[0].sheet.pixels)
    assert first.immersions[0].sheet.job_number == again.immersions[0].sheet.job_number


def test_run_progress_isCalledOnThisThread(ball):
    calls = []
    ball.run(certainty=False, progress=lambda share, text: calls.append(
        (share, text, threading.get_ident())))
    assert calls and all(0 <= share <= 1 and text for share, text, _ in calls)
    assert {thread for _, _, thread in calls} == {threading.get_ident()}


def test_run_progressReturnsFalse_isCancelled(ball):
    with pytest.raises(dipwright.Cancelled):
        ball.run(progress=lambda share, text: False)
    assert ball.run(certainty=False).coverage > 0  # the job can still be run


def test_run_progressRaises_isRaised(ball):
    def fail(share, text):
        raise ZeroDivisionError("mine")
    with pytest.raises(ZeroDivisionError, match="mine"):
        ball.run(progress=fail)


def test_run_interrupted_raisesKeyboardInterrupt(ball):
    ball["film.points"] = "200x280"
    timer = threading.Timer(0.3, lambda: signal.raise_signal(signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        ball.run()
    timer.join()


def test_run_otherThreads_goOn(ball):
    counted = []
    ended = threading.Event()

    def count():
        while not ended.is_set():
            counted.append(time.monotonic())
            time.sleep(0.001)
    thread = threading.Thread(target=count)
    thread.start()
    begin = time.monotonic()
    ball.run(certainty=False)
    end = time.monotonic()
    ended.set()
    thread.join()
    assert len([moment for moment in counted if begin < moment < end]) > 10


def test_run_secondJobInAnotherThread_isIndependent(ball):
    results = {}

    def run(name, job):
        results[name] = job.run(certainty=False).immersions[0].sheet.job_number
    other = ball.copy()
    other["film.swell"] = "1.05x1.05"
    threads = [threading.Thread(target=run, args=item) for item in (("a", ball), ("b", other))]
    [thread.start() for thread in threads]
    [thread.join() for thread in threads]
    assert len(set(results.values())) == 2


def test_run_unknownSolver_isAnError(ball):
    with pytest.raises(dipwright.Error, match="nonsense"):
        ball.run(solver="nonsense")
    assert "pbd-cpu" in [solver.id for solver in dipwright.solvers() if solver.available]


def test_run_chessboard_replacesTheTexture(ball):
    plain = ball.run(certainty=False).immersions[0].sheet.pixels
    chess = ball.run(certainty=False, film_image="chessboard").immersions[0].sheet.pixels
    assert not numpy.array_equal(plain, chess)


def test_search_ranksPoses_andTheJobTakesThem(ball):
    search = ball.search(1, candidates=6, directions=40, refined=0, finer=1, confirmed=0,
                         weights={"coverage": 3}, limits={"coverage": 0.1})
    best = search.ranking[0]
    assert search.complete and 0 < best.objective <= 1
    assert 0 < best.measures["coverage"] <= 1
    ball.use(best)
    assert ball["immersions[0].rotation_deg"] == best.immersions[0]["rotation_deg"]
    ball.remove_immersion(0) if ball.immersion_count > 1 else None
    ball.add_immersion(best.immersions[0])


def test_search_unknownMeasure_isAnError(ball):
    with pytest.raises(dipwright.Error):
        ball.search(1, weights={"beauty": 1})


def test_search_cancelled_givesTheBestSoFarOrNothing(ball):
    try:
        search = ball.search(1, candidates=6, directions=40, refined=0, finer=1, confirmed=0,
                             progress=lambda share, text: share < 0.5)
        assert not search.complete and search.ranking
    except dipwright.Cancelled:
        pass


def test_numbers_outOfRange_areErrors(ball, result):
    for refused in (lambda: ball.run(threads=-1), lambda: ball.search(7),
                    lambda: ball.search(1, candidates=0), lambda: ball.remove_immersion(-1),
                    lambda: ball.use_profile("film", "nobody's"), lambda: ball.use_profile("car", "x"),
                    lambda: result.immersions[0].stretch_map(-5),
                    lambda: dipwright.new("model.obj", size_mm=-1),
                    lambda: dipwright.new("model.obj", preset="best")):
        with pytest.raises(dipwright.Error):
            refused()


def test_new_withoutTheReader_isRefused(package, samples, tmp_path):
    """The process of Python itself reads no model and no picture."""
    shutil.copytree(package, tmp_path / "dipwright")
    (tmp_path / "dipwright/bin").mkdir()
    script = f"import dipwright; dipwright.new({str(samples / 'models/turtle.obj')!r})"
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True,
                         env=dict(os.environ, PYTHONPATH=str(tmp_path)))
    assert run.returncode != 0 and "dipwright.Error" in run.stderr and "reader" in run.stderr


def test_session_atTheEndOfPython_endsQuietly(package):
    script = "import dipwright; dipwright.solvers(); print('ends')"
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True,
                         env=dict(os.environ, PYTHONPATH=str(package.parent)))
    assert (run.returncode, run.stdout, run.stderr) == (0, "ends\n", "")
