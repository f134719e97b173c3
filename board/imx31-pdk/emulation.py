"""The emulated board: QEMU's i.MX31 with limber's image.

A Machine is one board with a folder of its own. It controls the board from
outside: the console through a socket and a log, the picture through QEMU's
memory (QMP), the buttons through the inputs of the emulated GPIO controller
(qtest), the keys through the keypad's matrix (QMP). The command line `emulate`,
the web page and tests/board use it. It needs only the standard library.
"""
import array
import contextlib
import os
import pathlib
import re
import signal
import struct
import subprocess
import sys
import time
import zlib

import machines
from links import Console, Error, Monitor, Wires
from machines import FRAME_BYTES, HEIGHT, WIDTH

# The prompt of the shell on the console.
PROMPT = r"limber:/\S*# "

# How QEMU is ended: the signals, and how many seconds it has after each. QEMU 7.2 may
# wait for ever in monitor_cleanup() if the first comes just after a request, 1 time
# in 100; the second wakes it.
ENDINGS = ((signal.SIGTERM, 1), (signal.SIGTERM, 5), (signal.SIGKILL, 30))
# How long the console may take to show what is waited for: a busy machine is slow.
WAIT_S = 180

# The word that opens a shell on the console (rootfs/usr/sbin/console).
SHELL = "limber.shell"


def tree_arguments(tree):
    """The kernel's command line in a device tree."""
    return re.search(rb"console=[^\0]+", tree.read_bytes())[0].decode()


# What `flash.sh write` prints for the kernel in the NAND (flash/files.sh).
NAND_ARGUMENTS = ("console=ttymxc0,115200 panic=5 ubi.mtd=rootfs "
                  "root=ubi0:rootfs rootfstype=ubifs ro")


# What Machine.launch() expects of any machine of QEMU.
LINKS = ("-display", "none", "-monitor", "none", "-S", "-accel", "tcg",
         "-chardev", "socket,id=console,path=console.sock,server=on,"
         "wait=off,logfile=console.log", "-serial", "chardev:console",
         "-qmp", "unix:qmp.sock,server=on,wait=off",
         "-qtest", "unix:qtest.sock,server=on,wait=off", "-qtest-log", "none")


def qemu_command(machine, start, icount, reboot, more):
    command = [machine.program, *machine.arguments, *start, "-m", "128",
               "-nic", "none", *LINKS]
    if icount:
        command += ["-icount", "shift=2,sleep=off"]
    if not reboot:
        command.append("-no-reboot")
    return command + list(more)


