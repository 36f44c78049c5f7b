"""Finds the module of the build, and makes small jobs for the tests."""
import os
import pathlib
import sys
import tempfile

import pytest

SOURCES = pathlib.Path(__file__).resolve().parents[3]
# A coarse film and sheet, with which the sample ball takes a second.
QUICK = {"film.points": "24x32", "sheet.dpi": "40", "body.sdf_resolution": "64"}


def pytest_addoption(parser):
    parser.addoption("--module", required=True, help="file of the built module dipwright._dipwright")
    parser.addoption("--samples", required=True, help="folder of the sample projects")


def pytest_configure(config):
    package = pathlib.Path(config.getoption("--module")).parent
    sys.path.insert(0, str(package.parent))
    config.own_settings = tempfile.TemporaryDirectory()
    for name in ("XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME"):
        os.environ[name] = config.own_settings.name


@pytest.fixture(scope="session")
def package(request):
    return pathlib.Path(request.config.getoption("--module")).parent


@pytest.fixture(scope="session")
def samples(request):
    return pathlib.Path(request.config.getoption("--samples"))


@pytest.fixture(scope="session")
def small_ball(samples):
    """The sample ball, dipped once, with a coarse film."""
    import dipwright

    job = dipwright.open(samples / "sphere.dipw")
    while job.immersion_count > 1:
        job.remove_immersion(1)
    job.update(QUICK)
    return job


@pytest.fixture
def ball(small_ball):
    """A copy of it, for the test to change."""
    return small_ball.copy()


@pytest.fixture(scope="session")
def result(small_ball):
    """Its result, for tests that only look at it."""
    return small_ball.copy().run()
