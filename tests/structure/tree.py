#!/usr/bin/env python3
"""Holds the tree to the sizes, the one-way calls, the names and the prose that
CONTRIBUTING.md asks for, and speaks TAP: a test for each rule, with the places
that break it.

TREE is the folder of app/ and platform/ (this one). OBJECTS lists the folders
with the objects of app/ and platform/ (host and ARM); NM_ARM names the nm for
those of a folder called arm.
"""

import os
import pathlib
import re
import subprocess
import sys

FOLDER_FILES = 25
FILE_LINES = 500
BULLET_CHARACTERS = 240
SOURCES = {".c", ".h", ".S", ".inc", ".py", ".sh", ".js", ".mjs", ".mk", ".awk"}
CODE = {".c", ".h", ".S", ".inc"}

# External names that do not begin with a word of their path, each with its
# reason.
NAMES_ALLOWED = {
    "main": "C asks for it",
}


def files_below(tree, suffixes):
    """Paths below the tree, as text, without build/ and hidden folders."""
    found = []
    for folder, folders, names in os.walk(tree):
        folders[:] = sorted(
            f
            for f in folders
            if f not in ("node_modules", "__pycache__")
            and not f.startswith(".")
            and not (folder == str(tree) and f == "build")
        )
        for name in sorted(names):
            path = pathlib.Path(folder, name)
            if path.suffix in suffixes:
                found.append(path.relative_to(tree).as_posix())
    return found


def read(tree, path):
    return pathlib.Path(tree, path).read_text(encoding="utf-8", errors="replace")


def is_program(path):
    return path.startswith(("app/", "platform/"))


def stem(path):
    return path.rsplit(".", 1)[0]


def large_folders(tree):
    counts = {}
    for path in files_below(tree, SOURCES):
        folder = os.path.dirname(path)
        counts[folder] = counts.get(folder, 0) + 1
    return [
        f"{folder} has {count} source files"
        for folder, count in sorted(counts.items())
        if count > FOLDER_FILES
    ]


def long_files(tree):
    lines = ((p, read(tree, p).count("\n")) for p in files_below(tree, CODE))
    return [
        f"{p} has {n} lines"
        for p, n in lines
        if is_program(p) and n > FILE_LINES
    ]


def rings(uses):
    """The groups of names in which each uses each, in the end (Tarjan)."""
    order, low, stack, found = {}, {}, [], []

    def visit(name):
        order[name] = low[name] = len(order)
        stack.append(name)
        for other in sorted(uses.get(name, ())):
            if other not in order:
                visit(other)
                low[name] = min(low[name], low[other])
            elif other in stack:
                low[name] = min(low[name], order[other])
        if low[name] == order[name]:
            ring = [stack.pop()]
            while ring[-1] != name:
                ring.append(stack.pop())
            if len(ring) > 1:
                found.append(sorted(ring))

    for name in sorted(uses):
        if name not in order:
            visit(name)
    return [" and ".join(ring) for ring in sorted(found)]


def doubled_tests(tree):
    """Unit tests of one name: their programs would be one, the other never run."""
    first, found = {}, []
    for path in files_below(tree, {".c"}):
        name = os.path.basename(path)
        if path.startswith("tests/unit/") and name.startswith("test_"):
            if name in first:
                found.append(f"{first[name]} and {path} have one name")
            first.setdefault(name, path)
    return found


INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]*)"', re.M)


def rings_of_headers(tree):
    headers = [p for p in files_below(tree, {".h"}) if is_program(p)]
    return rings({p: set(INCLUDE.findall(read(tree, p))) for p in headers})


def rings_of_driver(tree):
    """Rings of the GL driver's files, where a .c file and its header are one."""
    uses = {}
    for path in files_below(tree, {".c", ".h"}):
        if path.startswith("platform/gl/soft/"):
            name = path[:-2]
            headers = INCLUDE.findall(read(tree, path))
            uses.setdefault(name, set()).update({h[:-2] for h in headers} - {name})
    return rings(uses)


