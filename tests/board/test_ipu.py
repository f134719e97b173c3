"""The picture's way through the IPU onto the panel: pictures that equal the
host's, flips at the panel's rate that are not torn, and what a flip costs."""
import json
import re

from harness import (BY_HAND, booted, check, difference, done, guest_tool,
                     host_picture, needs_pdk, note, pause, save, start_limber,
                     stop_limber, wait_until)

SHOWS = "the panel shows the picture"
# The shell may be there before the panel is awake.
AWAKE_S = 2
FLIPS = 16
# The Epson panel's clocks a frame and the dividers of 133 MHz that reach them.
PANEL_HZ = 133e6 * 16 / 88 / (561 * 665)

needs_pdk()
machine = booted(BY_HAND | guest_tool())


ipu = machine.ipu


def sent():
    """The time, and the pictures sent until then: the board stands still while
    this looks, however busy this machine is."""
    machine.monitor.run("stop")
    now = machine.time_s(), ipu("frames")
    machine.monitor.run("cont")
    return now


wait_until(machine, lambda: machine.reports()[-1:] == [SHOWS], AWAKE_S)
check("no device has anything to complain of but a panel that waits for its "
      "driver", machine.reports()[-1:] == [SHOWS]
      and all(line.startswith(("no picture: the panel", SHOWS))
              for line in machine.reports()), machine.reports())

begun_s, begun = sent()
pause(machine, 2)
ended_s, ended = sent()
rate_hz = (ended - begun) / (ended_s - begun_s)
check(f"the panel gets {PANEL_HZ:.1f} pictures a second",
      abs(rate_hz - PANEL_HZ) < 1, rate_hz)

start_limber(machine, "--demo arm --script /dev/null --math fixed")
pause(machine, 1)
frame = machine.frame()
said = stop_limber(machine)
save(frame, "arm.png")
apart = difference(frame, host_picture(
    "--demo", "arm", "--math", "fixed", "--script", "/dev/null", "--time", "1"))
check("the picture on the panel is the host's, to the byte", apart == 0,
      f"{apart} pixels differ\n{said}")

# guest flip shows pictures of one colour, each on the page that is not sent.
machine.shell("echo 0 >/sys/class/vtconsole/vtcon1/bind")
torn = ipu("torn")
status, said = machine.shell(f"guest flip {FLIPS}", 60)
check(f"{FLIPS} flips in a row succeed", status == 0, said)
check("none of their pictures is torn", ipu("torn") == torn,
      f"{ipu('torn') - torn} are torn")
took_us = int(re.search(r"^(\d+) us$", said, re.M)[1])
spent_us = int(re.search(r"^(\d+) us of the processor$", said, re.M)[1])
check("each waits for the end of a frame",
      took_us >= (FLIPS - 1) * 1e6 / PANEL_HZ, said)
note(f"a flip takes {took_us / FLIPS:.0f} us, of which the processor works "
     f"{spent_us / FLIPS:.0f} us")

torn, begun = ipu("torn"), ipu("frames")
status, said = machine.shell(
    "limber play --demo walker --gl soft --clock fixed:25 --frames 60 "
    "--stats /run/stats >/dev/null; cat /run/stats", 300)
stats = json.loads(re.search(r"\{.*\}", said, re.S)[0])
check("the walker reaches 30 frames a second on the panel",
      stats["fps"] >= 30, stats)
check("no picture of it is torn after its first two",
      ipu("torn") - torn <= 2,
      f"{ipu('torn') - torn} of {ipu('frames') - begun} are torn")
note(f"walker on the panel: {stats['fps']:.1f} frames a second, "
     f"{stats['work_ms']['mean']:.1f} ms of work each")
done()
