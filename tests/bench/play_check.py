#!/usr/bin/env python3
"""play_check.py LIMBER PLAY_COST MODEL.so SYSROOT FILE[@CLIP]...: plays quotes.

For each row that `limber compare --clip` quotes, it plays the file of the row
on the timing model (play_cost.c) and compares instructions and cycles of a
frame before drawing. Quoted and played may differ by 10%. It prints TAP.
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
# Below this a frame is a few cache misses, of which one more is 10%.
CYCLES_MIN = 12000
MHZ = 532


def played(program, model_so, sysroot, path, clip):
    """Cycles and instructions of an average frame."""
    run = subprocess.run(
        ["qemu-arm", "-cpu", "arm1136", "-L", sysroot, "-plugin", model_so,
         program, path, clip, str(RATE_HZ)],
        check=True, capture_output=True, text=True)
    cycles = instructions = 0.0
    frames = 0
    for line in (run.stdout + run.stderr).splitlines():
        words = line.split()
        if words[:1] == ["frames"]:
            frames = int(words[1])
        elif words[:1] == ["region"]:
            values = dict(zip(words[2::2], words[3::2])) \
                if len(words) % 2 == 0 else dict(zip(words[2:], words[3:]))
            cycles += float(values["cycles"])
            instructions += float(values["instructions"])
    return cycles / frames, instructions / frames


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


def main():
    limber, program, model_so, sysroot = sys.argv[1:5]
    count = failed = 0
    for model in sys.argv[5:]:
        model, _, clip = model.partition("@")
        clip = clip or "0"
        with tempfile.TemporaryDirectory() as baked:
            report = json.loads(subprocess.run(
                [limber, "compare", model, "--clip", clip, "--format", "json",
                 "--error", "1", "--export", baked],
                check=True, capture_output=True, text=True).stdout)
            for row in filter(lambda r: r["listed"], report["candidates"]):
                path = file_of(row, model, baked)
                if row["name"] == "rigid parts" and not has_clips(path):
                    continue  # the clip has nothing but weights of targets
                at = clip if path == model else "0"
                cycles, instructions = played(
                    program, model_so, sysroot, path, at)
                quoted = row["arm11_predicted"]
                us = cycles / MHZ
                off = [quoted["us_per_frame"] / us - 1,
                       quoted["instructions_per_frame"] / instructions - 1]
                good = all(abs(o) <= TOLERANCE for o in off) or (
                    cycles < CYCLES_MIN and
                    abs(quoted["us_per_frame"] - us) * MHZ <
                    TOLERANCE * CYCLES_MIN)
                count += 1
                failed += not good
                print(f"{'ok' if good else 'not ok'} {count} - "
                      f"{os.path.basename(model)} {clip}, {row['name']}: "
                      f"{quoted['us_per_frame']:.1f} us quoted, {us:.1f} played"
                      f" ({off[0]:+.1%}), {off[1]:+.1%} instructions",
                      flush=True)
    print(f"1..{count}")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
