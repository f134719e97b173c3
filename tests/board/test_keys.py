"""The keys of a keyboard that is plugged in while limber runs, through evdev."""
from harness import (BY_HAND, booted, check, done, guest_tool, is_drawn,
                     pause, start_limber, stop_limber)

machine = booted(BY_HAND | guest_tool(), drivers=True)
status, said = machine.shell("modprobe uinput && ls /dev/uinput")
check("the kernel's test keyboard can be made", status == 0, said)


def after(keys):
    """The picture of the demo arm after these keys, when it has stopped."""
    start_limber(machine, "--demo arm")
    if keys:
        status, said = machine.shell(f"guest key {keys}")
        check(f"{keys}: the keyboard comes and goes", status == 0, said)
    pause(machine, 0.5)
    frame = machine.frame()
    said = stop_limber(machine)
    return frame, said


still = after("")[0]
once, said = after("ENTER")
check("a key of a keyboard plugged in later changes the picture",
      is_drawn(once) and once != still, said)
twice, said = after("ENTER ENTER")
check("and each press again", twice not in (still, once), said)
machine.stop()
done()
