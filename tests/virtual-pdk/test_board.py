"""The server's connection to QEMU, with a replacement that ends or hangs at
chosen moments: the page always learns of it, and no process is left. Messages
that no page sends are ignored. TAP."""
import asyncio
import os
import pathlib
import shutil
import signal
import sys
import time
import traceback

HERE = pathlib.Path(__file__).resolve().parent
TOP = HERE.parents[1]
FOLDER = TOP / "build/check-virtual-board"
STATE, IMAGE, PROGRAMS = (FOLDER / name for name in ("state", "image", "bin"))
sys.dont_write_bytecode = True
sys.path.insert(0, str(TOP / "board/imx31-pdk/virtual"))
import board  # noqa: E402
import pages  # noqa: E402
from overlay import emulation, links  # noqa: E402

TOLD_S = 10
# How long a test waits, and after how long the server gives a QEMU up.
links.ANSWER_S = 1
emulation.ENDINGS = tuple((number, 1) for number, _ in emulation.ENDINGS)

_count = _failed = 0


def check(name, good, why=""):
    global _count, _failed
    _count += 1
    _failed += not good
    print(f"{'ok' if good else 'not ok'} {_count} - {name}", flush=True)
    for line in [] if good else str(why).splitlines():
        print(f"# {line}", flush=True)


class Listener:
    """A page that watches the board and records its phases."""

    def __init__(self):
        self.board = None
        self.looks = True
        self.phases = []

    def state(self):
        if self.phases[-1:] != [self.board.phase]:
            self.phases.append(self.board.phase)

    def log(self, _):
        pass

    def picture(self, *_):
        pass

    def is_watched(self):
        return self.looks


async def until(condition, seconds=TOLD_S):
    end = time.monotonic() + seconds
    while time.monotonic() <= end:
        if condition():
            return True
        await asyncio.sleep(0.005)
    return condition()


def prepare():
    shutil.rmtree(FOLDER, ignore_errors=True)
    for folder in (STATE, IMAGE, PROGRAMS):
        folder.mkdir(parents=True)
    (PROGRAMS / "qemu-system-arm").symlink_to(HERE / "fake_qemu.py")
    os.environ["PATH"] = f"{PROGRAMS}:{os.environ['PATH']}"
    os.environ["EMULATOR"] = "kzm"
    for name in ("zImage", "imx31-pdk-limber.dtb", "initramfs.cpio.lz4",
                 "test-drivers.cpio.lz4"):
        (IMAGE / name).write_bytes(b"console=none")
    board.overlay.make_tree = lambda image, folder: image / "zImage"
    board.overlay.make_archive = lambda folder: IMAGE / "zImage"


def command(name, on=True):
    path = STATE / name
    if on:
        path.touch()
    else:
        path.unlink(missing_ok=True)


async def is_running(virtual):
    await virtual.power(True)
    return await until(lambda: virtual.phase == "running")


def kill(virtual, number=signal.SIGKILL):
    os.kill(virtual.machine.process.pid, number)


async def check_told(name, virtual, why):
    """Checks that the end is reported with that word, that no process is left,
    and that the board starts again."""
    process = virtual.machine.process
    reported = await until(lambda: virtual.phase == "ended")
    check(f"{name}: it is reported", reported and why in virtual.why,
          f"{virtual.phase}: {virtual.why}")
    check(f"{name}: no process is left", process.poll() is not None)
    if not reported:
        await virtual.power(False)
    check(f"{name}: it starts again", await is_running(virtual), virtual.why)


async def test_deaths(virtual):
    for wait_s in (0, 0.004, 0.011, 0.02, 0.035):
        await asyncio.sleep(wait_s)
        kill(virtual)
        await check_told(f"QEMU dies after {wait_s * 1000:.0f} ms", virtual,
                         "QEMU has ended")
    # In this thread no request is being sent; the next one must fail.
    kill(virtual)
    virtual.machine.process.wait()
    await check_told("QEMU dies between questions", virtual, "QEMU has ended")
    command("half")
    await until(lambda: virtual.phase == "ended")
    command("half", False)
    await check_told("QEMU dies in an answer", virtual, "QEMU has ended")
    kill(virtual)
    await virtual.reset()
    await check_told("QEMU dies before a reset", virtual, "QEMU has ended")
    kill(virtual, signal.SIGTERM)
    await check_told("somebody ends QEMU", virtual, "QEMU has ended")


