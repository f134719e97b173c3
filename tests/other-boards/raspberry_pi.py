"""limber runs on an ARM11 board that it was not made for: a Raspberry Pi Zero with
Debian's kernel.

The bundle lies in a root file system that has nothing else but BusyBox. QEMU's
machine has no firmware, which tells Linux on the board where the screen's memory is.
The test's device tree does that here.
"""
import pathlib
import subprocess
import sys
import tarfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "board"))
import harness  # noqa: E402
from harness import (FOLDER, TOP, archive, check, difference,  # noqa: E402
                     done, emulation, host_picture)

PI = TOP / "build/raspberry-pi"
WIDTH, HEIGHT = 640, 480
# Where QEMU's machine has its picture (hw/display/bcm2835_fb.c).
PICTURE_AT = 0x1C100000
PICTURE_BYTES = WIDTH * HEIGHT * 2

INIT = """#!/bin/busybox sh
/bin/busybox mkdir -p /proc /sys /dev /tmp /bin
/bin/busybox --install -s /bin
mount -t proc proc /proc
mount -t sysfs sys /sys
mount -t devtmpfs dev /dev
insmod /evdev.ko
insmod /uinput.ko
echo 0 >/sys/class/vtconsole/vtcon1/bind
cd /tmp
PS1='limber:# ' exec sh
"""


class Pi(emulation.Machine):
    """QEMU's Raspberry Pi Zero with this root file system."""

    def __init__(self, folder, files):
        super().__init__(folder)
        self.clear_folder()
        (self.folder / "initrd").write_bytes(archive(files))
        # Time counts instructions: Linux sets the timer by reading the clock and
        # writing the sum, and if the host pauses the emulator between both, the
        # time has passed, and the timer stands still for an hour.
        self.launch([
            "qemu-system-arm", "-M", "raspi0", "-icount", "shift=2,sleep=off",
            *emulation.LINKS,
            "-kernel", str(PI / "vmlinuz"), "-dtb", str(self.tree()),
            "-initrd", "initrd", "-append",
            "console=ttyAMA0,115200 rdinit=/init quiet"])
        self.power_on()

    def tree(self):
        """Debian's device tree with the screen that the firmware would add; without
        the power controller, which QEMU's machine lacks, and without USB, whose
        interrupts take longer than limber."""
        tree = self.folder / "tree.dtb"
        tree.write_bytes((PI / "bcm2835-rpi-zero.dtb").read_bytes())
        screen = f"/chosen/framebuffer@{PICTURE_AT:x}"

        def put(node, name, kind, *values):
            subprocess.run(["fdtput", "-t", kind, tree, node, name,
                            *map(str, values)], check=True)

        for node in ("watchdog@7e100000", "usb@7e980000"):
            put(f"/soc/{node}", "status", "s", "disabled")
        put("/chosen", "#address-cells", "i", 1)
        put("/chosen", "#size-cells", "i", 1)
        put("/chosen", "ranges", "i")
        subprocess.run(["fdtput", "-c", tree, screen], check=True)
        put(screen, "compatible", "s", "simple-framebuffer")
        put(screen, "reg", "i", PICTURE_AT, PICTURE_BYTES)
        put(screen, "width", "i", WIDTH)
        put(screen, "height", "i", HEIGHT)
        put(screen, "stride", "i", WIDTH * 2)
        put(screen, "format", "s", "r5g6b5")
        return tree

    def screen(self):
        return self.picture(PICTURE_AT, PICTURE_BYTES)


def bundle():
    """The files of the bundle, below opt."""
    found = list((TOP / "build/package").glob("limber-*-armv6.tar.gz"))
    if len(found) != 1 or not (PI / "stamp").exists():
        raise emulation.Error("make bundle build/raspberry-pi/stamp makes what this "
                              "test needs")
    made = found[0]
    with tarfile.open(made) as tar:
        return {f"opt/{member.name}": tar.extractfile(member).read()
                for member in tar if member.isfile()}


files = bundle() | {
    "init": INIT, "bin/busybox": TOP / "build/sysroot/usr/bin/busybox",
    "evdev.ko": PI / "evdev.ko", "uinput.ko": PI / "uinput.ko",
    "opt/limber/guest": harness.GUEST}
board = harness.stopped_at_end(Pi(FOLDER / "machine", files))
board.wait(r"limber:# ", 200)

status, said = board.shell("/opt/limber/limber doctor")
check("limber's doctor says that limber plays there",
      status == 0 and "limber plays here, on fbdev" in said, said)
check("it lists the board's lines for buttons", "pinctrl-bcm2835/17" in said, said)

for demo in ("walker", "arm", "face"):
    how = ("--demo", demo, "--time", "2.2", "--clock", "fixed:25",
           "--math", "fixed", "--script", "/dev/null")
    status, said = board.shell(f"/opt/limber/limber play {' '.join(how)} --frames 1")
    shown = board.screen()
    wanted = host_picture(*how, "--size", f"{WIDTH}x{HEIGHT}")
    apart = difference(shown, wanted)
    (FOLDER / f"{demo}.png").write_bytes(emulation.png_of(shown, WIDTH, HEIGHT))
    check(f"{demo}: the picture is that of this machine",
          status == 0 and apart == 0, f"{apart} pixels differ\n{said}")

# The helper program needs the bundle's libraries, too.
RUN = "/opt/limber/lib/ld-linux.so.3 --library-path /opt/limber/lib"
board.shell("/opt/limber/limber play --record-buttons /tmp/buttons >/tmp/said 2>&1 &")
board.shell("while ! grep -q quit /tmp/said; do sleep 0.1; done")
status, said = board.shell(f"{RUN} /opt/limber/guest key RIGHT; sleep 1; "
                           "kill $!; wait $!; echo ended $?; "
                           "cat /tmp/said /tmp/buttons")
check("limber sees a key of a keyboard that is plugged in",
      "RIGHT down" in said and "RIGHT up" in said, said)
check("limber ends when it is told to", "ended 0" in said, said)
done()