class Machine:
    """One emulated board: starts it in a folder, or uses the one that runs
    there."""

    def __init__(self, folder, kind=None):
        """kind is pdk or kzm (machines.choose)."""
        self.folder = pathlib.Path(folder).resolve()
        self.kind = machines.choose(kind)
        self.keys = set()
        self.process = None
        self.links = {}
        self.seen = 0
        self.asked = 0

    def start(self, image, extra=(), arguments=None, tree=None, nand=None,
              icount=False, reboot=True, power=True, open_shell=True,
              more=()):
        """Boots image, or, when the file nand is given, what its NAND holds.
        extra are further initramfs archives, whose files replace those of the
        image. arguments replaces the kernel's command line, tree the device
        tree; with open_shell the console has a shell. With icount an instruction
        takes 4 ns of the guest's time. Without reboot a reset ends QEMU. Without
        power the board waits for power_on(). more are further arguments for
        QEMU."""
        self.clear_folder()
        if nand:
            start = self.from_nand(nand, arguments, open_shell)
        else:
            start = self.from_files(pathlib.Path(image).resolve(), extra,
                                    arguments, tree, open_shell)
        self.launch(qemu_command(self.kind, start, icount, reboot, more))
        try:
            self.wires.start_timer()
        except Error:
            self.fail_start()
        if power:
            self.power_on()
        return self

    def clear_folder(self):
        """Makes the folder, without what an earlier board has left there."""
        self.folder.mkdir(parents=True, exist_ok=True)
        if self.pid():
            raise Error(f"a board runs in {self.folder} already: stop it first")
        for name in ("qmp.sock", "qtest.sock", "console.sock", "console.log",
                     "devices.log"):
            (self.folder / name).unlink(missing_ok=True)

    def launch(self, command):
        """Starts QEMU, with LINKS among its arguments, in the folder; its
        processor waits for power_on()."""
        with open(self.folder / "qemu.log", "wb") as log:
            self.process = subprocess.Popen(
                command, cwd=self.folder, stdin=subprocess.DEVNULL, stdout=log,
                stderr=log, start_new_session=True)
        (self.folder / "pid").write_text(str(self.process.pid))
        self.wait_for_sockets()

    def from_files(self, image, extra, arguments, tree, shell):
        with open(self.folder / "initrd", "wb") as out:
            for part in (image / "initramfs.cpio.lz4", *extra):
                data = pathlib.Path(part).read_bytes()
                # Four zeros end the blocks of LZ4, and an archive must begin
                # at a multiple of four bytes.
                out.write(data + b"\0" * (4 + -len(data) % 4))
        tree = pathlib.Path(tree or image / "imx31-pdk-limber.dtb").resolve()
        arguments = arguments or tree_arguments(tree)
        return ["-kernel", str(image / "zImage"), "-dtb", str(tree),
                "-initrd", "initrd", "-append",
                arguments + f" {SHELL}" * shell]

    def from_nand(self, nand, arguments, shell):
        if self.kind is not machines.Pdk:
            raise Error("QEMU's machine kzm has no NAND: build the machine "
                        "imx31-pdk with make emulator")
        return self.kind.from_nand(pathlib.Path(nand).resolve(),
                                   (arguments or NAND_ARGUMENTS)
                                   + f" {SHELL}" * shell)

    def wait_for_sockets(self):
        for _ in range(600):
            if self.process.poll() is not None:
                break
            if all((self.folder / name).exists() for name in
                   ("qmp.sock", "qtest.sock", "console.sock")):
                return
            time.sleep(0.02)
        self.fail_start()

    def fail_start(self):
        said = (self.folder / "qemu.log").read_text(errors="replace").strip()
        self.stop()
        raise Error(f"QEMU does not start: {said or 'it gives no reason'}")

    def power_on(self):
        self.monitor.run("cont")

    def pid(self):
        try:
            pid = int((self.folder / "pid").read_text())
            words = pathlib.Path(f"/proc/{pid}/cmdline").read_bytes()
        except (OSError, ValueError):
            return None
        return pid if b"qemu-system-arm" in words else None

    def link(self, name, make):
        if name not in self.links:
            if not self.pid():
                raise Error(f"no board runs in {self.folder}: start it first")
            self.links[name] = make(self.folder)
        return self.links[name]

    @property
    def monitor(self):
        return self.link("monitor", Monitor)

    @property
    def wires(self):
        return self.link("wires", lambda folder: Wires(folder, self.kind))

    @property
    def console(self):
        return self.link("console", Console)

    def stop(self):
        for link in self.links.values():
            link.close()
        self.links = {}
        self.end()
        (self.folder / "pid").unlink(missing_ok=True)

    def end(self):
        """Ends QEMU, even if it does not answer any more. A thread that waits
        for its answer gets an Error."""
        for number, seconds in ENDINGS:
            with contextlib.suppress(ProcessLookupError):
                if self.process:
                    self.process.send_signal(number)
                elif pid := self.pid():
                    os.kill(pid, number)
            if self.has_ended(seconds):
                return
        raise Error(f"QEMU (process {self.pid()}) cannot be ended")

    def has_ended(self, seconds):
        """Waits at most that long; returns whether QEMU has ended."""
        if self.process:
            with contextlib.suppress(subprocess.TimeoutExpired):
                self.process.wait(seconds)
            return self.process.returncode is not None
        deadline = time.monotonic() + seconds
        while self.pid() and time.monotonic() < deadline:
            time.sleep(0.05)
        return not self.pid()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()

    # The console.

    def log(self):
        path = self.folder / "console.log"
        return path.read_bytes().decode(errors="replace").replace("\r", "")

    def mark(self):
        """Makes wait() ignore the output so far."""
        self.seen = len(self.log())

    def wait(self, pattern, seconds=WAIT_S):
        """Waits until the output since mark() matches; returns the match."""
        deadline = time.monotonic() + seconds
        while True:
            # Asked first: what comes before an end is in the log then.
            over = time.monotonic() > deadline or not self.pid()
            found = re.search(pattern, self.log()[self.seen:], re.M)
            if found:
                return found
            if over:
                raise Error(f"the console has not shown /{pattern}/, but:\n"
                            + self.log()[self.seen:][-2000:])
            time.sleep(0.02)

    def shell(self, command, seconds=WAIT_S):
        """Runs a command in the console's shell; returns status and output."""
        self.asked += 1
        end = f"done-{self.asked}-"
        # In one line, so that no input is echoed among the output.
        then = "" if command.endswith("&") else ";"
        self.mark()
        self.console.type(f"{command}{then} echo do''ne-{self.asked}-$?-\n")
        found = self.wait(end + r"(\d+)-", seconds)
        said = self.log()[self.seen:][:found.start()]
        return int(found.group(1)), said

    # Keys, buttons, time and picture.

    def reports(self):
        """What the emulated devices have to say about the guest, in lines."""
        path = self.folder / "devices.log"
        lines = path.read_text().splitlines() if path.exists() else []
        return [line.removeprefix("imx31-pdk: ") for line in lines
                if line.startswith("imx31-pdk: ")]

    def key(self, name, down):
        """Presses or releases a key of the keypad."""
        if name not in self.kind.keys:
            raise Error(f"{name}: no such key: {' '.join(self.kind.keys)}")
        (self.keys.add if down else self.keys.discard)(name)
        text = " ".join("%d,%d" % self.kind.keys[key]
                        for key in sorted(self.keys))
        self.monitor.run("qom-set", path="/machine/kpp", property="keys",
                         value=text)

    def press(self, button, seconds=0.1, gpio=False):
        """Presses a key of the keypad, or with gpio, or on a machine without
        keypad, the button on the GPIO line."""
        change = self.wires.level if gpio or not self.kind.keys else self.key
        change(button, True)
        time.sleep(seconds)
        change(button, False)

    def time_s(self):
        return self.wires.time_s()

    def ipu(self, name):
        """A figure that the IPU of the machine imx31-pdk counts."""
        return self.monitor.run("qom-get", path="/machine/ipu", property=name)

    def first_picture_s(self):
        """The time from the reset to the panel's first drawn picture, or None.
        The board's time runs on while nobody looks, so it is the IPU's."""
        return self.ipu("first-us") / 1e6 or None

    def watch_panel(self):
        """Begins to look for a change of the panel's picture."""
        self.monitor.run("qom-set", path="/machine/ipu", property="changed-us",
                         value=0)

    def changed_s(self):
        """The time from the reset to the first row of the panel that has changed
        since watch_panel(), or None."""
        return self.ipu("changed-us") / 1e6 or None

    def clear(self):
        """Clears the screen and what it is drawn from to black."""
        for address in self.kind.pictures(self.monitor):
            self.wires.run(f"memset {address:#x} {FRAME_BYTES:#x} 0x00")

    def frame(self):
        """Returns what the screen shows: rows of RGB565, little-endian."""
        return self.picture(self.kind.picture_at)

    def pages(self):
        """The pictures in memory that the screen shows or has shown last."""
        return [self.picture(address)
                for address in self.kind.pictures(self.monitor)]

    def picture(self, address, size=FRAME_BYTES):
        name = f"frame-{os.getpid()}.raw"
        self.monitor.run("pmemsave", val=address, size=size, filename=name)
        path = self.folder / name
        data = path.read_bytes()
        path.unlink()
        return data


def rgb_of(frame):
    """Converts RGB565 to three bytes a pixel, full range."""
    pixels = array.array("H", frame)
    if sys.byteorder == "big":
        pixels.byteswap()
    out = bytearray(len(pixels) * 3)
    five = [value * 255 // 31 for value in range(32)]
    six = [value * 255 // 63 for value in range(64)]
    out[0::3] = bytes(five[pixel >> 11] for pixel in pixels)
    out[1::3] = bytes(six[pixel >> 5 & 63] for pixel in pixels)
    out[2::3] = bytes(five[pixel & 31] for pixel in pixels)
    return bytes(out)


def png_of(frame, width=WIDTH, height=HEIGHT):
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))

    rgb = rgb_of(frame)
    rows = b"".join(b"\0" + rgb[y * width * 3:(y + 1) * width * 3]
                    for y in range(height))
    return (b"\x89PNG\r\n\x1a\n" +
            chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2,
                                       0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows, 6)) + chunk(b"IEND", b""))
