"""The keypad's matrix, from pressed keys at the keypad port through imx_keypad and
evdev to the picture."""
import re
import time

from harness import (BY_HAND, booted, check, done, machines, needs_pdk, note,
                     pause, start_limber, stop_limber)

LATENCY_MS = 100
# The kernel's driver calls a key pressed when three scans agree.
DEBOUNCE_MS = 60

# The other keys change the arm's picture later or not at all.
CHANGES_PICTURE = ("UP", "DOWN", "LEFT", "RIGHT", "ENTER", "F8")

needs_pdk()
machine = booted(BY_HAND)


def recorded():
    return re.findall(r"^\d+ (\w+) (down|up)",
                      machine.shell("cat /run/record")[1], re.M)


def first_change_s(before, seconds):
    """When the picture was seen to differ from the one before, or None. The
    board stands still while this looks, however busy this machine is."""
    end_s = machine.time_s() + seconds
    while True:
        machine.monitor.run("stop")
        now_s, changed = machine.time_s(), machine.frame() != before
        machine.monitor.run("cont")
        if changed or now_s > end_s:
            return now_s if changed else None
        time.sleep(0.002)


def press(*names):
    """Presses keys together; the time until the picture changes, what limber
    says of it, and the record of the buttons."""
    start_limber(machine, "--demo arm --stats /run/stats "
                 "--record-buttons /run/record")
    pause(machine, 0.5)
    machine.monitor.run("stop")
    before, pressed_s = machine.frame(), machine.time_s()
    for name in names:
        machine.key(name, True)
    machine.monitor.run("cont")
    changed_s = first_change_s(before, 2)
    pause(machine, 0.2)
    for name in names:
        machine.key(name, False)
    pause(machine, 0.4)
    stop_limber(machine)
    stats = machine.shell("cat /run/stats")[1]
    took = re.search(r'"presses": [1-9].*"latency_ms_max": ([\d.]+)', stats)
    return ((changed_s or 1e9) - pressed_s,
            float(took[1]) if took else 1e9, recorded())


slowest_ms = 0
for name in machines.KEYS:
    changed_s, latency_ms, record = press(name)
    check(f"{name} and nothing else is pressed and released",
          record == [(name, "down"), (name, "up")], record)
    check(f"{name} shows within {LATENCY_MS} ms of the kernel's event",
          latency_ms <= LATENCY_MS, latency_ms)
    if name in CHANGES_PICTURE:
        # A busy machine can only make a change look later than it was.
        for _ in range(2):
            if changed_s * 1000 > LATENCY_MS + DEBOUNCE_MS:
                changed_s = min(changed_s, press(name)[0])
        slowest_ms = max(slowest_ms, changed_s * 1000)
check(f"and within {LATENCY_MS + DEBOUNCE_MS} ms of the contact",
      slowest_ms <= LATENCY_MS + DEBOUNCE_MS, slowest_ms)
note(f"the slowest key shows {slowest_ms:.0f} ms after its contact")

record = press("UP", "LEFT")[2]
check("two keys together are two",
      sorted(record) == sorted((name, way) for name in ("UP", "LEFT")
                               for way in ("down", "up")), record)

# UP (0,0), DOWN (0,1) and RIGHT (1,0) connect row 1 with column 1: LEFT.
record = press("UP", "DOWN", "RIGHT")[2]
check("three at the corners of a rectangle show the fourth, as in a matrix "
      "without diodes", ("LEFT", "down") in record, record)
done()
