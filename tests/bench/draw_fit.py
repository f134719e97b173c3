#!/usr/bin/env python3
"""draw_fit.py LIMBER PLAY_COST MODEL.so SYSROOT TABLE.c FILE[@CLIP]...

Fits what drawing costs. It plays each file, and its rigid parts as `limber
compare` exports them, in pictures of several sizes on the timing model
(play_cost.c). It divides the cycles and the instructions of drawing among what
the pictures consist of (platform/gl/gl_counts.h) by least squares of relative
errors, with no cost below zero. It writes the costs into TABLE.c and prints how
far each picture is from them. The clip "-" is the rest pose.
"""
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

SIZES = ((480, 640), (240, 320), (800, 480))
KINDS = ("flat", "plain", "textured", "ground", "spans", "spans_textured",
         "spans_divided", "mixed", "mixed_textured")
NAMES = ("frame", "pixel", "call", "listed", "vertex", "shaded",
         "hidden") + tuple(
    f"{kind}_{what}" for kind in KINDS for what in ("triangle", "row", "pixel"))
# What each takes about: where pictures do not tell, a cost stays near it.
GUESSED = (20000, 1, 9000, 60, 120, 250, 8, 150, 30, 8, 200, 30, 12, 300, 40, 45,
           20000, 60, 12, 900, 120, 15, 1300, 200, 70, 2500, 500, 80,
           900, 120, 60, 1300, 200, 90)
GUESS_WEIGHT = 0.015
ROUNDS = 3000


def play(program, model_so, sysroot, path, clip, size):
    """What a picture consists of, and its cycles and instructions."""
    moments = 1 if clip == "-" else 2
    run = subprocess.run(
        ["qemu-arm", "-cpu", "arm1136", "-L", sysroot, "-plugin", model_so,
         program, path, clip, "1", "0", *map(str, size), str(moments)],
        check=True, capture_output=True, text=True)
    counts, cost = None, None
    for line in (run.stdout + run.stderr).splitlines():
        words = line.split()
        if words[:1] == ["counts"]:
            counts = [float(word) / moments for word in words[1:]]
        elif words[:1] == ["region"] and words[1].endswith("#3"):
            cost = [float(words[words.index(name) + 1]) / moments
                    for name in ("cycles", "instructions")]
    return [1.0, size[0] * size[1], *counts], cost


def fit(rows, wanted):
    """The costs x >= 0 with the least sum of (row . x / wanted - 1) squared."""
    count = len(rows[0])
    scaled = [[value / y for value in row] for row, y in zip(rows, wanted)]
    for j in range(count):
        scaled.append([0.0] * count)
        scaled[-1][j] = GUESS_WEIGHT / GUESSED[j]
    rest = [1.0] * len(rows) + [GUESS_WEIGHT] * count
    norm = [sum(row[j] ** 2 for row in scaled) for j in range(count)]
    cost = [0.0] * count
    left = rest
    for _ in range(ROUNDS):
        for j in range(count):
            if norm[j] == 0.0:
                continue
            step = sum(row[j] * r for row, r in zip(scaled, left)) / norm[j]
            step = max(step, -cost[j])
            cost[j] += step
            left = [r - row[j] * step for row, r in zip(scaled, left)]
    return cost


def files_of(limber, names, folder):
    """The files and clips, with the rigid parts of those that have some."""
    files = []
    for number, name in enumerate(names):
        path, _, clip = name.partition("@")
        clip = clip or "0"
        files.append((path, clip))
        if clip == "-":
            continue
        baked = os.path.join(folder, str(number))
        subprocess.run([limber, "compare", path, "--clip", clip, "--error", "100",
                        "--export", baked], check=True, capture_output=True)
        rigid = os.path.join(baked, "rigid.glb")
        if os.path.exists(rigid):
            files.append((rigid, "0"))
    return files


def write_table(path, costs):
    """Replaces the rows between the braces of the table."""
    with open(path) as file:
        text = file.read()
    pairs = [f"\t{{{cycles:.4g}, {instructions:.4g}}}," for cycles, instructions
             in zip(*costs)]
    width = max(map(len, pairs))
    rows = "\n".join(f"{pair:{width}} /* {name.replace('_', ' ')} */"
                     for pair, name in zip(pairs, NAMES))
    text, count = re.subn(r"(each\[DRAW_WORKS\] = \{\n).*?(\n\};)",
                          lambda match: match[1] + rows + match[2], text,
                          flags=re.DOTALL)
    if count != 1:
        sys.exit(f"{path}: it has no table each[DRAW_WORKS]")
    with open(path, "w") as file:
        file.write(text)


def main():
    limber, program, model_so, sysroot, table = sys.argv[1:6]
    with tempfile.TemporaryDirectory() as folder:
        jobs = [(*file, size) for file in files_of(
            limber, sys.argv[6:], folder) for size in SIZES]
        with ThreadPoolExecutor(2) as pool:
            played = list(pool.map(
                lambda job: play(program, model_so, sysroot, *job), jobs))
    rows = [row for row, _ in played]
    costs = [fit(rows, [cost[i] for _, cost in played]) for i in range(2)]
    write_table(table, costs)
    for (path, clip, size), (row, cost) in zip(jobs, played):
        told = [sum(a * b for a, b in zip(row, x)) for x in costs]
        print(f"{'/'.join(path.split('/')[-2:])} {clip} {size[0]}x{size[1]}: "
              f"{cost[0]:.0f} cycles ({told[0] / cost[0] - 1:+.1%}), "
              f"{cost[1]:.0f} instructions ({told[1] / cost[1] - 1:+.1%})")


if __name__ == "__main__":
    main()
