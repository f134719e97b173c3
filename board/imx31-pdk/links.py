"""The sockets that control a running QEMU: the console, QMP and qtest."""
import contextlib
import json
import os
import re
import socket
import threading
import time

# The line of GPIO2 for each button (README.md, "Wire the buttons").
BUTTONS = {"UP": 18, "DOWN": 19, "LEFT": 20, "RIGHT": 21, "ENTER": 22,
           "F6": 23, "F8": 24, "F9": 25}
GPIO2 = "/machine/soc/gpio[1]"

# A timer that the kernel does not use counts down at 32768 Hz from the first
# instruction on. It measures the time of the guest and of its boot loader.
TIMER_CONTROL, TIMER_COUNT = 0x53F94000, 0x53F94010
TIMER_RUN = 3 << 24 | 1 << 1 | 1 << 0
TIMER_HZ = 32768.0
TIMER_START = 0xFFFFFFFF

# How long QEMU may take to answer, even on a busy machine.
ANSWER_S = 180


class Error(Exception):
    """A failure whose text is a message for the user."""


def connect(folder, name):
    """Connects to the socket folder/name. The path may be longer than a Unix
    socket's name. QEMU may listen only a while after the file exists."""
    descriptor = os.open(folder, os.O_PATH)
    try:
        for left in reversed(range(100)):
            link = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
            try:
                link.settimeout(ANSWER_S)
                link.connect(f"/proc/self/fd/{descriptor}/{name}")
                return link
            except OSError as error:
                link.close()
                if left == 0 or not isinstance(error, ConnectionRefusedError):
                    raise
            time.sleep(0.02)
    finally:
        os.close(descriptor)


class Lines:
    """Requests and answers in lines over a socket. Requests are not buffered,
    so nothing is left to send when QEMU has ended. After an answer that was
    late every request fails, because the late answer would be taken for its."""

    def __init__(self, folder, name):
        self.link = connect(folder, name)
        self.file = self.link.makefile("r", encoding="utf-8", newline="\n")
        self.is_late = False

    @contextlib.contextmanager
    def errors(self):
        """Turns errors of the socket into an Error."""
        if self.is_late:
            raise Error("QEMU does not answer")
        try:
            yield
        except ConnectionError:
            raise Error("QEMU has ended") from None
        except TimeoutError:
            self.is_late = True
            raise Error("QEMU does not answer") from None

    def ask(self, text):
        with self.errors():
            self.link.sendall(f"{text}\n".encode())
        return self.read()

    def read(self):
        with self.errors():
            line = self.file.readline()
        if not line.endswith("\n"):
            raise Error("QEMU has ended")
        return line[:-1]

    def close(self):
        self.file.close()
        self.link.close()


class Console:
    """Types at the board's console. QEMU stops the board while nobody reads its
    output, so the output is read and dropped; the log has it, too."""

    def __init__(self, folder):
        self.link = connect(folder, "console.sock")
        self.link.settimeout(None)
        threading.Thread(target=self.drop, daemon=True).start()

    def drop(self):
        try:
            while self.link.recv(65536):
                pass
        except OSError:
            pass

    def type(self, text):
        self.link.sendall(text.encode())

    def close(self):
        self.link.close()


class Monitor:
    """QMP: commands with JSON answers."""

    def __init__(self, folder):
        self.lines = Lines(folder, "qmp.sock")
        self.lines.read()
        self.events = []
        self.run("qmp_capabilities")

    def run(self, command, **arguments):
        answer = json.loads(self.lines.ask(json.dumps(
            {"execute": command, "arguments": arguments})))
        while "return" not in answer:
            if "error" in answer:
                why = answer["error"]["desc"]
                raise Error(f"QEMU refuses {command}: {why}")
            self.events.append(answer)
            answer = json.loads(self.lines.read())
        return answer["return"]

    def close(self):
        self.lines.close()


class Wires:
    """qtest: the chip's pins and registers."""

    def __init__(self, folder, kind):
        self.kind = kind
        self.lines = Lines(folder, "qtest.sock")
        # Changes of GPIO2's outputs since watch(): line and level.
        self.changes = []

    def run(self, command):
        answer = self.lines.ask(command)
        while change := re.fullmatch(r"IRQ (raise|lower) (\d+)", answer):
            self.changes.append((int(change[2]), change[1] == "raise"))
            answer = self.lines.read()
        if not answer.startswith("OK"):
            raise Error(f"QEMU refuses {command}: {answer}")
        return answer[2:].strip()

    def level(self, button, high):
        if button not in BUTTONS:
            raise Error(f"{button}: no such button: {' '.join(BUTTONS)}")
        pin = self.kind.button_pin(BUTTONS[button])
        self.run(f"set_irq_in {pin} {int(high)}")

    def watch(self):
        """Lets every later command note what GPIO2's outputs have done."""
        self.run(f"irq_intercept_out {GPIO2}")

    def start_timer(self):
        # After a reset the timer is enabled, but does not run.
        self.run(f"writel {TIMER_CONTROL:#x} 0")
        self.run(f"writel {TIMER_CONTROL:#x} {TIMER_RUN:#x}")

    def time_s(self):
        """Guest time since start_timer()."""
        if int(self.run(f"readl {TIMER_CONTROL:#x}"), 16) != TIMER_RUN:
            raise Error("the board has been reset, which stopped its timer")
        count = int(self.run(f"readl {TIMER_COUNT:#x}"), 16)
        return (TIMER_START - count) / TIMER_HZ

    def close(self):
        self.lines.close()
