"""Boards that are wired or described wrongly: no picture on the panel, and the
emulated devices name the reason. It shows that they check what Linux does."""
import subprocess

from harness import (BY_HAND, FOLDER, IMAGE, booted, check, difference, done,
                     emulation, needs_pdk, pause, start_limber, stop_limber)

PMIC = "/soc/spba-bus@50000000/spi@50010000/pmic@2"
PANEL = "/soc/bus@43f00000/spi@43fa4000/panel@2"
PINS = "/pin-multiplexer@43fac000"
IPU = "/display-controller@53fc0000"

needs_pdk()


def tree(name, *edits):
    """The device tree with commands of fdtput applied to it."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    path = FOLDER / f"{name}.dtb"
    path.write_bytes((IMAGE / "imx31-pdk-limber.dtb").read_bytes())
    for edit in edits:
        subprocess.run(["fdtput", *edit[:1], str(path), *edit[1:]], check=True)
    return path


def cells(node, name):
    """The cells of a property of the image's device tree, in hexadecimal."""
    return subprocess.run(
        ["fdtget", "-tx", IMAGE / "imx31-pdk-limber.dtb", node, name],
        check=True, stdout=subprocess.PIPE, text=True).stdout.split()


def seen(name, reason, *edits):
    """Boots the broken board: the panel stays dark, and why."""
    machine = booted(tree=tree(name, *edits), shell=False)
    pause(machine, 4)
    frame = machine.frame()
    dark = difference(frame, bytes(emulation.FRAME_BYTES)) == 0
    reports = machine.reports()
    check(f"{name}: no picture", dark, reports)
    check(f"{name}: the devices say: {reason}",
          any(reason in line for line in reports),
          "\n".join(reports) + machine.log()[-2000:])
    machine.stop()


seen("the panel's supply is another one",
     "the panel's supply VGEN does not give 1.8 V",
     ("-d", PANEL, "vdd-supply"))
seen("the panel's data line is another GPIO",
     "the panel's data are not enabled (GPIO3_25, pin SER_RS)",
     ("-tx", PANEL, "enable-gpios", cells(PANEL, "enable-gpios")[0], "1a", "0"))
seen("the power chip has another select line",
     "the panel's supply VGEN does not give 1.8 V",
     ("-tx", PMIC, "reg", "0"))
# Linux switches the clock off before mx3fb uses the IPU.
seen("the IPU has another device's clock",
     "IPU: access to 0x03c while its clock is off (bits 22 and 23 of CGR1)",
     ("-tx", IPU, "clocks", cells(IPU, "clocks")[0], "30"))
# Pins 37 to 54 are LD17 to LD0.
ranges = " ".join(cells(PINS, "limber,pins"))
check("the device tree routes the panel's data pins", "25 36 12 0" in ranges,
      ranges)
seen("the panel's first data pin is a GPIO",
     "a pin of the panel's data or synchronization is not routed to the IPU",
     ("-tx", PINS, "limber,pins",
      *ranges.replace("25 36 12 0", "25 35 12 0 36 36 1 0").split()))


def pressed(machine):
    """What limber hears of a press of UP on its GPIO line."""
    start_limber(machine, "--demo arm --record-buttons /run/record")
    pause(machine, 0.3)
    for high in (True, False):
        machine.wires.level("UP", high)
        pause(machine, 0.2)
    stop_limber(machine)
    return machine.shell("cat /run/record; rm /run/record")[1]


# Pins 92 to 95 are KEY_ROW7 to KEY_ROW4, UP's; the last cell is the pad.
before, row, after = ranges.partition("5c 5f 1 ")
check("the device tree routes the buttons' rows to the GPIO controller",
      bool(row), ranges)
pad, after = after.split(" ", 1)
machine = booted(BY_HAND, tree=tree(
    "a button's pin is the keypad's",
    ("-tx", PINS, "limber,pins", *before.split(), *f"5c 5e 1 {pad}".split(),
     *f"5f 5f 12 {pad}".split(), *after.split())))
said = pressed(machine)
check("a button whose pin is routed to the keypad is not heard",
      "UP down" not in said, said)
check("and the devices say so", any(
    "the button at the pin KEY_ROW4 is not heard" in line
    for line in machine.reports()), machine.reports())
machine.stop()
said = pressed(booted(BY_HAND))
check("routed as in the image, it is heard", "UP down" in said, said)
done()
