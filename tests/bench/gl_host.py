#!/usr/bin/env python3
"""Compares drivers on this machine: make bench-gl.

    gl_host.py PROGRAMS MODELS [SCENE...]

Prints the milliseconds of CPU that a frame of 480x640 in RGBA8888 takes with
the soft driver and with OSMesa on one thread, and their ratio. The shortest of
three runs counts, so other work on the machine matters little.
"""

import glob
import os
import subprocess
import sys

DEMOS = ("walker", "walker@13", "arm", "face", "crowd", "duel")
SCENES = (
    "S1a S1b S1c S1yb S2 S4a S4b S5b S5s blend-a blend-b blend4-b test-a test-b fog-a fog-b "
    "mip mip2 two-a two-b inter-b add-b decal-b glow-b"
).split()
FRAMES = 30
RUNS = 3


def cpu_seconds(command):
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"gl_host.py: {' '.join(command)} fails")
    return usage.ru_utime + usage.ru_stime


def frame_ms(programs, scene, driver):
    name = "gl_states" if scene in SCENES else "demo_frames"

    def run(frames):
        command = [f"{programs}/{name}", scene, str(frames), driver, "/dev/null", "rgba"]
        return min(cpu_seconds(command) for _ in range(RUNS))

    return (run(FRAMES + 2) - run(2)) / FRAMES * 1000


def main():
    programs, models, *chosen = sys.argv[1:]
    os.environ["LP_NUM_THREADS"] = "0"
    os.environ.setdefault("LIMBER_ASSETS", "assets")
    scenes = chosen or [*SCENES, *DEMOS, *sorted(glob.glob(f"{models}/*.glb"))]
    print(f"{'ms a frame, RGBA8888':32} {'soft':>8} {'OSMesa':>8} {'ratio':>6}")
    for scene in scenes:
        soft, osmesa = (frame_ms(programs, scene, d) for d in ("soft", "osmesa"))
        print(f"{scene:32} {soft:8.2f} {osmesa:8.2f} {soft / osmesa:6.2f}", flush=True)


main()
