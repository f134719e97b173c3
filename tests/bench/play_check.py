#!/usr/bin/env python3
"""play_check.py LIMBER PLAY_COST MODEL.so SYSROOT FILE[@CLIP]... [--alone FILE[@CLIP]...]

Plays quotes. For each row that `limber compare --clip` quotes, it plays the file
of the row on the timing model (play_cost.c) and compares instructions and cycles
of a frame: of posing, of drawing, and of both; of the model itself, drawing in
pictures of other sizes, too. It also compares the model's instructions with those
of `limber play`, which frames the model by itself. Quoted and played may differ by 10%. Of files after
--alone only the model itself is played. It prints TAP.
"""
import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile

TOLERANCE = 0.10
RATE_HZ = 30
PLAYED_FRAMES = 6
SIZES = ("480x640", "240x320", "800x480")
# Below this a frame is a few cache misses, of which one more is 10%.
CYCLES_MIN = 12000
MHZ = 532


def run_play_cost(tools, *arguments):
    """What play_cost prints for these arguments, and its regions by number: of
    each the figures by name. TOOLS are the program, the plugin and the sysroot.

    It gets an empty environment. Its environment lies at the top of its stack, so
    other variables would move the stack and change which lines share a place in
    the caches: up to 1% of the cycles of a small picture.
    """
    program, model_so, sysroot = tools
    run = subprocess.run(
        ["qemu-arm", "-cpu", "arm1136", "-L", sysroot, "-plugin", model_so,
         program, *map(str, arguments)],
        check=True, capture_output=True, text=True, env={})
    regions = {}
    for line in run.stderr.splitlines():
        words = line.split()
        if words[:1] == ["region"]:
            figures = words[2:]
            regions[int(words[1].split("#")[1])] = dict(
                zip(figures[::2], map(int, figures[1::2])))
    return run.stdout, regions


def played(tools, path, clip, rate_hz, size=None):
    """Cycles and instructions of an average frame: posing and, with a size,
    drawing."""
    _, regions = run_play_cost(
        tools, path, clip, rate_hz, 0, *(size.split("x") if size else ()))
    # Region 1 samples, 2 poses: both begin once a frame. Region 3 draws.
    return [[sum(regions[number][name] / regions[number]["entries"]
                 for number in numbers)
             for name in ("cycles", "instructions")]
            for numbers in (((1, 2), (3,)) if size else ((1, 2),))]


def count_play(tools, path, clip, duration_s, frames):
    """The instructions of `limber play` that shows so many frames, which are
    spread over the clip."""
    play_cost, plugin, sysroot = map(pathlib.Path, tools)
    run = subprocess.run(
        ["qemu-arm", "-cpu", "arm1136", "-L", sysroot, "-plugin",
         plugin.with_name("insn_count.so"), "-d", "plugin",
         play_cost.parent.with_name("limber"), "play", path, "--clip", clip,
         "--speed", f"{duration_s * RATE_HZ / PLAYED_FRAMES:.4f}",
         "--clock", f"fixed:{RATE_HZ}", "--frames", str(frames), "--no-labels",
         "--config", "none", "--display", "null", "--gl", "soft",
         "--format", "rgb565", "--size", SIZES[0]],
        check=True, capture_output=True, text=True, env={})
    return int(re.search(r"^instructions: (\d+)", run.stderr, re.M).group(1))


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


def report_of(limber, model, clip, *options):
    return json.loads(subprocess.run(
        [limber, "compare", model, "--clip", clip, "--format", "json", *options],
        check=True, capture_output=True, text=True).stdout)


def compare(limber, model, clip, *options):
    """The rows of the table that can be played."""
    report = report_of(limber, model, clip, *options)
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

    def check_instructions(self, name, quoted, counted):
        off = quoted / counted - 1
        self.count += 1
        self.failed += abs(off) > TOLERANCE
        print(f"{'ok' if abs(off) <= TOLERANCE else 'not ok'} {self.count} - {name}:"
              f" {quoted / 1e6:.2f} million instructions quoted,"
              f" {counted / 1e6:.2f} played ({off:+.1%})", flush=True)


def check_frames(tap, limber, tools, model, clip, baked, alone):
    """The rows, in pictures of the first size."""
    drawings = {}  # played: key frames show the same, however many there are
    rows = compare(limber, model, clip, "--error", "1", "--size", SIZES[0],
                   "--export", baked)
    for row in rows[:1] if alone else rows:
        path = file_of(row, model, baked)
        if row["name"] == "rigid parts" and not has_clips(path):
            continue  # the clip has nothing but weights of targets
        shown = row["name"].split(",")[0] if "keys" in row["name"] else path
        posing, *drawing = played(
            tools, path, clip if path == model else "0", RATE_HZ,
            None if shown in drawings else SIZES[0])
        if drawing:
            drawings[shown] = drawing[0]
        drawing = drawings[shown]
        costs = {"posing": posing, "drawing": drawing,
                 "whole": [p + d for p, d in zip(posing, drawing)]}
        for step, quoted in quotes(row).items():
            tap.check(f"{os.path.basename(model)} {clip}, {row['name']}, {step}",
                      quoted, *costs[step])


def check_drawing(tap, limber, tools, model, clip, size):
    """The model's drawing in pictures of another size."""
    row = compare(limber, model, clip, "--error", "1", "--size", size)[0]
    _, drawing = played(tools, model, clip, 1, size)
    tap.check(f"{os.path.basename(model)} {clip}, drawing, {size}",
              quotes(row)["drawing"], *drawing)


def check_play(tap, limber, tools, model, clip, folder):
    """The model as the player shows it. It is copied away from its character
    file, which may want another camera."""
    path = shutil.copy(model, folder)
    report = report_of(limber, path, clip, "--size", SIZES[0])
    quoted = quotes(report["candidates"][0])["whole"][1]
    one, more = (count_play(tools, path, clip, report["clips"][0]["duration_s"], frames)
                 for frames in (1, 1 + PLAYED_FRAMES))
    tap.check_instructions(f"{os.path.basename(model)} {clip}, limber play",
                           quoted, (more - one) / PLAYED_FRAMES)


def main():
    limber, tools = sys.argv[1], sys.argv[2:5]
    if len(sys.argv) == 5:
        print("1..0 # SKIP there are no sample models here")
        return False
    tap = Tap()
    alone = False
    for word in sys.argv[5:]:
        if word == "--alone":
            alone = True
            continue
        model, _, clip = word.partition("@")
        clip = clip or "0"
        with tempfile.TemporaryDirectory() as baked:
            check_play(tap, limber, tools, model, clip, baked)
            check_frames(tap, limber, tools, model, clip, baked, alone)
        for size in SIZES[1:]:
            check_drawing(tap, limber, tools, model, clip, size)
    print(f"1..{tap.count}")
    return tap.failed > 0


if __name__ == "__main__":
    sys.exit(main())
