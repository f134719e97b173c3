"""Pictures on the board's framebuffer equal those of the host byte for byte.

Both draw with the soft driver in RGB565. The clock is fixed, so the pictures do
not depend on the speed of either machine.
"""
from harness import (BY_HAND, booted, check, difference, done, emulation,
                     host_picture, save)

PICTURES = [(demo, time) for demo in ("walker", "arm", "face")
            for time in ("0.52", "2.2", "5")]

machine = booted(BY_HAND)
# Otherwise the console draws on the screen when limber ends.
machine.shell("echo 0 >/sys/class/vtconsole/vtcon1/bind")
for demo, time in PICTURES:
    arguments = ("--demo", demo, "--time", time, "--clock", "fixed:25",
                 "--math", "fixed")
    script = "/dev/null"
    machine.clear()
    status, said = machine.shell(
        f"limber play {' '.join(arguments)} --frames 1 --script {script}")
    wanted = host_picture(*arguments, "--script", script)
    # At its end limber shows the page again that was shown before.
    apart, frame = min((difference(page, wanted), page)
                       for page in machine.pages())
    save(frame, f"{demo}-{time}.png")
    if not check(f"{demo} after {time} s", status == 0 and apart == 0,
                 f"{apart} of {emulation.WIDTH * emulation.HEIGHT} pixels "
                 f"differ\n{said}"):
        save(wanted, f"{demo}-{time}-host.png")
done()
