#!/usr/bin/env python3
"""frame_split.py NM LIBRARY MODEL.json: what a frame of --gl soft goes to.

MODEL.json is the timing model's report (tests/arm1136) of one frame; LIBRARY
is liblimber.a, whose members tell which file a function is from, and NM the
program that lists them. Cycles are of 532 MHz. What lies in no member is
libc's clearing of memory.
"""

import json
import pathlib
import re
import subprocess
import sys

STAGES = {
    "transform and light": "array draw light matrix number prepare prepare_light vertex",
    "set-up": "clip fill_flat fill_glyph fill_opaque fill_plain raster triangle",
    "pixels": "band bands combine fill flat fragment line luminance rows shade"
    " span_565 texel texture",
    "clear": "clear",
}
MEMBER = re.compile(r"[^:]*:([^:]+)\.o:\S* ?[tTwW] (\S+)")


def soft_members():
    """Object files of platform/gl/soft, by name."""
    return {p.stem for p in pathlib.Path("platform/gl/soft").rglob("*.[cS]")}


def stage_of(member):
    if member in soft_members():
        for stage, members in STAGES.items():
            if member in members.split():
                return stage
    return "animate"


def main():
    nm, library, report = sys.argv[1:4]
    listed = subprocess.run(
        [nm, "-A", "--defined-only", library], capture_output=True, text=True, check=True
    ).stdout
    member = {m[2]: m[1] for m in map(MEMBER.match, listed.splitlines()) if m}
    totals = {stage: [0, 0] for stage in ("animate", *STAGES)}
    for symbol in json.loads(pathlib.Path(report).read_text())["symbols"]:
        name = symbol["name"].split(".")[0]
        stage = stage_of(member[name]) if name in member else "clear"
        totals[stage][0] += symbol["instructions"]
        totals[stage][1] += symbol["cycles"]
    totals["all"] = [sum(column) for column in zip(*totals.values())]
    print(f"{'':20} {'instructions':>12} {'cycles':>8} {'ms':>6}  (millions)")
    for stage, (instructions, cycles) in totals.items():
        print(
            f"{stage:20} {instructions / 1e6:12.2f} {cycles / 1e6:8.2f} "
            f"{cycles / 532e3:6.2f}"
        )


if __name__ == "__main__":
    main()
