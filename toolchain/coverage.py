#!/usr/bin/env python3
"""coverage.py DIR [lines.info]: turns what the programs in DIR have counted into
the pages DIR/html, prints how many lines of each folder of app and platform the
tests reached, and lists the others in DIR/unreached.txt. lines.info are counts
that lcov has collected before.

A run of lines that no test reached has one of three reasons:
- "failure": it only passes on the failure of a call, such as a lack of memory;
  make faults lets each of these calls fail.
- stated: a comment between it and the line reached before says
  "Not counted: REASON".
- none: a test is missing.
"""
import collections
import pathlib
import re
import subprocess
import sys

TOP = pathlib.Path.cwd()
STATED = re.compile(r"Not counted: ((?:[^*]|\*(?!/))*?)\s*\*/")
# What follows a call that failed: it releases, and returns an error.
FAILURE = re.compile(
    r"(return( \(?-E\w+\)?| -?errno| -?\w*(error|result|status)| NULL| false| -1)?"
    r"|goto \w+|break|else"
    r"|(int )?\*?[\w.>-]*(error|result)\w* = -?(E\w+|errno|error|last_error\(\))"
    r"|[\w>-]+->error = [\w>-]+->error \? [\w>-]+->error : -ENOMEM"
    r"|((return )?(error )?\? |return |[\w.>-]*error = )"
    r"(\w*(fail|no)_memory|memory_budget_fail|last_error)\(.*\)( : \w+)?"
    r"|(\(void\))?\w*(free|close|release|destroy|unlink|unmap|munmap)\w*\(.*\)"
    r"|\*?[\w.>-]+ = (NULL|0|false|-1)"
    r"|log_error\(.*(memory|strerror).*\))")


def quietly(*command):
    """Runs a command, and shows what it has to say only if it fails."""
    ended = subprocess.run(command, stdout=subprocess.PIPE,
                           stderr=subprocess.STDOUT, text=True)
    if ended.returncode:
        sys.exit(ended.stdout)


def capture(folder):
    quietly("lcov", "--quiet", "--capture", "--directory", f"{folder}/obj",
            "--base-directory", ".", "--no-external", "--ignore-errors",
            "source", "--output-file", f"{folder}/all.info")
    quietly("lcov", "--quiet", "--extract", f"{folder}/all.info",
            f"{TOP}/app/*", f"{TOP}/platform/*",
            "--output-file", f"{folder}/lines.info")
    quietly("genhtml", "--quiet", "--ignore-errors", "source", "--prefix",
            str(TOP), "--title", "limber", "--output-directory",
            f"{folder}/html", f"{folder}/lines.info")
    return folder / "lines.info"


def read_counts(info):
    """{file: {line: how often it ran}}, with paths from the top folder."""
    counts = {}
    for line in info.read_text().splitlines():
        kind, _, value = line.partition(":")
        if kind == "SF":
            path = pathlib.Path(value)
            name = str(path.relative_to(TOP) if path.is_absolute() else path)
            lines = counts.setdefault(name, {})
        elif kind == "DA":
            number, count = value.split(",")[:2]
            lines[int(number)] = lines.get(int(number), 0) + int(count)
    return counts


def runs_of(lines):
    """(first, last, before) of lines that were not reached, one after another;
    before is the last one that was reached."""
    run, before = None, 0
    for number in sorted(lines):
        if lines[number]:
            if run:
                yield run[0], run[1], before
            run, before = None, number
        else:
            run = (run[0] if run else number, number)
    if run:
        yield run[0], run[1], before


def is_failure(text):
    text = re.sub(r"/\*.*?\*/|\"(\\.|[^\"])*\"",
                  lambda found: found[0] if "memory" in found[0] else "",
                  text, flags=re.S)
    parts = (" ".join(part.split()) for part in re.split(r"[;{}]|^\w+:$", text,
                                                          flags=re.M))
    return all(FAILURE.fullmatch(part) for part in parts if part)


def reason_of(source, first, last, before):
    """The reason why no test reaches the lines, or None."""
    stated = STATED.search("\n".join(source[before:last]))
    if stated:
        return " ".join(stated[1].replace("*", " ").split())
    end = last
    while end < len(source) and ";" not in source[end - 1]:
        end += 1
    return "failure" if is_failure("\n".join(source[first - 1:end])) else None


def folder_of(name):
    parts = name.split("/")
    return "/".join(parts[:2]) if len(parts) > 2 else parts[0] + "/"


def examine(counts, listing):
    """[all, reached, of failures, with a stated reason] by folder."""
    table = collections.defaultdict(lambda: [0, 0, 0, 0])
    for name in sorted(counts):
        lines, row = counts[name], table[folder_of(name)]
        row[0] += len(lines)
        row[1] += sum(map(bool, lines.values()))
        source = (TOP / name).read_text().splitlines()
        for first, last, before in runs_of(lines):
            reason = reason_of(source, first, last, before)
            size = sum(first <= number <= last for number in lines)
            if reason:
                row[2 if reason == "failure" else 3] += size
            listing.write(f"{name}:{first}: {reason or 'a test is missing'}\n")
            if reason != "failure":
                listing.writelines(
                    f"\t{line}\n" for line in source[first - 1:last])
    return table


def main():
    folder = pathlib.Path(sys.argv[1])
    info = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else capture(folder)
    with open(folder / "unreached.txt", "w") as listing:
        table = examine(read_counts(info), listing)
    table["app and platform"] = [sum(column) for column in zip(*table.values())]
    lines = ["reached   lines  not reached: failures  stated  no test  folder"]
    for name, (size, reached, failures, stated) in table.items():
        lines.append(f"{100 * reached / size:6.1f}% {size:7} {failures:22} "
                     f"{stated:7} {size - reached - failures - stated:8}  "
                     f"{name}")
    text = "\n".join(lines) + "\n"
    (folder / "table").write_text(text)
    print(text, end="")
    print(f"The lines that no test reaches: {folder}/unreached.txt and "
          f"{folder}/html/index.html")


if __name__ == "__main__":
    main()
