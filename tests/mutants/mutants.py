#!/usr/bin/env python3
"""mutants.py [--number N] [--seed S] [--folder app/demo]...

Draws N mutants of app and platform (draw.py): copies of one source file with one
small fault. Each is built in build/mutants/tree, a copy of the sources, and the
suites of this machine that concern it run until one of them fails: the unit tests
of its part of limber, the nearest first, then the golden pictures, the command
line and the demos' runs. Prints each mutant, by what it was found or that it
SURVIVES, and a table by folder, which stays in build/mutants/table.

A mutant that does not compile, or whose object has the same bytes as before, is
drawn again. So is one that tests/mutants/equivalent.txt names: it behaves like
the source. A suite that fails without a mutant, too, is left out, and named.
"""
import argparse
import collections
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import time

import draw

TOP = pathlib.Path(__file__).resolve().parents[2]
WORK = TOP / "build/mutants"
TREE = WORK / "tree"
EQUIVALENT = pathlib.Path(__file__).with_name("equivalent.txt")
# The slowest suite takes 30 s of a processor.
SUITE_CPU_S = 90
SUITE_S = 600
SUITE_BYTES = 8 << 30
# Suites that take long run last, if no other found the mutant.
LAST = ("test_demo_runs",)


def limit():
    resource.setrlimit(resource.RLIMIT_CPU, (SUITE_CPU_S, SUITE_CPU_S))
    resource.setrlimit(resource.RLIMIT_AS, (SUITE_BYTES, SUITE_BYTES))


def run(command, prepare=limit):
    """Whether the command ended well, in the copy, within its limits."""
    process = subprocess.Popen(
        command, cwd=TREE, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL, start_new_session=True, preexec_fn=prepare)
    try:
        return process.wait(SUITE_S) == 0
    except subprocess.TimeoutExpired:
        return False
    finally:
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        process.wait()


def make(*targets):
    return run(["make", "-j2", "--no-print-directory", *targets], None)


def copy_tree():
    """Copies the sources, and what was built of them, if they have changed."""
    names = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=TOP, check=True, stdout=subprocess.PIPE).stdout.split(b"\0")
    for name in filter(None, map(os.fsdecode, names)):
        source, copy = TOP / name, TREE / name
        if source.is_file() and not same_file(source, copy):
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(source, copy)
    for part in ("host", "gen"):
        if not (TREE / "build" / part).exists():
            shutil.copytree(TOP / "build" / part, TREE / "build" / part,
                            symlinks=True)
    shutil.copy2(TOP / "build/test-packages.stamp", TREE / "build")


def same_file(a, b):
    return b.exists() and a.stat().st_size == b.stat().st_size and \
        a.read_bytes() == b.read_bytes()


class Suite:
    """A test program or script: what make builds for it, and its command."""

    def __init__(self, name, targets, *command):
        self.name = name
        self.targets = targets
        self.command = command

    def passes(self):
        return make(*self.targets) and run(self.command)


def unit_suite(test):
    program = f"build/host/unit/{test.stem}"
    return Suite(test.stem, (program,), program)


def suites_for(mutant):
    """The suites that concern a mutant, those that find it soonest first."""
    own = pathlib.PurePath(mutant.path)
    unit = TREE / "tests/unit"

    def distance(test):
        common = os.path.commonprefix((test.relative_to(unit).parent.parts,
                                       own.parts))
        return test.stem != f"test_{own.stem}", -len(common), test.stem

    tests = sorted((unit / folder_of(mutant.path)).rglob("test_*.c"),
                   key=distance)
    yield from (unit_suite(test) for test in tests if test.stem not in LAST)
    limber = ("build/host/limber",)
    yield Suite("golden-exact", (*limber, "build/host/compare_png"),
                "tests/golden/golden.sh", "exact", "build/golden-exact", *limber)
    scripts = sorted((TREE / "tests/cli").glob("*.sh"),
                     key=lambda script: (script.stem not in own.stem, script))
    yield from (Suite(f"cli/{script.name}",
                      (*limber, "build/host/unit/fake_gles.so"),
                      str(script.relative_to(TREE))) for script in scripts)
    yield from (unit_suite(test) for name in LAST
                for test in unit.rglob(f"{name}.c"))


