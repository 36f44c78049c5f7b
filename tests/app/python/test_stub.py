"""The types in __init__.pyi are those of the module."""
import ast
import importlib.util
import os
import re
import subprocess
import sys

import dipwright
import pytest
from conftest import SOURCES


def functions_of(package):
    """(owner, function) of every function in the stub; the owner is None for the module's."""
    tree = ast.parse((package / "__init__.pyi").read_text())
    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            yield None, node
        elif isinstance(node, ast.ClassDef):
            yield from ((node.name, item) for item in node.body if isinstance(item, ast.FunctionDef))


def parameters_in_stub(function):
    arguments = function.args
    return [argument.arg for argument in arguments.posonlyargs + arguments.args
            + arguments.kwonlyargs if argument.arg != "self"]


def parameters_in_module(text):
    """Names of parameters from the first line of a docstring of pybind11."""
    inside = text.split("\n")[0].split("(", 1)[1].rsplit(") ->", 1)[0]
    return [name for name in re.findall(r"(?:^|, )(\w+): ", inside) if name != "self"]


def test_stub_parameters_areThoseOfTheModule(package):
    for owner, function in functions_of(package):
        place = dipwright if owner is None else getattr(dipwright, owner)
        found = getattr(place, function.name)
        if isinstance(found, property) or function.name in ("__iter__", "__len__"):
            continue
        assert parameters_in_stub(function) == parameters_in_module(found.__doc__), function.name


def test_stub_names_areThoseOfTheModule(package):
    listed = {}
    for owner, function in functions_of(package):
        listed.setdefault(owner, set()).add(function.name)
    for name in dipwright.__all__:
        type_ = getattr(dipwright, name)
        if isinstance(type_, type) and not issubclass(type_, Exception):
            public = {key for key in vars(type_) if not key.startswith("_")}
            assert public == {key for key in listed[name] if not key.startswith("_")}, name


def test_everything_isDocumented():
    for name in dipwright.__all__:
        assert getattr(dipwright, name).__doc__, name
        members = vars(getattr(dipwright, name)) if isinstance(getattr(dipwright, name), type) else {}
        for key, member in members.items():
            if not key.startswith("_") and callable(member) | isinstance(member, property):
                assert member.__doc__, f"{name}.{key}"


def mypy(*arguments, package, cwd):
    environment = dict(os.environ, PYTHONPATH=str(package.parent), MYPYPATH=str(package.parent))
    return subprocess.run([sys.executable, "-m", *arguments], env=environment, cwd=cwd,
                          capture_output=True, text=True)


def test_mypy_findsNoDifference(package, tmp_path):
    if not importlib.util.find_spec("mypy"):
        pytest.fail("mypy is not installed; scripts/setup installs it")
    # Classes of pybind11 have a metaclass of their own, and an __init__ that says that there is none.
    allowed = tmp_path / "allowed"
    allowed.write_text("dipwright\\.[A-Z]\\w*(\\.__init__)?\n")
    run = mypy("mypy.stubtest", "dipwright", "--ignore-missing-stub", "--allowlist", str(allowed),
               package=package, cwd=tmp_path)
    assert run.returncode == 0, run.stdout + run.stderr
    example = SOURCES / "docs/examples/python/five_minutes.py"
    run = mypy("mypy", "--check-untyped-defs", str(example), package=package, cwd=tmp_path)
    assert run.returncode == 0, run.stdout + run.stderr
