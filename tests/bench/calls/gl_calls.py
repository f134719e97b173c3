#!/usr/bin/env python3
"""Prints what a draw call costs by what has changed since the last one.

    gl_calls.py SYSROOT PLUGIN PROGRAM

Instructions of the call without its triangles, and those of the functions that make
the change: see gl_calls.c.
"""

import subprocess
import sys

CHANGES = "nothing matrix color material texture array part blending projection".split()
STATES = ("", "lit", "textured", "lit textured", "lit tinted")


def measure(command, words):
    """A call's instructions, and those of the change before it."""
    done = subprocess.run([*command, *words], capture_output=True, text=True)
    counts = [int(line[8:]) for line in done.stderr.splitlines() if line.startswith("region: ")]
    if done.returncode != 0 or len(counts) != 12:
        sys.exit(f"gl_calls.py: the program fails: {done.stderr}")
    change, one, _, two = counts[8:]
    return f"{2 * one - two} + {change}"


def main():
    sysroot, plugin, program = sys.argv[1:]
    command = ["qemu-arm", "-cpu", "arm1136", "-L", sysroot, "-plugin", plugin, "-d", "plugin"]
    print("| changed |", " | ".join(state or "unlit" for state in STATES), "|")
    print("|---|" + "---|" * len(STATES))
    for change in CHANGES:
        cells = [measure([*command, program], [*state.split(), change]) for state in STATES]
        print(f"| {change} |", " | ".join(cells), "|", flush=True)


main()
