#!/usr/bin/env python3
"""Finds the tests of the release preset that scripts/test need not run again.

    tests/unchanged_tests.py            prints the tests that passed before with the same input
    tests/unchanged_tests.py --keep     records the tests that passed in the last run of ctest

The input of a test is its program, the programs and modules that the program names, all files of the
repository except sources, the shared models, its command line and its environment variables. Tests
in tests/house read every file of the repository.
"""
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

BUILD = pathlib.Path("build/release")
KEPT = BUILD / "Testing/passed.json"
# Text that may contain a file name, in 8 or in 16 bits a letter.
TEXTS = re.compile(rb"[\w.+/-]{4,}"), re.compile(rb"(?:[\w.+/-]\0){4,}")
SOURCES = re.compile(r"\.(cpp|h|cu|cuh|cmake|ts)$|(^|/)CMakeLists\.txt$")


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def digest(*parts):
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()


class Files:
    """Hashes of files, each read once."""

    def __init__(self):
        self.known = {}

    def bytes_of(self, path):
        with open(path, "rb") as file:
            return file.read()

    def hash(self, path):
        path = str(path)
        if path not in self.known:
            self.known[path] = hashlib.sha256(self.bytes_of(path)).hexdigest()
        return self.known[path]


def repository_files():
    names = output("git", "ls-files", "--cached", "--others", "--exclude-standard", "-z").split("\0")
    return sorted(name for name in names if name and os.path.isfile(name))


def surroundings():
    """What decides whether a test is skipped, and the shared models by size and time."""
    lines = [str(sorted(pathlib.Path("/dev").glob("nvidia[0-9]*"))), str(shutil.which("slurmctld"))]
    for path in sorted(pathlib.Path("../shared/data").rglob("*")):
        status = path.stat()
        lines.append(f"{path} {status.st_size} {status.st_mtime_ns}")
    return digest(*lines)


def started_programs():
    """What lies beside the tests' own programs, by name."""
    found = {}
    for folder in ("bin", "tests", "lib"):
        for path in sorted((BUILD / folder).rglob("*")):
            if path.is_file() and not path.name.endswith("Test"):
                found.setdefault(path.name, []).append(path)
    return found


def named_in(program, names):
    """Names at the end of a text; the linker may keep a text only as the end of a longer one. Not
    "dipwright": that is also a word in other texts, and only tests in tests/install start it."""
    wanted = {name.encode(): name for name in names if name != "dipwright"}
    lengths = {len(name) for name in wanted}
    ends = {word[-length:] for pattern in TEXTS for text in pattern.findall(program)
            for word in text.replace(b"\0", b"").rstrip(b".").split(b"/") for length in lengths}
    return [wanted[name] for name in wanted if name in ends]


def keys():
    files = Files()
    repository = repository_files()
    data = digest(*(files.hash(name) for name in repository if not SOURCES.search(name)), surroundings())
    everything = digest(data, *(files.hash(name) for name in repository))
    programs = started_programs()
    modules = digest(*(files.hash(path) for found in programs.values() for path in found
                       if path.suffix in (".so", ".json") and not path.name.startswith("_dipwright")))
    result = {}
    for test in json.loads(output("ctest", "--preset", "release", "--show-only=json-v1"))["tests"]:
        if "command" not in test:
            continue
        properties = {entry["name"]: entry["value"] for entry in test["properties"]}
        words = [part.split("=", 1)[-1] for part in test["command"]]
        own = [part for part in words if part.startswith(str(BUILD.resolve())) and os.path.isfile(part)]
        labels = properties.get("LABELS", [])
        parts = [json.dumps(test["command"]), json.dumps(properties.get("ENVIRONMENT", [])), modules,
                 everything if "house" in labels else data]
        for path in own:
            parts.append(files.hash(path))
            for name in programs if "install" in labels else named_in(files.bytes_of(path), programs):
                parts += [files.hash(found) for found in programs[name]]
        result[test["name"]] = digest(*parts)
    return result


def kept():
    try:
        return json.loads(KEPT.read_text())
    except (OSError, ValueError):
        return {}


def last_run():
    """Whether each test passed, by ctest's log: `1/144 Testing: Name`, and later `Test Passed.`"""
    log = BUILD / "Testing/Temporary/LastTest.log"
    log = log.read_text(errors="replace") if log.exists() else ""
    parts = re.split(r"^\d+/\d+ Testing: ", log, flags=re.MULTILINE)[1:]
    return {part.split("\n", 1)[0].strip(): bool(re.search(r"^Test Passed\.$", part, flags=re.MULTILINE))
            for part in parts}


def main():
    run = last_run()
    now = keys()  # asks ctest for its tests, which empties its log
    before = kept()
    if sys.argv[1:] == ["--keep"]:
        KEPT.write_text(json.dumps({name: key for name, key in now.items()
                                    if run.get(name, before.get(name) == key)}, indent=1))
        return
    for name in sorted(now):
        if before.get(name) == now[name]:
            print(name)


main()