async def test_hanging(virtual):
    kill(virtual, signal.SIGSTOP)
    await check_told("QEMU hangs", virtual, "does not answer")
    kill(virtual, signal.SIGSTOP)
    await virtual.reset()
    await check_told("QEMU hangs in a reset", virtual, "does not answer")
    links.ANSWER_S = 60
    await virtual.power(False)
    check("it starts with patience", await is_running(virtual), virtual.why)
    kill(virtual, signal.SIGSTOP)
    await asyncio.sleep(0.1)
    reset = asyncio.create_task(virtual.reset())
    await asyncio.sleep(0.1)
    begun = time.monotonic()
    await virtual.power(False)
    took_s = time.monotonic() - begun
    check("switched off, one that hangs ends at once",
          virtual.phase == "off" and took_s < 5, f"{virtual.phase}, {took_s} s")
    await reset
    command("deaf")
    check("it starts and ignores SIGTERM", await is_running(virtual), virtual.why)
    process = virtual.machine.process
    await virtual.power(False)
    check("one that ignores SIGTERM is killed",
          virtual.phase == "off" and process.returncode == -signal.SIGKILL)
    command("deaf", False)


async def test_switching_off_at_start(virtual):
    """Whether QEMU runs yet or not, nothing waits until it listens, which it
    never does."""
    await virtual.power(False)
    command("mute")
    for wait_s in (0, 0.01, 0.3):
        begun = time.monotonic()
        start = asyncio.create_task(virtual.power(True))
        await asyncio.sleep(wait_s)
        await virtual.power(False)
        await start
        took_s = time.monotonic() - begun
        process = virtual.machine.process
        check(f"switched off {wait_s} s after on, no process is left",
              virtual.phase == "off" and took_s < 5
              and (not process or process.poll() is not None),
              f"{virtual.phase}, {took_s} s")
    command("mute", False)


async def test_switching_off(virtual):
    """A press wakes the watching task at the moment it is cancelled."""
    left = []
    for ticks in range(6):
        await is_running(virtual)
        watcher = virtual.tasks[-1]
        # Then the task rests most of the time and sends no requests.
        virtual.listener.looks = False
        await asyncio.sleep(0.2)
        virtual.listener.phases.clear()
        virtual.hurry.set()
        for _ in range(ticks):
            await asyncio.sleep(0)
        await virtual.power(False)
        await asyncio.sleep(0.05)
        if not watcher.done() or virtual.listener.phases != ["off"]:
            left.append((ticks, virtual.listener.phases[:]))
        virtual.listener.looks = True
    check("switched off while pressed, the page stops watching", not left, left)


async def test_reset(virtual):
    check("it starts", await is_running(virtual), virtual.why)
    virtual.listener.phases.clear()
    begun = time.monotonic()
    await virtual.reset()
    await until(lambda: virtual.phase == "running")
    took_s = time.monotonic() - begun
    check("after a reset it runs once it has drawn again",
          virtual.listener.phases == ["booting", "running"] and took_s > 0.3,
          f"{virtual.listener.phases}, {took_s} s")


async def test_messages(virtual):
    """Messages that no page sends are ignored, and the next one is heard."""
    served = pages.Pages()
    served.board = virtual
    page = pages.Page(None)
    odd = {"no JSON": "rubbish", "an empty one": "", "a number": "1",
           "a list": "[]", "no type": "{}", "an unknown type": '{"type":"no"}',
           "a type that is a list": '{"type":[]}',
           "a button without a name": '{"type":"button"}',
           "a button whose name is a list": '{"type":"button","name":[]}',
           "text that is not there": '{"type":"type"}',
           "2,000 nested lists": "[" * 2000 + "]" * 2000,
           "2,000 nested objects": '{"a":' * 2000 + "1" + "}" * 2000}
    for name, message in odd.items():
        jobs = set()
        why = ""
        page.is_ready = False
        try:
            served.take(page, message, jobs)
            served.take(page, '{"type":"shown"}', jobs)
        except Exception:  # pylint: disable=broad-except
            why = traceback.format_exc()
        check(f"message with {name}: ignored", page.is_ready and not jobs, why)


async def test_console(virtual):
    """The console's characters are whole, wherever the line divides them."""
    line = asyncio.StreamReader()
    reader = asyncio.create_task(virtual.read_console(line))
    for part in (b"R\xc3", b"\xb6hre 5 \xe2", b"\x80", b"\xa6 \xff\n"):
        line.feed_data(part)
        await asyncio.sleep(0)
        await asyncio.sleep(0)
    line.feed_eof()
    await reader
    check("console: characters that arrive in parts are whole",
          virtual.log == "R\u00f6hre 5 \u2026 \ufffd\n", ascii(virtual.log))
    virtual.log = ""


async def test_all():
    listener = Listener()
    virtual = listener.board = board.Board(IMAGE, STATE, listener)
    try:
        await test_messages(virtual)
        await test_console(virtual)
        await test_reset(virtual)
        await test_deaths(virtual)
        await test_hanging(virtual)
        await test_switching_off_at_start(virtual)
        await test_switching_off(virtual)
    except Exception:  # pylint: disable=broad-except
        check("goes on to its end", False, traceback.format_exc())
    await virtual.end()


prepare()
asyncio.run(test_all())
print(f"1..{_count}")
sys.exit(1 if _failed else 0)
