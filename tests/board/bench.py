"""bench.py JSON: the demos' frames a second on the emulated board, as a table.

The demos are drawn as fast as possible on a framebuffer that does not flip (the
machine kzm), and at the rate of the panel (imx31-pdk), which has a picture every
15.4 ms. The board's time is a count of instructions of 4 ns, 250 million a second, about
as many as an ARM1136 executes at 532 MHz. For comparison the table has the
instructions that Mesa's software rasterizer (OSMesa) needs for the same
pictures, under qemu-arm, because it is too slow for the board.
"""
import json
import pathlib
import re
import subprocess
import sys

import harness
from harness import BY_HAND, TOP, booted, first_picture_s, frames_of

DEMOS = ("walker", "arm", "face")
FRAMES = 60
FLIPS = 16
CROWDS = (1, 2, 3, 4, 6, 8, 12)
CROWD_FRAMES = 30
CROWD_FPS = 30
BENCH = TOP / "build/arm/bench/demo_frames"
COUNTER = TOP / "build/arm1136/insn_count.so"


def boot_s():
    with booted(shell=False) as machine:
        return first_picture_s(machine)


def crowd_of(machine, walkers):
    """Frames a second of a crowd of that many walkers."""
    machine.shell(
        f"limber play --demo crowd --walkers {walkers} --gl soft --no-labels "
        f"--clock fixed:25 --frames {CROWD_FRAMES} --stats /run/stats "
        ">/dev/null", 300)
    said = machine.shell("cat /run/stats")[1]
    return json.loads(re.search(r"\{.*\}", said, re.S)[0])["fps"]


def crowd(machine):
    """Frames a second for growing crowds, down to half the wanted rate, and
    the largest crowd that holds it."""
    rates = {}
    for walkers in CROWDS:
        rates[walkers] = crowd_of(machine, walkers)
        if rates[walkers] < CROWD_FPS / 2:
            break
    held = [walkers for walkers, fps in rates.items() if fps >= CROWD_FPS]
    return {"fps": rates, "holds_30": max(held, default=0)}


def instructions_m(demo, driver):
    """Millions of instructions a frame under qemu-arm."""
    run = subprocess.run(
        [TOP / "tests/bench/count.sh", COUNTER, BENCH, demo, "FRAMES", driver],
        cwd=TOP, check=True, stdout=subprocess.PIPE, text=True)
    return float(run.stdout)


def key_ms(machine):
    """The time from a key's contact to the arm's picture on the panel."""
    harness.start_limber(machine, "--demo arm")
    harness.pause(machine, 0.5)
    after_s = harness.shown_after_s(machine, lambda: machine.key("UP", True))
    machine.key("UP", False)
    harness.stop_limber(machine)
    return after_s * 1000


def panel():
    """The demos on the panel: frames a second and memory, the time and the
    processor's time of a flip between two pages, the time from a key to its
    picture, and from power-on to a picture from the flash."""
    machine = booted(BY_HAND | harness.guest_tool())
    figures = {"demos": {demo: frames_of(machine, demo, FRAMES)
                         for demo in DEMOS},
               "key_ms": round(key_ms(machine))}
    said = machine.shell(f"guest flip {FLIPS}", 60)[1]
    took_us, spent_us = (int(number) for number in
                         re.findall(r"^(\d+) us", said, re.M))
    machine.stop()
    harness.flashed().close()
    with booted(nand=harness.FOLDER / "nand.bin", shell=False) as flash:
        from_flash_s = first_picture_s(flash, 15)
    return figures | {"flip_us": round(took_us / FLIPS),
                      "flip_processor_us": round(spent_us / FLIPS),
                      "first_picture_from_flash_s": round(from_flash_s, 3)}


def main():
    first_s = boot_s()
    machine = booted(BY_HAND, kind="kzm")
    figures = {"first_picture_s": round(first_s, 3), "demos": {}}
    for demo in DEMOS:
        row = frames_of(machine, demo, FRAMES)
        row["soft_minstr"] = instructions_m(demo, "soft")
        row["osmesa_minstr"] = instructions_m(demo, "osmesa")
        figures["demos"][demo] = row
    figures["crowd"] = crowd(machine)
    machine.stop()
    print(f"{'demo':8} {'frames/s':>8} {'ms a frame':>10} {'worst':>6} "
          f"{'memory':>9} {'M instructions a frame':>24}")
    print(f"{'':8} {'soft':>8} {'soft':>10} {'ms':>6} {'MiB':>9} "
          f"{'soft':>12} {'OSMesa':>11}")
    for demo, row in figures["demos"].items():
        print(f"{demo:8} {row['fps']:8.1f} {row['work_ms']['mean']:10.1f} "
              f"{row['work_ms']['max']:6.1f} {row['memory_mib']:9.1f} "
              f"{row['soft_minstr']:12.1f} {row['osmesa_minstr']:11.1f}")
    rates = ", ".join(f"{walkers}: {fps:.1f}" for walkers, fps in
                      figures["crowd"]["fps"].items())
    print(f"walkers that hold {CROWD_FPS} frames a second: "
          f"{figures['crowd']['holds_30']} ({rates})")
    print(f"first picture {first_s:.2f} s after power-on")
    if harness.machines.choose() is harness.machines.Pdk:
        figures["panel"] = row = panel()
        rates = ", ".join(f"{demo} {run['fps']:.1f} ({run['memory_mib']} MiB)"
                          for demo, run in row["demos"].items())
        print(f"on the panel: {rates} frames a second; a flip between two pages "
              f"waits {row['flip_us']} us and costs "
              f"{row['flip_processor_us']} us; a key shows after "
              f"{row['key_ms']} ms; first picture from the flash, after "
              f"writing it, "
              f"{row['first_picture_from_flash_s']:.2f} s")
    pathlib.Path(sys.argv[1]).write_text(json.dumps(figures, indent=1) + "\n")


main()
