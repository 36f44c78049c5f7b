"""Results: arrays, verdict, pictures, sheets and files."""
import gc
import json
import subprocess

import dipwright
import numpy
import pytest


def arrays_of(dip):
    film, body = dip.film, dip.body
    points, triangles = film.columns * film.rows, 2 * (film.columns - 1) * (film.rows - 1)
    corners = len(body.triangles)
    return [
        (film.positions, (points, 3), "f4"), (film.places, (points, 3), "f4"),
        (film.rest, (points, 2), "f4"), (film.states, (points,), "u1"), (film.marks, (points,), "u1"),
        (film.surface_triangles, (points,), "i4"), (film.surface_weights, (points, 3), "f4"),
        (film.triangles, (triangles, 3), "u4"), (film.stretches, (triangles, 2), "f4"),
        (film.painted, (triangles,), "u1"), (film.point_stretches, (points,), "f4"),
        (body.positions, (len(body.positions), 3), "f4"), (body.triangles, (corners, 3), "u4"),
        (body.covered, (corners,), "u1"), (body.model_to_pose, (4, 4), "f8"),
        (dip.certainty.point_errors, (points,), "f4"),
    ]


def test_firstLines_giveArraysAndVerdict(result):
    film = result.immersions[0].film
    positions = numpy.asarray(film.positions)
    assert positions.shape == (24 * 32, 3)
    assert result.immersions[0].verdict.advice in ("print", "look_first", "do_not_print")


def test_arrays_shapesAndTypes_areAsDocumented(result):
    for array, shape, kind in arrays_of(result.immersions[0]):
        assert array.shape == shape and array.dtype == numpy.dtype(kind)


def test_arrays_areSharedAndReadOnly(result):
    for array, _, _ in arrays_of(result.immersions[0]):
        assert not array.flags.owndata
        with pytest.raises(ValueError):
            array[...] = 0
        with pytest.raises(ValueError):
            array.setflags(write=True)
    film = result.immersions[0].film
    assert numpy.shares_memory(film.positions, film.positions)
    assert numpy.shares_memory(result.immersions[0].sheet.pixels, result.immersions[0].sheet.pixels)


def test_arrays_outliveTheResult(ball):
    result = ball.run(certainty=False)
    positions = result.immersions[0].film.positions
    pixels = result.immersions[0].sheet.pixels
    before = positions.copy(), pixels.copy()
    del result, ball
    gc.collect()
    assert numpy.array_equal(positions, before[0]) and numpy.array_equal(pixels, before[1])


def test_film_flat_hasTheGridOfTheDocuments(result):
    film = result.immersions[0].film
    rest = film.rest.reshape(film.rows, film.columns, 2)
    assert (numpy.diff(rest[0, :, 0]) > 0).all() and (numpy.diff(rest[:, 0, 1]) > 0).all()
    assert rest[0, 0] == pytest.approx(-rest[-1, -1])


def test_film_onTheBody_liesOnItsTriangles(result):
    film, body = result.immersions[0].film, result.immersions[0].body
    on = film.surface_triangles >= 0
    assert 0 < on.sum() < len(on)
    corners = body.positions[body.triangles[film.surface_triangles[on]]]
    places = (film.surface_weights[on][:, :, None] * corners).sum(axis=1)
    assert numpy.abs(places - film.places[on]).max() < 0.01  # mm


def test_film_stretches_areOrdered(result):
    stretches = result.immersions[0].film.stretches
    assert (stretches[:, 0] >= stretches[:, 1]).all() and (stretches > 0).all()


def test_body_inItsPose_isTheModelMoved(ball):
    ball["immersions[0].rotation_deg"] = (30, 0, 0)
    body = ball.run(certainty=False).immersions[0].body
    moved = ball.model_positions @ body.model_to_pose[:3, :3].T + body.model_to_pose[:3, 3]
    assert numpy.abs(moved - body.positions).max() < 1e-3
    assert body.positions[:, 1].min() == pytest.approx(0, abs=1e-3)
    assert body.positions[:, 1].max() == pytest.approx(body.height, abs=1e-3)


def test_verdict_words_haveEveryReason(result):
    verdict = result.immersions[0].verdict
    assert verdict.reasons and all(reason.text in str(verdict) for reason in verdict.reasons)
    assert verdict.advice in repr(verdict)
    advices = {dip.verdict.advice for dip in result.immersions}
    assert result.verdict.advice in advices | {"look_first", "do_not_print"}


def test_verdict_withoutCertainty_isNotJudged(ball):
    dip = ball.run(certainty=False).immersions[0]
    assert dip.certainty is None and dip.certainty_map() is None
    assert "not_judged" in [reason.advice for reason in dip.verdict.reasons]


def test_report_isThatOfTheFile(result, tmp_path):
    result.save(tmp_path / "results")
    saved = json.loads((tmp_path / "results/report.json").read_text())
    assert saved == result.report
    assert (tmp_path / "results/immersion-1/sheet.pdf").read_bytes()[:5] == b"%PDF-"


