"""A board without a framebuffer, a GPIO chip or a camera: limber reports each
once and runs as far as it can."""
from harness import (booted, check, device_tree, done, is_drawn, limber_pid,
                     pause, wait_until)

SCREEN = "/chosen/framebuffer@87e00000"
GPIO = "/soc/bus@53f00000/gpio@53fd0000"


def sentences(machine, word):
    return [line for line in machine.log().splitlines()
            if "limber: " in line and word in line]


machine = booted(tree=device_tree(SCREEN), kind="kzm")
pause(machine, 2)
said = sentences(machine, "/dev/fb0")
check("without a framebuffer limber names it", len(said) > 0,
      machine.log()[-1500:])
check("and the console is there for a person",
      machine.shell("ls /dev/fb0")[0] != 0)
machine.stop()

machine = booted(tree=device_tree(GPIO))
drawn_s = wait_until(machine, lambda: is_drawn(machine.frame()), 10)
check("without its GPIO chip limber shows its picture", drawn_s is not None)
said = sentences(machine, "53fd0000.gpio")
check("and names the chip", len(said) > 0, machine.log()[-1500:])
pause(machine, 2)
check("once, and runs on", limber_pid(machine) is not None and
      len(sentences(machine, "53fd0000.gpio")) == len(said), said)

machine.shell("killall limber")
status, said = machine.shell(
    "limber play --frames 3 --display null --camera /dev/video0 "
    "--camera-use background")
check("without a camera limber names it and runs", status == 0 and
      "limber: camera /dev/video0: " in said, said)
done()
