#!/usr/bin/env python3
"""mutants.py [--number N] [--seed S] [--folder app/demo]...
           [--suites REGEX] [--seconds S]

Draws N mutants of app and platform (draw.py): copies of one source file with one
small fault. Each is compiled in build/mutants/tree, a copy of the sources, and
linked in place of its object into the suites of this machine that concern it,
until one of them fails: the unit tests of its part of limber, the golden
pictures, films and texts, the command line and the demos' runs. Suites that found a
mutant of the same file come first, then quick ones before slow ones, and at last the
part's unit tests with the sanitizers; for a mutant that does not give something back
these come first. --suites leaves out those whose names do not begin like REGEX, and
--seconds those that take more than S seconds of a processor.
A suite that never calls the mutant's function is left out, too (reach.py).
Prints each mutant, by what it was found or that it SURVIVES, and a table by folder,
which stays in build/mutants/table.

A mutant that does not compile, or whose code has the same bytes as before, is
drawn again. So is one that tests/mutants/equivalent.txt names: it behaves like
the source. A suite that fails without a mutant, too, is left out, and named.
"""
import argparse
import collections
import contextlib
import json
import os
import pathlib
import random
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import time

import draw
import reach

TOP = pathlib.Path(__file__).resolve().parents[2]
WORK = TOP / "build/mutants"
TREE = WORK / "tree"
EQUIVALENT = pathlib.Path(__file__).with_name("equivalent.txt")
SECONDS = WORK / "seconds.json"
MUTANT = "build/host/mutant.o"
# Beside the stand-ins for GL libraries, which unit tests look for in their folder,
# and the command line's in its folder's folder "unit".
PROGRAM = "build/host/unit/mutant"
LIBRARY = "build/host/liblimber.a"
SANITIZED = "build/asan/liblimber.so"
SANITIZERS = "sanitizers"
# What does not give something back is tried with the sanitizers first.
LEAK = re.compile(r".*: without .*(free|release|destroy|decref|close).* in: ")
SUITE_S = 600
SUITE_BYTES = 8 << 30
SANITIZED_S = 120


def run(command, cpu_s=None, most_bytes=SUITE_BYTES):
    """Whether the command ended well, in the copy, within its limits."""
    def limit():
        if cpu_s:
            resource.setrlimit(resource.RLIMIT_CPU, (cpu_s, cpu_s))
            resource.setrlimit(resource.RLIMIT_AS, (most_bytes, most_bytes))

    process = subprocess.Popen(
        ["timeout", "--signal=KILL", str(SUITE_S), *command], cwd=TREE,
        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL, start_new_session=True, preexec_fn=limit,
        env={**os.environ, "LIMBER": PROGRAM})
    try:
        return process.wait() == 0
    finally:
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass


def make(*targets):
    return run(["make", "-j2", "--no-print-directory", *targets])


def copy_tree():
    """Copies the sources that have changed, and what was built of them."""
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=TOP, check=True, stdout=subprocess.PIPE).stdout.split(b"\0")
    names = {name for name in filter(None, map(os.fsdecode, listed))
             if (TOP / name).is_file()}
    for name in names:
        source, copy = TOP / name, TREE / name
        if not same_file(source, copy):
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(source, copy)
    for copy in TREE.rglob("*"):
        name = copy.relative_to(TREE)
        if name.parts[0] != "build" and copy.is_file() and str(name) not in names:
            copy.unlink()
    for part in ("host", "gen", "reached", "asan"):
        if (TOP / "build" / part).exists() and not (TREE / "build" / part).exists():
            shutil.copytree(TOP / "build" / part, TREE / "build" / part,
                            symlinks=True)
    shutil.copy2(TOP / "build/test-packages.stamp", TREE / "build")
    stand_ins = (TREE / PROGRAM).parent / "unit"
    if not stand_ins.is_symlink():
        stand_ins.parent.mkdir(exist_ok=True)
        stand_ins.symlink_to(".")


def same_file(a, b):
    return b.exists() and a.stat().st_size == b.stat().st_size and \
        a.read_bytes() == b.read_bytes()


def strip(*names):
    """Takes the lines of the source out of objects, without a new date."""
    run(["strip", "--strip-debug", "--preserve-dates", *names])


def link_commands(programs):
    """The command by which make links each program with limber's library."""
    shown = subprocess.run(
        ["make", "-n", "V=1", "--no-print-directory", "-W", LIBRARY, *programs],
        cwd=TREE, check=True, stdout=subprocess.PIPE, text=True).stdout
    lines = shown.replace("\\\n", " ").splitlines()
    return {program: next(line for line in lines if f" -o {program} " in line)
            for program in programs}