def test_pictures_areArrays(result):
    for picture in (result.proof, result.immersions[0].stretch_map(300),
                    result.immersions[0].wrinkling_map(300), result.immersions[0].certainty_map(300)):
        assert picture.dtype == numpy.uint8 and picture.ndim == 3 and picture.shape[2] in (3, 4)
    assert max(result.immersions[0].stretch_map(300).shape) < max(result.immersions[0].stretch_map().shape)


def test_sheet_pixels_haveItsSize(result):
    sheet = result.immersions[0].sheet
    height, width, channels = sheet.pixels.shape
    assert channels == 4 and width == round(sheet.width_mm / 25.4 * sheet.dpi)
    assert height == round(sheet.height_mm / 25.4 * sheet.dpi)
    assert 0 < (sheet.pixels[..., 3] > 0).mean() < 1


@pytest.mark.parametrize("name, begin", [
    ("a.pdf", b"%PDF-"), ("b.png", b"\x89PNG"), ("c.tif", b"II*\0")])
def test_sheet_saved_isOfThatFormat(result, tmp_path, name, begin):
    result.immersions[0].sheet.save(tmp_path / name)
    assert (tmp_path / name).read_bytes().startswith(begin)


def test_sheet_unknownFormat_isAnError(result, tmp_path):
    with pytest.raises(dipwright.Error, match="must end in"):
        result.immersions[0].sheet.save(tmp_path / "a.bmp")
    with pytest.raises(dipwright.Error):
        result.immersions[0].sheet.print_to_file(tmp_path / "none" / "a.pdf")
    with pytest.raises(dipwright.Error):
        result.immersions[0].sheet.print_to_file(tmp_path / "a.pdf", profile="nobody's")


def test_sheet_printedForAnotherPrinter_warns(result, tmp_path):
    warnings = result.immersions[0].sheet.print_to_file(
        tmp_path / "a.pdf", profile="Office printer, 5 mm margins", accept_clipping=True)
    assert any("not of this printer profile" in warning for warning in warnings)


def test_sheet_printedToFile_isTiled(result, tmp_path):
    sheet = result.immersions[0].sheet
    sheet.print_to_file(tmp_path / "one.pdf")
    sheet.print_to_file(tmp_path / "tiles.pdf", tile_paper=(105, 148))
    pages = [(tmp_path / name).read_bytes().count(b"/MediaBox") for name in ("one.pdf", "tiles.pdf")]
    assert pages[0] == 1 or pages[1] != pages[0]
    assert all((tmp_path / name).stat().st_size > 0 for name in ("one.pdf", "tiles.pdf"))


def test_outputs_areMadeAndProtected(result, tmp_path):
    made = result.make_outputs(tmp_path, "sheet_png,report")
    assert [output.name for output in made] == ["sheet_png", "report"]
    assert all((tmp_path / file).exists() for output in made for file in output.files)
    (tmp_path / "report.json").write_text("{}")
    with pytest.raises(dipwright.Error, match="report"):
        result.make_outputs(tmp_path, "report")
    result.make_outputs(tmp_path, "report", overwrite=True)
    with pytest.raises(dipwright.Error):
        result.make_outputs(tmp_path, "everything that exists")


def test_share_ofTwoDips_coversThePart(ball):
    ball.add_immersion({"name": "Other side", "rotation_deg": (180, 0, 0)})
    result = ball.run(certainty=False)
    share = result.share
    assert len(share.painters) == len(share.triangles)
    assert set(numpy.unique(share.painters)) <= {0, 1, 2, 3}
    assert share.areas["first"] > 0 and share.areas["second"] > 0 and share.seam_mm > 0
    assert share.seam.shape[1:] == (2, 3) and result.coverage_picture.ndim == 3


def test_objects_keepTheResult(ball):
    film = ball.run(certainty=False).immersions[0].film
    gc.collect()
    assert film.positions.shape[1] == 3


def test_savedFiles_areThoseOfTheCommandLine(ball, tmp_path, package):
    ball.save(tmp_path / "ball.dipw")
    ball.run().save(tmp_path / "python")
    program = package.parents[3] / "bin/dipwright-cli"
    subprocess.run([program, "run", tmp_path / "ball.dipw", "--out", tmp_path / "cli", "--quiet"],
                   check=True, capture_output=True)
    files = sorted(path.relative_to(tmp_path / "cli") for path in (tmp_path / "cli").rglob("*.*"))
    assert files == sorted(path.relative_to(tmp_path / "python")
                           for path in (tmp_path / "python").rglob("*.*"))
    for file in files:
        if file.name != "report.json":  # has times
            assert (tmp_path / "cli" / file).read_bytes() == (tmp_path / "python" / file).read_bytes(), file
