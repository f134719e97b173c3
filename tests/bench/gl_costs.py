#!/usr/bin/env python3
"""Prints what a pixel costs by state and size: make bench-costs.

    gl_costs.py SYSROOT PLUGIN PROGRAM [-f8888] [STATE...]

A STATE is words of gl_costs.c, such as "bilinear 4444 blend"; without any, those
below are measured. Columns are the sides of quads, in pixels.
"""

import subprocess
import sys

SIZES = (3, 8, 25, 60, 120, 340)
STATES = (
    "",
    *("nearest", "bilinear", "bilinear unlike", "bilinear trilinear"),
    *(f"bilinear {format}" for format in "4444 5551 8888 l8 a8 la88".split()),
    *(f"bilinear width={w} height={h}" for w, h in ((1, 1), (8, 8), (256, 8), (1024, 1024))),
    *("bilinear clamp", "bilinear white", "bilinear replace", "bilinear scissor"),
    *(f"bilinear spread={percent}" for percent in (5, 20, 50)),
    *("bilinear density=25", "bilinear density=400", "bilinear density=400 mipmaps"),
    *("sun", "lamp", "fog", "bilinear fog", "bilinear 8888 alphatest"),
    *("blend", "bilinear 8888 blend", "bilinear 8888 alphatest blend"),
    *("glow", "bilinear 8888 glow", "bilinear 8888 premultiplied", "bilinear multiply"),
    *("bilinear lequal", "bilinear always", "bilinear gequal", "bilinear nodepth"),
    *("bilinear keepdepth", "bilinear stencil", "bilinear count", "bilinear mask"),
    *("nearest second", "bilinear second", "bilinear add", "bilinear decal 8888"),
    *("bilinear interpolate", "bilinear dot3"),
    *("bilinear mipmaps trilinear density=400", "offset"),
    *("lines", "lines line=4", "lines smooth", "lines line=4 smooth blend"),
    *("points", "points smooth", "points smooth blend"),
)


def measure(command, states):
    """Instructions a pixel of each state."""
    done = subprocess.run([*command, *states], capture_output=True, text=True)
    counts = [int(line[8:]) for line in done.stderr.splitlines() if line.startswith("region: ")]
    pixels = [int(line.split()[0]) for line in done.stdout.splitlines()]
    if done.returncode != 0 or len(counts) != len(states):
        sys.exit(f"gl_costs.py: the program fails: {done.stderr}")
    return [count / own for count, own in zip(counts, pixels)]


def main():
    sysroot, plugin, program, *rest = sys.argv[1:]
    options = [word for word in rest if word.startswith("-")]
    states = [word for word in rest if not word.startswith("-")] or STATES
    command = ["qemu-arm", "-cpu", "arm1136", "-L", sysroot, "-plugin", plugin, "-d", "plugin"]
    command += [program, *options]
    print("| instructions a pixel |", " | ".join(map(str, SIZES)), "|")
    print("|---|" + "---|" * len(SIZES))
    for state in states:
        row = measure(command, [f"{state} size={size}" for size in SIZES])
        cells = " | ".join(f"{value:.0f}" for value in row)
        print(f"| {state or 'no texture'} | {cells} |", flush=True)


main()
