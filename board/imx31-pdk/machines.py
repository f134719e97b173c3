"""The two emulated machines.

Pdk is the i.MX31 PDK (qemu/README.md): the kernel shows its picture through the
chip's IPU on the panel, reads the keypad's matrix and boots from the NAND. Kzm is
another board with the same chip, which any QEMU has: the picture is a simple
framebuffer in memory, and buttons are GPIO lines only.
"""
import os
import pathlib

TOP = pathlib.Path(__file__).resolve().parents[2]
WIDTH, HEIGHT = 480, 640
FRAME_BYTES = WIDTH * HEIGHT * 2

# Row and column of each key (imx31-pdk-limber.dts).
KEYS = {"UP": (0, 0), "DOWN": (0, 1), "RIGHT": (1, 0), "LEFT": (1, 1),
        "ENTER": (1, 2), "F6": (2, 0), "F8": (2, 1), "F9": (2, 2),
        "F10": (2, 3)}


class Kzm:
    name = "kzm"
    program = "qemu-system-arm"
    keys = {}
    # The address that the device tree gives the simple framebuffer.
    picture_at = 0x87E00000

    arguments = ("-M", "kzm")

    @staticmethod
    def button_pin(line):
        """The input for a button at this line of GPIO2, as words of qtest."""
        return f"/machine/soc/gpio[1] unnamed-gpio-in {line}"

    @staticmethod
    def pictures(_):
        return [Kzm.picture_at]


class Pdk:
    name = "pdk"
    program = str(TOP / "build/qemu/qemu-system-arm")
    keys = KEYS
    # Where QEMU maps what the panel shows; the processor cannot reach it there.
    picture_at = 0x100000000

    # VNC reads its keymaps from this folder.
    arguments = ("-M", "imx31-pdk", "-d", "guest_errors", "-D", "devices.log",
                 "-L", str(TOP / "build/qemu/source/pc-bios"))

    @staticmethod
    def button_pin(line):
        """The multiplexer's input for a button at this line of GPIO2."""
        return f"/machine/iomux button {line - 18}"

    @staticmethod
    def from_nand(path, command_line):
        """The arguments to start the kernel in the NAND with its command line;
        QEMU ends a value at a comma that is not doubled."""
        path, command_line = (str(value).replace(",", ",,")
                              for value in (path, command_line))
        return ["-drive", f"if=mtd,format=raw,file={path}",
                "-M", f"imx31-pdk,redboot-command-line={command_line}"]

    @staticmethod
    def pictures(monitor):
        """The addresses of the last pictures that the IPU has fetched, and the
        panel's own."""
        buffers = {monitor.run("qom-get", path="/machine/ipu", property=name)
                   for name in ("picture0", "picture1")}
        return [*sorted(buffers - {0}), Pdk.picture_at]


def choose(name=None):
    """The machine called pdk or kzm, by default that of the environment's
    EMULATOR, and without that the first of them that exists here."""
    name = name or os.environ.get("EMULATOR")
    if name in ("pdk", "kzm"):
        return Pdk if name == "pdk" else Kzm
    if name:
        raise ValueError(f"EMULATOR={name}: choose pdk or kzm")
    return Pdk if os.path.exists(Pdk.program) else Kzm
