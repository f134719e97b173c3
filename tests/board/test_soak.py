"""Presses buttons at random for SOAK_S seconds of the board's time: memory must
not grow, no frame take longer than 100 ms, and nothing may be logged. Each press
must be shown in time: it waits for the frame under way and takes one itself."""
import os
import random
import re

from harness import (BY_HAND, booted, check, done, limber_memory_kib, links,
                     note, pause, save, start_limber, stop_limber)

SECONDS = float(os.environ.get("SOAK_S", 24))
SEED = int(os.environ.get("SOAK_SEED", 1))
FRAME_MS = LATENCY_MS = 100
# After this time the picture of the last press has been drawn.
SHOWN_S = 0.3
# Not pressed together: it saves a picture, and the board's files are in memory.
SAVES = {"F8", "F9"}
SHOWS_OVERLAYS = {"F6", "F9"}
DEMOS = ("walker", "arm", "face")


def press_at_random(machine, chance, until_s, left_out):
    """Returns how often a button's level has changed."""
    down = set()
    changes = 0
    while machine.time_s() < until_s:
        button = chance.choice(list(links.BUTTONS))
        if any({button} | down >= pair for pair in left_out):
            continue
        machine.wires.level(button, button not in down)
        down ^= {button}
        changes += 1
        pause(machine, chance.choice((0.01, 0.05, 0.2, 0.5)))
    for button in down:
        machine.wires.level(button, False)
    pause(machine, SHOWN_S)
    return changes + len(down)


def soak(machine, demo, seconds, overlays):
    name = f"{demo} with overlays" if overlays else demo
    chance = random.Random(f"{SEED} {name}")
    # Shown from the start, overlays have all of their memory.
    start_limber(machine, f"--demo {demo} --stats /run/stats"
                 + " --show skeleton" * overlays)
    pause(machine, 2)
    before = limber_memory_kib(machine)[0]
    changes = press_at_random(machine, chance, machine.time_s() + seconds,
                              [SAVES] if overlays else [SAVES, SHOWS_OVERLAYS])
    after, peak = limber_memory_kib(machine)
    save(machine.frame(), f"{name}.png")
    said = stop_limber(machine)
    stats = machine.shell("cat /run/stats")[1]
    values = {key: float(value) for key, value in
              re.findall(r'"(\w+)": ([\d.]+)', stats)}
    check(f"{name}: memory stays flat", after <= before + 64,
          f"{before} KiB, then {after} KiB")
    check(f"{name}: no frame longer than {FRAME_MS} ms",
          values["apart_ms_max"] <= FRAME_MS, values["apart_ms_max"])
    check(f"{name}: every press and release is seen",
          values["presses"] == changes, f"{changes} changes, {stats}")
    check(f"{name}: every press is seen within {LATENCY_MS} ms",
          values["latency_ms_max"] <= LATENCY_MS, values["latency_ms_max"])
    # There is no keyboard, which it says once.
    complaints = [line for line in said.splitlines()
                  if line.startswith("limber: ") and "no keyboard" not in line]
    check(f"{name}: it has nothing to complain of", not complaints, complaints)
    note(f"{name}: {values['frames']:.0f} frames, {values['fps']:.1f} a "
         f"second, longest {values['apart_ms_max']:.1f} ms, "
         f"{values['presses']:.0f} changes of buttons, shown within "
         f"{values['latency_ms_max']:.1f} ms, {peak / 1024:.1f} MiB")


machine = booted(BY_HAND)
for demo in DEMOS:
    for overlays in (False, True):
        soak(machine, demo, SECONDS / len(DEMOS) / 2, overlays)
done()
