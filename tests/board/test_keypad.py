"""The keypad's matrix, from pressed keys at the keypad port through imx_keypad and
evdev to the picture."""
import re

from harness import (BY_HAND, booted, check, done, machines, needs_pdk, note,
                     pause, shown_after_s, start_limber, stop_limber)

LATENCY_MS = 100

# The others wait for the release, as they mean something else held, or do nothing
# in the arm's demo.
CHANGES_PICTURE = ("UP", "DOWN", "LEFT", "RIGHT", "ENTER", "F6", "F8")
CHANGES_AT_RELEASE = ("F9",)

needs_pdk()
machine = booted(BY_HAND)


def recorded():
    return re.findall(r"^\d+ (\w+) (down|up)",
                      machine.shell("cat /run/record")[1], re.M)


def press(*names):
    """Presses keys together; the time until the panel's picture changes, from the
    contact and from its end, what limber says of it in ms, and the record of the
    buttons."""
    start_limber(machine, "--demo arm --stats /run/stats "
                 "--record-buttons /run/record")
    pause(machine, 0.5)
    after_s = shown_after_s(machine, lambda: [machine.key(name, True)
                                              for name in names], 0.3)
    pause(machine, 0.2)
    released_s = shown_after_s(machine, lambda: [machine.key(name, False)
                                                 for name in names], 0.3)
    pause(machine, 0.4)
    stop_limber(machine)
    stats = machine.shell("cat /run/stats")[1]
    took = re.search(r'"presses": [1-9].*"latency_ms_max": ([\d.]+)', stats)
    return after_s, released_s, float(took[1]) if took else 1e9, recorded()


slowest_ms = 0
for name in machines.KEYS:
    after_s, released_s, latency_ms, record = press(name)
    check(f"{name} and nothing else is pressed and released",
          record == [(name, "down"), (name, "up")], record)
    check(f"{name} is drawn within {LATENCY_MS} ms of the kernel's event",
          latency_ms <= LATENCY_MS, latency_ms)
    if name in CHANGES_PICTURE:
        slowest_ms = max(slowest_ms, after_s * 1000)
        check(f"{name} shows on the panel within {LATENCY_MS} ms of its contact",
              after_s * 1000 <= LATENCY_MS, after_s)
    if name in CHANGES_AT_RELEASE:
        check(f"{name} shows on the panel within {LATENCY_MS} ms of its release",
              released_s * 1000 <= LATENCY_MS, released_s)
note(f"the slowest key shows {slowest_ms:.0f} ms after its contact")

record = press("UP", "LEFT")[3]
check("two keys together are two",
      sorted(record) == sorted((name, way) for name in ("UP", "LEFT")
                               for way in ("down", "up")), record)

# UP (0,0), DOWN (0,1) and RIGHT (1,0) connect row 1 with column 1: LEFT.
record = press("UP", "DOWN", "RIGHT")[3]
check("three at the corners of a rectangle show the fourth, as in a matrix "
      "without diodes", ("LEFT", "down") in record, record)
done()
