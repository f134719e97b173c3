#!/usr/bin/env python3
"""boot_console.py LOADER FILES LOG [FAULT...]: a boot loader on a pty.

Prints the line's path, then answers on it as U-Boot or RedBoot would, with
memory and a NAND of its own, until it is ended. NAND names the chip's file, which
the emulated board boots from, and beside which NAND.fis has RedBoot's directory;
without it the chip is gone at the end. LOG gets each command as it was received.
FILES is the TFTP server's folder. A FAULT is NAME or NAME=COUNT: the first COUNT
(1) times something goes wrong.

lose=N loses every Nth character of those that come hurriedly, drop=N just the
Nth one. cut=N cuts the power in the middle of the Nth erase or program of the
NAND, and the line ends; with "returns" the power comes back instead, and the boot
loader starts again. The messages' wording is that of the two programs' sources
and manuals.
"""
import json
import os
import pathlib
import re
import signal
import sys
import tempfile
import time
import tty
import zlib

BOARD = pathlib.Path(__file__).resolve().parents[2] / "board/imx31-pdk"
sys.path.insert(0, str(BOARD))
import nand  # noqa: E402

PAGE = nand.PAGE
# Neither boot loader writes more than a partition at once.
LIMIT = nand.ROOTFS_BYTES


# The bits of each byte, from the lowest to the highest.
MIRRORED = bytes(int(f"{byte:08b}"[::-1], 2) for byte in range(256))


