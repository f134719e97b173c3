"""Tells which functions a suite calls, so that a mutant is not tried on suites
that never call the function in which it is.

The library is built once more with -finstrument-functions (toolchain/trust.mk),
and reached.c notes each function that is called.
"""
import hashlib
import json
import pathlib
import re
import subprocess

CALLS_BYTES = 64 << 20
NOTED = "build/reached/liblimber.a"
NOTE = b"__cyg_profile_func_enter"
NOTER = "build/reached/reached.o"
SYMBOL = re.compile(r"\s*\d+: ([0-9a-f]+) +\w+ (FUNC|FILE) +(\w+) +\w+ +\w+ (\S+)$",
                    re.M)
SIGNATURE = re.compile(r"(?:^|[\s*])(\w+)\([^;{}#]*\)\s*\Z", re.S)


def function_at(text, line):
    """The name of the function that has a line, or None between functions.
    Only a function's braces stand at a row's begin."""
    rows = text.splitlines()
    first = line - 1
    while first >= 0 and rows[first] != "{":
        if first < line - 1 and rows[first].startswith("}"):
            return None
        first -= 1
    if first < 0:
        return None
    above = first
    while above > 0 and rows[above - 1] and rows[above - 1][0] not in "}#/":
        above -= 1
    found = SIGNATURE.search("\n".join(rows[above:first]))
    return found and found[1]


def plain(name):
    """A function's name without what GCC appends to those it makes of it."""
    return name.split(".")[0]


def symbols(program):
    """The address of each function, its file if it is static, and its name."""
    listed = subprocess.run(["readelf", "-sW", program], check=True,
                            stdout=subprocess.PIPE, text=True).stdout
    file = None
    for address, kind, binding, name in SYMBOL.findall(listed):
        if kind == "FILE":
            file = pathlib.Path(name).name
        else:
            yield (int(address, 16), file if binding == "LOCAL" else None,
                   plain(name))


class Reach:
    """Which functions each suite calls. Keeps it for the next run, until the
    suite's program or a file that suites read changes."""

    def __init__(self, tree, work):
        self.tree = tree
        self.marks = work / "calls"
        self.kept = work / "reach.json"
        self.of_suite = json.loads(self.kept.read_text()) \
            if self.kept.exists() else {}
        self.noted_names = {}
        self.data = hashlib.sha256()
        for path in sorted(tree.glob("tests/[!u]*/**/*")) + \
                sorted(tree.glob("assets/**/*")):
            if path.is_file() and "mutants" not in path.parts:
                self.data.update(path.read_bytes())

    def build(self):
        """Compiles reached.c, and makes the file into which it writes."""
        self.clear()
        subprocess.run(
            ["gcc", "-O2", "-fPIE", "-Wall", "-Wextra", "-Werror", "-c",
             f'-DCALLS="{self.marks}"', f"-DCALLS_BYTES={CALLS_BYTES}",
             "-o", NOTER, "tests/mutants/reached.c"], cwd=self.tree, check=True)

    def clear(self):
        with self.marks.open("w+b") as file:
            file.truncate(CALLS_BYTES)

    def calls(self, suite, program, mutant, run_noted, noted_program):
        """Whether the suite calls the mutant's function. What is not known counts
        as called: code between functions, a function that macros make, a suite
        that fails when its calls are noted. run_noted() builds noted_program and
        runs the suite with it."""
        text = (self.tree / mutant.path).read_text()
        function = function_at(text, mutant.line)
        if function not in self.noted(mutant.path):
            return True
        digest = self.data.copy()
        digest.update(repr(suite.command).encode() + program.read_bytes())
        key = digest.hexdigest()
        if self.of_suite.get(suite.name, [None])[0] != key:
            self.clear()
            names = called(noted_program, self.marks.read_bytes()) \
                if run_noted() else None
            self.of_suite[suite.name] = [key, names]
            self.kept.write_text(json.dumps(self.of_suite))
        names = self.of_suite[suite.name][1]
        file = pathlib.Path(mutant.path).name
        return names is None or f"{file}:{function}" in names or \
            f":{function}" in names

    def noted(self, path):
        """The functions of a source file whose calls are noted."""
        if path not in self.noted_names:
            file = self.tree / f"build/reached/obj/{path[:-2]}.o"
            noted = file.exists() and NOTE in file.read_bytes()
            self.noted_names[path] = \
                {name for _, _, name in symbols(file)} if noted else set()
        return self.noted_names[path]


def called(program, marks):
    """The functions whose bytes are set, as "FILE:NAME", and as ":NAME" if they are
    not static."""
    return sorted({f"{file or ''}:{name}"
                   for address, file, name in symbols(program)
                   if address < len(marks) and marks[address]})