def without_source(link, path):
    """The link command without objects of a source file: a test of libgpiod's
    first generation compiles the driver once more, with that header."""
    return re.sub(rf" build/host/obj/(?:\w+/)?{re.escape(path[:-2])}\.o(?= )", "",
                  link)


class Suite:
    """A test program or script: its command, the program of which PROGRAM is a
    copy with the mutant, and what else make builds for it."""

    def __init__(self, name, program, command, *others):
        self.name = name
        self.program = program
        self.command = command
        self.others = others


def text_groups():
    """How the names of reference texts begin: "compare", "film-walker"..."""
    names = (path.stem for path in (TREE / "tests/golden/texts").glob("*.txt"))
    return sorted({re.match(r"(?:film-)?[^-]*", name)[0] for name in names})


def all_suites():
    unit = TREE / "tests/unit"
    limber = "build/host/limber"
    for test in sorted(unit.rglob("test_*.c")):
        program = f"build/host/unit/{test.stem}"
        yield Suite(str(test.relative_to(unit)), program, [PROGRAM])
    yield Suite("golden-exact", limber,
                ["tests/golden/golden.sh", "exact", "build/golden-exact", PROGRAM],
                "build/host/compare_png")
    for group in text_groups():
        yield Suite(f"golden-{group}", limber,
                    ["env", f"TEXTS={group}\\b", "tests/golden/texts.py", "check",
                     "build/golden-texts", PROGRAM])
    for script in sorted((TREE / "tests/cli").glob("*.sh")):
        name = str(script.relative_to(TREE / "tests"))
        yield Suite(name, limber, [f"tests/{name}"],
                    "build/host/unit/fake_gles.so")