class Judge:
    def __init__(self):
        self.sound = set()
        self.left_out = set()

    def finder(self, mutant):
        """The first suite that fails, or None."""
        for suite in suites_for(mutant):
            if suite.name not in self.left_out and not suite.passes():
                return suite
        return None

    def verdict(self, mutant):
        """None for a mutant that is none; otherwise (found, by what)."""
        source = TREE / mutant.path
        text = source.read_text()
        target = f"build/host/obj/{mutant.path[:-2]}.o"
        before = (TREE / target).read_bytes()
        try:
            source.write_text(mutant.apply(text))
            if not make(target) or (TREE / target).read_bytes() == before:
                return None
            suite = self.finder(mutant)
        finally:
            source.write_text(text)
            make(target)
        if suite is None:
            return False, None
        if suite.name not in self.sound:
            if not suite.passes():
                print(f"left out, as it fails without a mutant: {suite.name}",
                      flush=True)
                self.left_out.add(suite.name)
                return self.verdict(mutant)
            self.sound.add(suite.name)
        return True, suite.name


def folder_of(path):
    parts = path.split("/")
    return "/".join(parts[:2]) if len(parts) > 2 else parts[0]


def sources(folders):
    """The C files that this machine's tests build, below the folders."""
    names = subprocess.run(["git", "ls-files", "*.c"], cwd=TOP, check=True,
                           stdout=subprocess.PIPE, text=True).stdout.split()
    return [name for name in names if name.startswith(("app/", "platform/"))
            and not re.search(r"/arm/|gpiod/v2/", name)
            and any(name.startswith(folder) for folder in folders)]


def known_equivalents():
    """What equivalent.txt says, as Mutant.describe() writes it."""
    lines = EQUIVALENT.read_text().splitlines()
    return {line for line in lines if line and line[0] not in "# "}


def table(results):
    """Mutants that were found and drawn, of each folder and in all."""
    count = collections.defaultdict(lambda: [0, 0])
    for path, found in results:
        for name in (folder_of(path), "app and platform"):
            count[name][0] += found
            count[name][1] += 1
    for name in sorted(count, key=lambda name: (name[3] == " ", name)):
        found, drawn = count[name]
        yield f"{100 * found / drawn:5.1f}%  {found:4d} of {drawn:4d}  {name}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[2])
    parser.add_argument("--number", type=int, default=100)
    parser.add_argument("--seed", type=int, default=int(time.time()))
    parser.add_argument("--folder", action="append")
    options = parser.parse_args()
    copy_tree()
    if not make("build/host/limber"):
        sys.exit("limber: the sources cannot be built: run make")
    texts = {path: (TREE / path).read_text()
             for path in sources(options.folder or ["app", "platform"])}
    every = [mutant for path, text in texts.items()
             for mutant in draw.mutants_of(path, text)]
    print(f"seed {options.seed}: {options.number} of {len(every)} mutants",
          flush=True)
    random.Random(options.seed).shuffle(every)
    equivalents = known_equivalents()
    judge = Judge()
    results = []
    while every and len(results) < options.number:
        mutant = every.pop(0)
        name = mutant.describe(texts[mutant.path])
        begun = time.monotonic()
        verdict = None if name in equivalents else judge.verdict(mutant)
        if verdict:
            results.append((mutant.path, verdict[0]))
            by = f"found by {verdict[1]}" if verdict[0] else "SURVIVES"
            print(f"{len(results):4d} {by} ({time.monotonic() - begun:.0f} s)"
                  f"  line {mutant.line} of {name}", flush=True)
    report = "\n".join(table(results)) + "\n"
    (WORK / "table").write_text(report)
    print(report, end="")


if __name__ == "__main__":
    main()