def cksum(data):
    """POSIX cksum: the CRC of the bytes and of their length, from the highest bit
    on, where zlib's begins at the lowest."""
    length = len(data)
    tail = length.to_bytes((length.bit_length() + 7) // 8, "little")
    mirrored = zlib.crc32((data + tail).translate(MIRRORED), 0xFFFFFFFF)
    return int(f"{mirrored:032b}"[::-1], 2)


def spoil(data):
    """The data with another first byte."""
    return bytes([data[0] ^ 0xFF]) + data[1:]


class Board:
    def __init__(self, files, log, faults):
        self.files = files
        self.log = log
        self.faults = faults
        self.path = os.environ.get("NAND") or self.own_file()
        self.chip = nand.Nand(self.path)
        self.power_on()

    def power_on(self):
        """The power comes, or comes back after a cut."""
        self.chip.cut_after = self.faults.pop("cut", None)
        self.memory = {}
        self.environment = {}

    def own_file(self):
        # pylint: disable-next=consider-using-with
        self.folder = tempfile.TemporaryDirectory()
        return os.path.join(self.folder.name, "nand")

    def fault(self, name):
        if self.faults.get(name, 0) > 0:
            self.faults[name] -= 1
            return True
        return False

    def fetch(self, name):
        with open(os.path.join(self.files, name), "rb") as file:
            data = file.read()
        if self.fault("short"):
            data = data[:-512]
        if self.fault("corrupt"):
            data = spoil(data)
        return data

    def store(self, address, data):
        self.memory[address] = bytes(data)

    def read(self, address, offset, size):
        """Reads the chip into memory, which stays as it was after an error."""
        try:
            self.store(address, self.chip.read(offset, size, LIMIT))
        except nand.Error:
            return False
        return True

    def range(self, address, length):
        return self.memory.get(address, b"")[:length].ljust(length, b"\0")


class UBoot(Board):
    prompt = "MX31PDK U-Boot > "
    autoboot = "Hit any key to stop autoboot:  3 "

    def run(self, line):
        words = line.replace("'", " ").split()
        if not words:
            return ""
        handler = getattr(self, "do_" + words[0], None)
        if not handler:
            return f"Unknown command '{words[0]}' - try 'help'\n"
        return handler(words[1:])

    def do_setenv(self, words):
        self.environment[words[0]] = " ".join(words[1:])
        return ""

    def do_saveenv(self, _):
        return "Saving Environment to NAND...\nErasing NAND...\nOK\n"

    def do_tftpboot(self, words):
        head = "Using smc911x-0 device\n"
        if "address" in self.faults and "ipaddr" not in self.environment:
            return "*** ERROR: `ipaddr' not set\n"
        if self.fault("silent_server"):
            return head + "Loading: T T T T \nRetry count exceeded; try 'help'\n"
        if self.fault("refuse"):
            return head + "Loading: *\nTFTP error: 'Access violation' (2)\nNot retrying...\n"
        if not os.path.exists(os.path.join(self.files, words[1])):
            return head + "Loading: *\nTFTP error: 'File not found' (1)\nNot retrying...\n"
        data = self.fetch(words[1])
        self.store(int(words[0], 16), data)
        return (head + "Loading: " + "#" * 60 + "\ndone\n"
                + f"Bytes transferred = {len(data)} ({len(data):x} hex)\n")

    def do_crc32(self, words):
        address, length = int(words[0], 16), int(words[1], 16)
        value = zlib.crc32(self.range(address, length))
        return (f"crc32 for {address:08x} ... {address + length - 1:08x}"
                f" ==> {value:08x}\n")

    def do_nand(self, words):
        if words[0] == "erase":
            offset, size = int(words[1], 16), int(words[2], 16)
            if self.fault("erase"):
                return "Erasing at 0x100000 --   5% complete.\nMTD Erase failure: -5\n"
            self.chip.erase(offset, size)
            return "\rErasing at 0x5e0000 -- 100% complete.\nOK\n"
        address, offset, size = (int(word, 16) for word in words[1:4])
        if size % PAGE:
            return "Attempt to write non page-aligned data\n"
        if words[0] == "read":
            head = f"\nNAND read: device 0 offset 0x{offset:x}, size 0x{size:x}\n"
            if not self.read(address, offset, size):
                return (head + f"NAND read from offset {offset:x} failed -74\n"
                        " 0 bytes read: ERROR\n")
            return head + f" {size} bytes read: OK\n"
        if self.chip.read(offset, size, LIMIT).count(0xFF) != size:
            return "NAND write to offset failed -5\n 0 bytes written: ERROR\n"
        data = self.range(address, size)
        if self.fault("write"):
            data = spoil(data)
        self.chip.write(offset, data, LIMIT, words[0].endswith("trimffs"))
        return f"\nNAND write: device 0 offset 0x{offset:x}, size 0x{size:x}\n {size} bytes written: OK\n"

    def do_bootz(self, words):
        return ("Starting kernel ...\n\nUncompressing Linux... done.\n"
                "[    0.000000] Linux version 6.1\n")


class RedBoot(Board):
    prompt = "RedBoot> "
    autoboot = "== Executing boot script in 1.000 seconds - enter ^C to abort\n"

    def power_on(self):
        super().power_on()
        self.pending = None
        self.directory = pathlib.Path(f"{self.path}.fis")
        self.fis = (json.loads(self.directory.read_text())
                    if self.directory.exists() else {})

    def run(self, line):
        if self.pending:
            action, self.pending = self.pending, None
            return action() if line.startswith("y") else "\n"
        words = line.split()
        if not words:
            return ""
        handler = getattr(self, "do_" + words[0], None)
        return handler(words[1:]) if handler else "** Error: Illegal command: \"%s\"\n" % words[0]

    @staticmethod
    def flags(words):
        return {words[i]: int(words[i + 1], 0) for i in range(len(words) - 1)
                if re.fullmatch("-[belfrs]", words[i]) and words[i + 1][0] != "-"}

    def do_ip_address(self, words):
        return "IP: 192.168.1.9/255.255.255.0, Gateway: 0.0.0.0\nDefault server: 192.168.1.2\n"

    def do_load(self, words):
        address = self.flags(words)["-b"]
        if self.fault("silent_server"):
            return f"Can't load '{words[-1]}': operation timed out\n"
        if self.fault("refuse"):
            return f"Can't load '{words[-1]}': access violation\n"
        if not os.path.exists(os.path.join(self.files, words[-1])):
            return f"Can't load '{words[-1]}': file not found\n"
        data = self.fetch(words[-1])
        self.store(address, data)
        end = address + len(data) - 1
        return ("Using default protocol (TFTP)\n"
                f"Raw file loaded 0x{address:08x}-0x{end:08x}, assumed entry at 0x{address:08x}\n")

    def do_cksum(self, words):
        flags = self.flags(words)
        value = cksum(self.range(flags["-b"], flags["-l"]))
        return (f"POSIX cksum = {value} {flags['-l']}"
                f" (0x{value:08x} 0x{flags['-l']:08x})\n")

    def do_fis(self, words):
        flags = self.flags(words)
        name = words[-1]
        if words[0] == "list":
            return ("Name              FLASH addr  Mem addr    Length      Entry point\n"
                    "RedBoot           0xE0000000  0xE0000000  0x00040000  0x00000000\n")
        if words[0] == "load":
            if name not in self.fis:
                return f"No image '{name}' found\n"
            offset, size = self.fis[name]
            if not self.read(flags["-b"], offset, size):
                return f"Error: '{name}' cannot be read\n"
            return ""
        if words[0] != "create":
            return "** Error: unrecognized FIS command\n"
        self.pending = lambda: self.create(name, flags)
        return (f"An image named '{name}' exists - continue (y/n)? "
                if name in self.fis else
                f"* CAUTION * about to program '{name}'\n"
                f"            at 0x{flags['-f']:08x} - continue (y/n)? ")

    def create(self, name, flags):
        offset = flags["-f"] - 0xE0000000
        if self.fault("erase"):
            return "... Erase from 0xe0100000-0xe0600000: \nCan't erase region: error\n"
        data = bytearray(self.range(flags["-b"], flags["-s"]))
        if self.fault("write"):
            data[0] ^= 1
        self.chip.erase(offset, flags["-l"])
        self.chip.write(offset, bytes(data), LIMIT)
        self.fis[name] = (offset, len(data))
        self.directory.write_text(json.dumps(self.fis))
        return "\n... Erase from 0xe0100000: ....\n... Program from 0x00100000: ....\n"

    def do_exec(self, words):
        return "Using base address 0x00100000\nUncompressing Linux... done, booting the kernel.\n"


class Console:
    def __init__(self, board, line):
        self.board = board
        self.line = line
        self.received = 0
        self.heard_s = 0.0
        self.text = b""

    def say(self, text):
        os.write(self.line, text.replace("\n", "\r\n").encode())

    def begin(self):
        """Waits for the key that stops the boot loader, and shows the prompt."""
        self.text = b""
        while True:
            self.say("Boot loader 1.0\n" + self.board.autoboot)
            if os.read(self.line, 1) == b"\x03":
                break
        self.prompt()

    def prompt(self):
        if not getattr(self.board, "pending", None):
            self.say("limber login: " if self.board.faults.get("linux")
                     else self.board.prompt)

    def take(self, byte):
        now = time.monotonic()
        hurried = now - self.heard_s < 0.002
        self.heard_s = now
        self.received += 1
        lose = self.board.faults.get("lose")
        if lose and hurried and self.received % lose == 0:
            return
        if self.received == self.board.faults.get("drop"):
            return
        if byte == b"\x03":
            self.text = b""
            self.say("^C\n")
            self.prompt()
        elif byte == b"\r":
            line, self.text = self.text.decode(), b""
            self.say("\n")
            if line:
                self.board.log.write(line + "\n")
                self.board.log.flush()
            if line and self.board.fault("deaf"):
                return
            self.say(self.board.run(line))
            self.prompt()
        else:
            self.text += byte
            os.write(self.line, byte)


def main():
    loader, files, log = sys.argv[1:4]
    faults = {}
    for word in sys.argv[4:]:
        name, _, count = word.partition("=")
        faults[name] = int(count or 1)
    # So that ending it removes the chip's folder.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit())
    line, other = os.openpty()
    tty.setraw(other)
    print(os.ttyname(other), flush=True)
    kind = {"uboot": UBoot, "redboot": RedBoot}[loader]
    with open(log, "w", encoding="ascii") as log_file:
        console = Console(kind(files, log_file, faults), line)
        if console.board.fault("autoboot"):
            console.begin()
        while True:
            try:
                console.take(os.read(line, 1))
            except InterruptedError:
                if not console.board.fault("returns"):
                    break
                console.board.power_on()
                console.begin()


if __name__ == "__main__":
    main()