def symbols_of(tree, folder):
    """(path, defined names, wanted names) of the objects whose source exists."""
    nm = "nm"
    if "arm" in pathlib.Path(folder).parts:
        nm = os.environ.get("NM_ARM", "arm-linux-gnueabi-nm")
    sources = {}
    for path in files_below(folder, {".o"}):
        for source in (stem(path) + ".c", stem(path) + ".S"):
            if is_program(source) and pathlib.Path(tree, source).exists():
                sources[f"{folder}/{path}"] = source
    if not sources:
        return []
    listing = subprocess.run(
        [nm, "-o", *sources], capture_output=True, text=True, check=True
    ).stdout
    found = {source: (source, set(), set()) for source in sources.values()}
    for line in listing.splitlines():
        path, _, row = line.partition(":")
        *_, kind, name = row.split()
        if kind == "U":
            found[sources[path]][2].add(name)
        elif kind in "TDBRGC":
            found[sources[path]][1].add(name)
    return list(found.values())


def rings_of_calls(symbols):
    where = {name: source for source, defined, _ in symbols for name in defined}
    uses = {}
    for source, _, wanted in symbols:
        used = {where[name] for name in wanted if name in where}
        uses.setdefault(source, set()).update(used - {source})
    return rings(uses)


def words_of(path):
    """What an external name of that file may begin with."""
    words = set(stem(path).split("/"))
    words |= set(os.path.basename(stem(path)).split("_"))
    return words | {word.rstrip("s") for word in words}


def unprefixed(symbols):
    return sorted(
        {
            f"{source} exports {name}"
            for source, defined, _ in symbols
            for name in defined
            if name.split("_")[0] not in words_of(source)
            and name not in NAMES_ALLOWED
        }
    )


def long_bullets(tree):
    found = []
    for path in files_below(tree, {".md"}):
        start, text = 0, ""
        for number, line in enumerate([*read(tree, path).split("\n"), ""], 1):
            if text and re.match(r"\s+[^\s\-*]", line):
                text += " " + line.strip()
                continue
            if len(text) > BULLET_CHARACTERS:
                found.append(f"{path}:{start} has a bullet of {len(text)} characters")
            start, text = number, ""
            if re.match(r"\s*[-*] ", line):
                text = line.strip()
    return found


def broken_literals(tree):
    """A literal that ends within a sentence and goes on in the literal below."""
    found = []
    for path in files_below(tree, {".c", ".h"}):
        if not is_program(path):
            continue
        lines = read(tree, path).split("\n")
        for number, (line, below) in enumerate(zip(lines, lines[1:]), 1):
            end = re.search(r'"((?:[^"\\]|\\.)*)"\s*\\?$', line)
            if not end or not re.match(r'\s*"', below):
                continue
            if not end[1].endswith("\\n") and re.search(r"[A-Za-z]{2}[,;:]? ?$", end[1]):
                found.append(f"{path}:{number} breaks a sentence")
    return found


def main():
    tree = pathlib.Path(os.environ.get("TREE", "."))
    folders = os.environ.get("OBJECTS", "build/host/obj build/arm/obj").split()
    symbols = [symbols_of(tree, folder) for folder in folders]
    every_symbol = [row for rows in symbols for row in rows]
    rules = [
        (f"a folder has at most {FOLDER_FILES} source files", large_folders(tree)),
        (f"a file of the program has at most {FILE_LINES} lines", long_files(tree)),
        ("each unit test has a name of its own", doubled_tests(tree)),
        ("headers do not include each other in rings", rings_of_headers(tree)),
        (
            "files of the GL driver do not include each other in rings",
            rings_of_driver(tree),
        ),
        (
            "files do not call each other in rings",
            sorted({ring for rows in symbols for ring in rings_of_calls(rows)}),
        ),
        ("an external name begins with a word of its path", unprefixed(every_symbol)),
        (
            f"a bullet of a page has at most {BULLET_CHARACTERS} characters",
            long_bullets(tree),
        ),
        ("a string literal holds whole lines", broken_literals(tree)),
    ]
    if not files_below(tree, CODE) or not all(symbols):
        rules.append(("there are files and objects to look at", ["nothing"]))
    failed = 0
    for number, (name, offences) in enumerate(rules, 1):
        failed += bool(offences)
        print(f"{'not ok' if offences else 'ok'} {number} - {name}")
        for offence in offences:
            print(f"# {offence}")
    print(f"1..{len(rules)}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
