"""Presses buttons at random for SOAK_S seconds of the board's time: memory must
not grow, no frame should take longer than 100 ms, and nothing may be logged."""
import os
import random
import re

from harness import (BY_HAND, aim, booted, check, done, links,
                     limber_memory_kib, note, pause, save, start_limber,
                     stop_limber)

SECONDS = float(os.environ.get("SOAK_S", 120))
SEED = int(os.environ.get("SOAK_SEED", 1))
FRAME_MS = 100
# The walker's uneven ground takes up to 92 ms a frame. A press may wait for one
# frame, and the next one shows it.
LATENCY_WORST_MS = 220
# After this time the picture of the last press has been drawn.
SHOWN_S = 0.3
# Not pressed together: one pair saves a picture, and the board's files are in
# memory; the other shows the technique, which draws a figure several times.
LEFT_OUT = ({"F8", "F9"}, {"F6", "F9"})
DEMOS = ("walker", "arm", "face")


def press_at_random(machine, chance, until_s):
    """Returns how often a button's level has changed."""
    down = set()
    changes = 0
    while machine.time_s() < until_s:
        button = chance.choice(list(links.BUTTONS))
        if any({button} | down >= pair for pair in LEFT_OUT):
            continue
        machine.wires.level(button, button not in down)
        down ^= {button}
        changes += 1
        pause(machine, chance.choice((0.01, 0.05, 0.2, 0.5)))
    for button in down:
        machine.wires.level(button, False)
    pause(machine, SHOWN_S)
    return changes + len(down)


def soak(machine, demo, seconds):
    chance = random.Random(f"{SEED} {demo}")
    start_limber(machine, f"--demo {demo} --stats /run/stats")
    pause(machine, 2)
    before = limber_memory_kib(machine)[0]
    changes = press_at_random(machine, chance, machine.time_s() + seconds)
    after, peak = limber_memory_kib(machine)
    save(machine.frame(), f"{demo}.png")
    said = stop_limber(machine)
    stats = machine.shell("cat /run/stats")[1]
    values = {name: float(value) for name, value in
              re.findall(r'"(\w+)": ([\d.]+)', stats)}
    check(f"{demo}: memory stays flat", after <= before + 64,
          f"{before} KiB, then {after} KiB")
    check(f"{demo}: no frame longer than {FRAME_MS} ms",
          values["apart_ms_max"] <= FRAME_MS, values["apart_ms_max"])
    check(f"{demo}: every press and release is seen",
          values["presses"] == changes, f"{changes} changes, {stats}")
    aim(f"{demo}: every press is seen within milliseconds:",
        values["latency_ms_max"], FRAME_MS, LATENCY_WORST_MS)
    # There is no keyboard, which it says once.
    complaints = [line for line in said.splitlines()
                  if line.startswith("limber: ") and "no keyboard" not in line]
    check(f"{demo}: it has nothing to complain of", not complaints, complaints)
    note(f"{demo}: {values['frames']:.0f} frames, {values['fps']:.1f} a "
         f"second, longest {values['apart_ms_max']:.1f} ms, "
         f"{values['presses']:.0f} changes of buttons, shown within "
         f"{values['latency_ms_max']:.1f} ms, {peak / 1024:.1f} MiB")


machine = booted(BY_HAND)
for demo in DEMOS:
    soak(machine, demo, SECONDS / len(DEMOS))
done()
