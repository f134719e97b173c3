#!/usr/bin/env python3
"""draw_fit.py LIMBER PLAY_COST MODEL.so SYSROOT TABLE.c FILE[@CLIP]...

Fits what drawing costs. It plays each file, and its rigid parts as `limber
compare` exports them, in pictures of several sizes on the timing model
(play_cost.c). It divides the cycles and the instructions of drawing among what
the pictures consist of (platform/gl/gl_counts.h) by least squares of relative
errors, with no cost below zero; pictures of the board's size count more, and those
of which an earlier fit was far. It writes the costs into TABLE.c and prints how far
each picture is from them. The clip "-" is the rest pose.
"""
import operator
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

from play_check import run_play_cost

SIZES = ((480, 640), (240, 320), (800, 480))
# How much a picture counts: those of the board's panel more.
WEIGHTS = {SIZES[0]: 1.5}
# What each takes about, in cycles and instructions, as the functions' profiles
# show it: where pictures do not tell, a cost stays near it.
GUESSED = {
    "frame": (26000, 20000),
    "pixel": (0.8, 0.4),
    "call": (12000, 5000),
    "listed": (170, 95),
    "vertex": (200, 85),
    "again": (130, 85),
    "single": (400, 170),
    "shaded": (450, 150),
    "hidden": (10, 9),
    "skipped": (500, 200),
    "fine": (10, 8),
}
# The same of a triangle, a row and a pixel.
GUESSED_KINDS = {
    "flat": ((300, 60, 8), (200, 40, 5)),
    "plain": ((500, 80, 20), (350, 50, 8)),
    "textured": ((600, 150, 60), (350, 100, 40)),
    "backdrop": ((20000, 60, 3), (10000, 30, 1)),
    "ground": ((20000, 100, 10), (10000, 60, 6)),
    "spans": ((1300, 170, 27), (900, 100, 17)),
    "spans_textured": ((2800, 500, 80), (2000, 300, 45)),
    "spans_divided": ((4400, 900, 108), (3500, 500, 70)),
    "spans_nearest": ((2500, 300, 50), (1600, 200, 30)),
    "mixed": ((2200, 140, 65), (1600, 80, 45)),
    "tested": ((3000, 250, 150), (1500, 190, 97)),
    "tested_spans": ((4000, 500, 90), (2500, 300, 60)),
    "mixed_textured": ((3000, 250, 150), (1500, 190, 97)),
    "mixed_spans": ((4000, 500, 150), (3000, 300, 95)),
    "mixed_divided": ((5000, 1000, 180), (4000, 550, 120)),
    "colored": ((300, 60, 5), (200, 40, 3)),
    "bent": ((1150, 30, 0.1), (550, 14, 0.1)),
    "deep": ((1, 1, 1), (1, 1, 0.4)),
    "second": ((500, 100, 30), (300, 60, 18)),
    "crossed": ((300, 250, 3), (200, 200, 2)),
    "parted": ((1, 200, 26), (1, 90, 14.6)),
    "added": ((300, 80, 30), (150, 50, 20)),
}
for kind, guesses in GUESSED_KINDS.items():
    for what, *guess in zip(("triangle", "row", "pixel"), *guesses):
        GUESSED[f"{kind}_{what}"] = guess
GUESS_WEIGHT = 0.03
# These are known from profiles of the functions that do nothing else.
MEASURED = {"bent_triangle", "bent_row", "bent_pixel"}
MEASURED_WEIGHT = 1.0
# Pictures that are off by more than this count more in the next fit: with these
# fits two of 195 are off by more than 10%.
ERROR_USUAL = 0.02
FITS = 16
ROUNDS = 1000


def play(tools, path, clip, size):
    """What a picture consists of, and its cycles and instructions."""
    moments = 1 if clip == "-" else 6
    text, regions = run_play_cost(tools, path, clip, 1, 0, *size, moments)
    counts = next(line.split()[1:] for line in text.splitlines()
                  if line.startswith("counts "))
    return ([1.0, size[0] * size[1], *(float(n) / moments for n in counts)],
            [regions[3][name] / moments for name in ("cycles", "instructions")])


def solve(matrix, right, cost):
    """Improves costs >= 0 towards matrix * costs = right, one after another."""
    for _ in range(ROUNDS):
        for j, row in enumerate(matrix):
            if row[j] > 0.0:
                off = right[j] - sum(map(operator.mul, row, cost))
                cost[j] = max(0.0, cost[j] + off / row[j])


def fit(rows, wanted, guessed, weights):
    """The costs x >= 0 with small relative errors row . x / wanted - 1: the sum of
    (weight * error) squared is least, where large errors get more weight."""
    count = len(rows[0])
    guess_weights = [MEASURED_WEIGHT if name in MEASURED else GUESS_WEIGHT
                     for name in GUESSED]
    rows = [[value / y for value in row] for row, y in zip(rows, wanted)]
    cost = list(guessed)
    errors = [0.0] * len(rows)  # squares, means of the last fits
    for _ in range(FITS):
        squares = [weight ** 2 * (1 + error / ERROR_USUAL ** 2)
                   for weight, error in zip(weights, errors)]
        matrix = [[sum(square * row[j] * row[k] for square, row in zip(squares, rows))
                   for k in range(count)] for j in range(count)]
        right = [sum(square * row[j] for square, row in zip(squares, rows))
                 for j in range(count)]
        for j in range(count):
            matrix[j][j] += (guess_weights[j] / guessed[j]) ** 2
            right[j] += guess_weights[j] ** 2 / guessed[j]
        solve(matrix, right, cost)
        errors = [0.5 * error + 0.5 * (sum(map(operator.mul, row, cost)) - 1) ** 2
                  for error, row in zip(errors, rows)]
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
                     for pair, name in zip(pairs, GUESSED))
    text, count = re.subn(r"(each\[DRAW_WORKS\] = \{\n).*?(\n\};)",
                          lambda match: match[1] + rows + match[2], text,
                          flags=re.DOTALL)
    if count != 1:
        sys.exit(f"{path}: it has no table each[DRAW_WORKS]")
    with open(path, "w") as file:
        file.write(text)


def main():
    limber, *tools, table = sys.argv[1:6]
    with tempfile.TemporaryDirectory() as folder:
        jobs = [(*file, size) for file in files_of(
            limber, sys.argv[6:], folder) for size in SIZES]
        with ThreadPoolExecutor(2) as pool:
            played = list(pool.map(
                lambda job: play(tools, *job), jobs))
    rows = [row for row, _ in played]
    weights = [WEIGHTS.get(size, 1.0) for *_, size in jobs]
    costs = [fit(rows, [cost[i] for _, cost in played],
                 [guess[i] for guess in GUESSED.values()], weights)
             for i in range(2)]
    write_table(table, costs)
    for (path, clip, size), (row, cost) in zip(jobs, played):
        told = [sum(a * b for a, b in zip(row, x)) for x in costs]
        print(f"{'/'.join(path.split('/')[-2:])} {clip} {size[0]}x{size[1]}: "
              f"{cost[0]:.0f} cycles ({told[0] / cost[0] - 1:+.1%}), "
              f"{cost[1]:.0f} instructions ({told[1] / cost[1] - 1:+.1%})")


if __name__ == "__main__":
    main()
