#!/usr/bin/env python3
"""play_check.py LIMBER PLAY_COST MODEL.so SYSROOT FILE[@CLIP]...: plays quotes.

For each row that `limber compare --clip` quotes, it plays the file of the row
on the timing model (play_cost.c) and compares instructions and cycles of a
frame: of posing, of drawing, and of both; of the model itself, drawing in
pictures of other sizes, too. Quoted and played may differ by 10%. It prints TAP.
"""
import json
import os
import struct
import subprocess
import sys
import tempfile

TOLERANCE = 0.10
RATE_HZ = 60
FRAMES_MAX = 300  # as in play_cost.c
MOMENTS = 6  # as in play_cost.c
SIZES = ("480x640", "240x320", "800x480")
# Below this a frame is a few cache misses, of which one more is 10%.
CYCLES_MIN = 12000
MHZ = 532


def played(tools, path, clip, rate_hz, size):
    """Cycles and instructions of an average frame: posing, drawing."""
    program, model_so, sysroot = tools
    run = subprocess.run(
        ["qemu-arm", "-cpu", "arm1136", "-L", sysroot, "-plugin", model_so,
         program, path, clip, str(rate_hz), "0", *size.split("x")],
        check=True, capture_output=True, text=True)
    cost = [[0.0, 0.0], [0.0, 0.0]]
    frames = 0
    for line in (run.stdout + run.stderr).splitlines():
        words = line.split()
        if words[:1] == ["frames"]:
            frames = int(words[1])
        elif words[:1] == ["region"]:
            values = dict(zip(words[2::2], words[3::2])) \
                if len(words) % 2 == 0 else dict(zip(words[2:], words[3:]))
            drawn = words[1].endswith("#3")
            for i, name in enumerate(("cycles", "instructions")):
                cost[drawn][i] += float(values[name]) / (
                    MOMENTS if drawn else frames)
    return cost


def compared(quoted, cycles, instructions):
    """Whether the figures agree, and by how much they differ."""
    us = cycles / MHZ
    off = [quoted[0] / us - 1, quoted[1] / instructions - 1]
    good = all(abs(o) <= TOLERANCE for o in off) or (
        cycles < CYCLES_MIN and
        abs(quoted[0] - us) * MHZ < TOLERANCE * CYCLES_MIN)
    return good, (f"{quoted[0]:.1f} us quoted, {us:.1f} played"
                  f" ({off[0]:+.1%}), {off[1]:+.1%} instructions")


def quotes(row):
    """Microseconds and instructions of posing, drawing and both."""
    whole, drawing = ([row[name][figure] for figure in
                       ("us_per_frame", "instructions_per_frame")]
                      for name in ("arm11_predicted", "arm11_drawing"))
    posing = [w - d for w, d in zip(whole, drawing)]
    return {"posing": posing, "drawing": drawing, "whole": whole}


def file_of(row, model, baked):
    name = row["name"]
    if name.startswith("morph, "):
        kind = "morph" if name.endswith("fitted") else "morph-even"
        return os.path.join(baked, f"{kind}-{row['keys']}.glb")
    if name == "rigid parts":
        return os.path.join(baked, "rigid.glb")
    if "influence" in name:
        return os.path.join(baked, f"skin-{name.split(', ')[1][0]}.glb")
    plain = os.path.join(baked, "skin.glb")
    return plain if name == "skin" and os.path.exists(plain) else model


def has_clips(path):
    with open(path, "rb") as file:
        head = file.read(20)
        text = file.read(struct.unpack_from("<I", head, 12)[0])
    return "animations" in json.loads(text)


def compare(limber, model, clip, *options):
    """The rows of the table that can be played."""
    report = json.loads(subprocess.run(
        [limber, "compare", model, "--clip", clip, "--format", "json", *options],
        check=True, capture_output=True, text=True).stdout)
    return [row for row in report["candidates"] if row["listed"]]


class Tap:
    """Prints a line for each figure that is compared."""

    def __init__(self):
        self.count = self.failed = 0

    def check(self, name, quoted, cycles, instructions):
        good, figures = compared(quoted, cycles, instructions)
        self.count += 1
        self.failed += not good
        print(f"{'ok' if good else 'not ok'} {self.count} - {name}: {figures}",
              flush=True)


def check_frames(tap, limber, tools, model, clip, baked):
    """All rows, in pictures of the first size."""
    for row in compare(limber, model, clip, "--error", "1", "--size", SIZES[0],
                       "--export", baked):
        path = file_of(row, model, baked)
        if row["name"] == "rigid parts" and not has_clips(path):
            continue  # the clip has nothing but weights of targets
        posing, drawing = played(
            tools, path, clip if path == model else "0", RATE_HZ, SIZES[0])
        costs = {"posing": posing, "drawing": drawing,
                 "whole": [p + d for p, d in zip(posing, drawing)]}
        for step, quoted in quotes(row).items():
            tap.check(f"{os.path.basename(model)} {clip}, {row['name']}, {step}",
                      quoted, *costs[step])


def check_drawing(tap, limber, tools, model, clip, size):
    """The model's drawing in pictures of another size."""
    row = compare(limber, model, clip, "--error", "100", "--size", size)[0]
    _, drawing = played(tools, model, clip, 1, size)
    tap.check(f"{os.path.basename(model)} {clip}, drawing, {size}",
              quotes(row)["drawing"], *drawing)


def main():
    limber, tools = sys.argv[1], sys.argv[2:5]
    tap = Tap()
    for model in sys.argv[5:]:
        model, _, clip = model.partition("@")
        clip = clip or "0"
        with tempfile.TemporaryDirectory() as baked:
            check_frames(tap, limber, tools, model, clip, baked)
        for size in SIZES[1:]:
            check_drawing(tap, limber, tools, model, clip, size)
    print(f"1..{tap.count}")
    return tap.failed > 0


if __name__ == "__main__":
    sys.exit(main())
