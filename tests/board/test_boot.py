"""The boot up to the first picture, and restarting limber when it ends."""
from harness import (PROMPT, booted, check, done, first_picture_s, is_drawn,
                     limber_pid, note, save, wait_until)

FIRST_FRAME_S = 2.0
MEMORY_KIB = 24 * 1024

machine = booted(shell=False)
shown_s = first_picture_s(machine)
check(f"the first picture is on the screen within {FIRST_FRAME_S:.0f} s",
      shown_s is not None and shown_s <= FIRST_FRAME_S, f"{shown_s} s")
note(f"first picture {shown_s or 0:.3f} s after power-on, boot loader not "
     "included")
save(machine.frame(), "first.png")
machine.wait(PROMPT)

status, said = machine.shell("sleep 5; cat /proc/$(pidof limber)/status")
peak = [int(line.split()[1]) for line in said.splitlines()
        if line.startswith("VmHWM")]
check("limber uses at most 24 MB", status == 0 and peak[0] <= MEMORY_KIB, said)
note(f"limber's memory at its peak: {peak[0] / 1024:.1f} MiB")

status, said = machine.shell("touch /etc/x")
check("the root file system is read-only", status != 0 and
      "Read-only" in said, said)
check("files can be written to memory",
      machine.shell("echo >/run/x && echo >/tmp/y")[0] == 0)

before = limber_pid(machine)
machine.shell(f"kill -9 {before}")
machine.clear()
again_s = wait_until(machine, lambda: is_drawn(machine.frame()), 10)
# The page that was drawn last may still be on the panel for a moment.
again = []
wait_until(machine, lambda: again.append(limber_pid(machine)) or
           again[-1] not in (None, before), 10)
after = again[-1]
check("init starts limber again when it has been killed",
      after not in (None, before), f"{before}, then {after}")
check("and its picture is back", again_s is not None, machine.log()[-2000:])
done()
