"""Buttons pressed at the emulated GPIO controller's pins.

Each press must change the picture within 100 ms of the board's time, by
limber's own count from the kernel's time stamp of the edge, and to
what the same button shows on this machine: of the pictures of all buttons the
right one must be the nearest.
"""
import re

from harness import (BY_HAND, FOLDER, Error, booted, check, difference,
                     done, emulation, host_picture, note, pause, region, save,
                     start_limber, stop_limber, wait_until)

LATENCY_MS = 100
HOLD_S = 0.4
# Of the arm everything stands still until a button is pressed; of the walker
# the line at the bottom that names a feature.
DEMOS = {
    "arm": (("UP", "DOWN", "LEFT", "RIGHT", "ENTER"), (0, 0, 480, 640)),
    "walker": (("F6", "F8", "F9"), (0, 580, 200, 60)),
}


def expected(demo, button):
    script = FOLDER / "press.txt"
    script.write_text(f"1000 {button} down\n")
    return host_picture("--demo", demo, "--script", str(script), "--time",
                        f"{1 + HOLD_S}")


def press_and_look(machine, demo, button, area):
    """Whether the picture changed, how long that took, and the picture after
    HOLD_S. Buttons are wired as the image's limber.conf says."""
    start_limber(machine, f"--demo {demo} --stats /run/stats")
    pause(machine, 0.5)
    before = region(machine.frame(), *area)
    pressed_s = machine.time_s()
    machine.wires.level(button, True)
    changed_s = wait_until(
        machine, lambda: region(machine.frame(), *area) != before, 2, 0)
    pause(machine, max(0, pressed_s + HOLD_S - machine.time_s()))
    after = machine.frame()
    machine.wires.level(button, False)
    save(after, f"{button}.png")
    stop_limber(machine)
    stats = machine.shell("cat /run/stats")[1]
    took = re.search(r'"presses": [1-9].*"latency_ms_max": ([\d.]+)', stats)
    return changed_s, float(took[1]) if took else None, after


def bounce(machine, button, times):
    """Closes a contact that opens again and again, for some milliseconds."""
    begun_s = machine.time_s()
    for _ in range(times):
        machine.wires.level(button, True)
        machine.wires.level(button, False)
    machine.wires.level(button, True)
    return machine.time_s() - begun_s


def presses_seen(machine, press):
    """The arm's picture after press(), once it stands still."""
    start_limber(machine, "--demo arm")
    pause(machine, 0.3)
    press()
    pause(machine, 0.3)
    machine.wires.level("ENTER", False)
    pause(machine, 0.3)
    frame = machine.frame()
    stop_limber(machine)
    return frame


machine = booted(BY_HAND)
slowest = 0.0
for demo, (buttons, area) in DEMOS.items():
    pictures = {button: region(expected(demo, button), *area)
                for button in buttons}
    for button in buttons:
        changed_s, took_ms, frame = press_and_look(machine, demo, button, area)
        seen = region(frame, *area)
        apart = {name: difference(seen, picture)
                 for name, picture in pictures.items()}
        check(f"{button} changes the picture", changed_s is not None)
        check(f"{button} does so within {LATENCY_MS} ms",
              took_ms is not None and took_ms <= LATENCY_MS, took_ms)
        check(f"{button} does what {button} does",
              min(apart, key=apart.get) == button, apart)
        slowest = max(slowest, took_ms or 0)
note(f"the slowest button took {slowest:.0f} ms to show")


def press_once():
    machine.wires.level("ENTER", True)


def press_twice():
    machine.wires.level("ENTER", True)
    pause(machine, 0.1)
    machine.wires.level("ENTER", False)
    pause(machine, 0.1)
    machine.wires.level("ENTER", True)


def press_bouncing():
    for _ in range(20):
        if bounce(machine, "ENTER", 4) < 0.007:
            return
        pause(machine, 0.5)
    raise Error("this machine is too busy for a bounce of 7 ms")


once = presses_seen(machine, press_once)
twice = presses_seen(machine, press_twice)
check("two presses are two", once != twice)
check("a bouncing contact counts once",
      presses_seen(machine, press_bouncing) == once)
done()