class Judge:
    """Tries mutants on the suites that take at most so many seconds of a
    processor, which are kept for the next run."""

    def __init__(self, names, most_s, paths):
        self.most_s = most_s
        self.seconds = json.loads(SECONDS.read_text()) if SECONDS.exists() else {}
        self.finders = collections.Counter()
        self.sound = set()
        self.sanitized = {}
        self.linked = None
        self.reach = reach.Reach(TREE, WORK)
        self.with_sanitizers = re.match(names, SANITIZERS)
        parts = tuple({folder_of(path) for path in paths})
        self.suites = [suite for suite in all_suites()
                       if (suite.name.startswith((*parts, "golden", "cli"))
                           or suite.name.endswith("test_demo_runs.c"))
                       and re.match(names, suite.name)]
        if not make(reach.NOTED, *(name for suite in self.suites
                                   for name in (suite.program, *suite.others))):
            sys.exit("limber: the suites cannot be built: run make")
        self.reach.build()
        strip(LIBRARY, *map(str, (TREE / "build/host/obj").rglob("*.o")))
        self.link = link_commands({suite.program for suite in self.suites})

    def concerned(self, path):
        """The suites that concern a file, those that find its mutants soonest
        first."""
        part = folder_of(path)
        words = set(re.split(r"[-/_.]", path))

        def order(suite):
            common = words & set(re.split(r"[-/_.]", suite.name))
            seconds = self.seconds_of(suite)
            return (-self.finders[path, suite.name], int(seconds),
                    -len(common), seconds)

        return sorted((suite for suite in self.suites
                       if suite.name.startswith((part, "golden", "cli"))
                       or suite.name.endswith("test_demo_runs.c")), key=order)

    def contain(self, suite, path=None):
        """Links the suite's program with the mutant of a source file, or without;
        false if a test replaces its functions. Suites share the program."""
        if self.linked == (suite.program, path):
            return True
        link = self.link[suite.program].replace(
            f" -o {suite.program} ",
            f" -o {PROGRAM} {MUTANT} " if path else f" -o {PROGRAM} ")
        made = run(shlex.split(without_source(link, path) if path else link))
        self.linked = (suite.program, path) if made else None
        return made

    def calls(self, suite, mutant):
        """Whether a suite calls the mutant's function, or may do so."""
        program = TREE / suite.program
        link = self.link[suite.program]
        if without_source(link, mutant.path) != link:
            return True

        def noted():
            self.linked = None
            noting = link.replace(
                f" -o {suite.program} ", f" -o {PROGRAM} ").replace(
                    f" {LIBRARY} ", f" {reach.NOTED} {reach.NOTER} ")
            return run(shlex.split(noting)) and run(suite.command)

        return self.reach.calls(suite, program, mutant, noted, TREE / PROGRAM)

    def passes(self, suite):
        """Runs a suite without a mutant, and keeps how long it takes."""
        begun = resource.getrusage(resource.RUSAGE_CHILDREN)
        passed = self.contain(suite) and run(suite.command)
        ended = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.seconds[suite.name] = None if not passed else (
            ended.ru_utime - begun.ru_utime + ended.ru_stime - begun.ru_stime)
        SECONDS.write_text(json.dumps(self.seconds))
        if passed:
            self.sound.add(suite)
        else:
            print(f"left out, as it fails without a mutant: {suite.name}",
                  flush=True)
            self.suites.remove(suite)
        return passed

    def finds(self, suite, mutant):
        """Whether the suite is to be run, and fails with the mutant alone."""
        if self.seconds.get(suite.name) is None and not self.passes(suite):
            return False
        seconds = self.seconds[suite.name]
        return seconds <= self.most_s and self.calls(suite, mutant) and \
            self.contain(suite, mutant.path) and \
            not run(suite.command, 5 + 5 * int(seconds)) and \
            (suite in self.sound or self.passes(suite))

    def finder(self, mutant):
        """The first suite that finds the mutant, or None."""
        for suite in self.concerned(mutant.path):
            if self.finds(suite, mutant):
                self.finders[mutant.path, suite.name] += 1
                return suite
        return None

    def compiled(self, mutant, target):
        """Compiles the mutant; false if that fails or changes no byte."""
        before = (TREE / target).read_bytes()
        self.linked = None
        with in_tree(mutant, target):
            if not make(target):
                return False
            strip(target)
            shutil.copy(TREE / target, TREE / MUTANT)
            return (TREE / target).read_bytes() != before

    def seconds_of(self, suite):
        return self.seconds.get(suite.name) or 0

    def sanitizers_find(self, mutant):
        """Whether a unit test of its part fails with the sanitizers."""
        part = folder_of(mutant.path)
        tests = [f"build/asan/unit/{pathlib.Path(suite.name).stem}"
                 for suite in sorted(self.suites, key=self.seconds_of)
                 if suite.name.startswith(part) and self.calls(suite, mutant)]
        each = ["sh", "-c", 'for test; do "$test" || exit; done', "sh"]
        for test in tests:
            if test not in self.sanitized:
                self.sanitized[test] = make(test) and run([test])
                if not self.sanitized[test]:
                    print(f"left out, as it fails without a mutant: {test}",
                          flush=True)
        tests = [test for test in tests if self.sanitized[test]]
        target = f"build/asan/obj/{mutant.path[:-2]}.o"
        with in_tree(mutant, target, SANITIZED):
            return make(SANITIZED) and \
                not run([*each, *tests], SANITIZED_S, resource.RLIM_INFINITY)

    def verdict(self, mutant):
        """None for a mutant that is none; otherwise (found, by what)."""
        target = f"build/host/obj/{mutant.path[:-2]}.o"
        leaks = LEAK.match(mutant.describe((TREE / mutant.path).read_text()))
        if not self.compiled(mutant, target):
            return None
        if leaks and self.with_sanitizers and self.sanitizers_find(mutant):
            return True, SANITIZERS
        suite = self.finder(mutant)
        if suite:
            return True, suite.name
        if not leaks and self.with_sanitizers and self.sanitizers_find(mutant):
            return True, SANITIZERS
        return False, None


@contextlib.contextmanager
def in_tree(mutant, *made):
    """Puts the mutant into the copy of the sources, and at the end the source and
    what was made of it back, with their dates."""
    source = TREE / mutant.path
    kept = {path: (path.read_bytes(), path.stat())
            for path in (source, *(TREE / name for name in made))}
    try:
        source.write_text(mutant.apply(source.read_text()))
        yield
    finally:
        for path, (content, status) in kept.items():
            path.write_bytes(content)
            os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns))


def folder_of(path):
    parts = path.split("/")
    return "/".join(parts[:2]) if len(parts) > 2 else parts[0]


def sources(folders):
    """The C files that this machine's tests build, below the folders."""
    names = subprocess.run(["git", "ls-files", "*.c"], cwd=TOP, check=True,
                           stdout=subprocess.PIPE, text=True).stdout.split()
    return [name for name in names if name.startswith(("app/", "platform/"))
            and not re.search(r"/arm/|gpiod/v2/|instruction_count", name)
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
    parser.add_argument("--suites", default="")
    parser.add_argument("--seconds", type=float, default=120)
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
    judge = Judge(options.suites, options.seconds, texts)
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
