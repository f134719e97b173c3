#!/usr/bin/python3
"""A replacement of QEMU for the server of the virtual PDK: sockets that answer.
Files in its folder make it fail:

  half      it ends in the middle of its next answer with the picture
  deaf      it ignores SIGTERM
  mute      it never listens
"""
import json
import os
import pathlib
import selectors
import signal
import socket
import time

FRAME_BYTES = 480 * 640 * 2
RESET_S, BOOT_S = 0.1, 0.3


class Guest:
    """Draws all the time, except while it is stopped or boots. A reset happens
    a moment after QEMU has acknowledged it."""

    def __init__(self):
        self.moves = False
        self.picture = bytes(FRAME_BYTES)
        self.reset_s = self.booted_s = None

    def look(self):
        now = time.monotonic()
        if self.reset_s is not None and now >= self.reset_s:
            self.reset_s, self.booted_s = None, now + BOOT_S
        if self.moves and (self.booted_s is None or now >= self.booted_s):
            self.picture = os.urandom(FRAME_BYTES)

    def ask_monitor(self, said):
        name, words = said["execute"], said["arguments"]
        self.look()
        if name == "pmemsave":
            pathlib.Path(words["filename"]).write_bytes(self.picture)
            if os.path.exists("half"):
                return None
        elif name in ("stop", "cont"):
            self.moves = name == "cont"
        elif name == "system_reset":
            self.reset_s = time.monotonic() + (RESET_S if self.moves else 0)
        return {"return": {}}

    def ask_wires(self, words):
        self.look()
        if words[0] == "memset":
            self.picture = bytes(FRAME_BYTES)
        return "OK"


def answer(guest, name, line):
    """Returns the answer as bytes, or None to end in the middle of it."""
    if name == "qtest.sock":
        return f"{guest.ask_wires(line.split())}\n".encode()
    said = guest.ask_monitor(json.loads(line))
    return None if said is None else (json.dumps(said) + "\n").encode()


def take(guest, name, link, rest):
    data = link.recv(65536)
    *lines, rest = (rest + data).split(b"\n")
    if name in ("qmp.sock", "qtest.sock"):
        for line in lines:
            said = answer(guest, name, line.decode())
            if said is None:
                link.sendall(b'{"ret')
                os._exit(1)
            link.sendall(said)
    return rest if data else None


def main():
    if os.path.exists("deaf"):
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
    if os.path.exists("mute"):
        signal.pause()
    guest, doors = Guest(), selectors.DefaultSelector()
    for name in ("camera.sock", "qmp.sock", "qtest.sock", "console.sock"):
        door = socket.socket(socket.AF_UNIX)
        door.bind(f"{name}.new")
        door.listen()
        os.rename(f"{name}.new", name)
        doors.register(door, selectors.EVENT_READ, (name, None))
    while True:
        for key, _ in doors.select():
            name, rest = key.data
            if rest is None:
                link = key.fileobj.accept()[0]
                doors.register(link, selectors.EVENT_READ, (name, b""))
                if name == "qmp.sock":
                    link.sendall(b'{"QMP": {}}\n')
                continue
            rest = take(guest, name, key.fileobj, rest)
            if rest is None:
                doors.unregister(key.fileobj)
                key.fileobj.close()
            else:
                doors.modify(key.fileobj, selectors.EVENT_READ, (name, rest))


main()
