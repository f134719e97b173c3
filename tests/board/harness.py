"""What the board's tests share: TAP, a booted machine, pictures, overlays.

A test is a script test_NAME.py beside this file. It boots the image with
booted(), calls check() for each expectation, and ends with done(). Its machines
have folders in build/check-board/NAME, which keep the console's output in
console.log.
"""
import array
import atexit
import json
import operator
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time
import traceback
import zlib

TOP = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "board/imx31-pdk"))
import emulation  # noqa: E402
import links  # noqa: E402
import machines  # noqa: E402
import nand  # noqa: E402

Error = emulation.Error
IMAGE = pathlib.Path(os.environ.get("IMAGE", TOP / "build/board/imx31-pdk"))
MODELS = pathlib.Path(os.environ.get("SAMPLES", TOP.parent / "shared")) / "models"
HOST = os.environ.get("LIMBER", str(TOP / "build/host/limber"))
GUEST = TOP / "build/board/guest"
DRIVERS = IMAGE / "test-drivers.cpio.lz4"
NAME = pathlib.Path(sys.argv[0]).stem.removeprefix("test_")
FOLDER = TOP / "build/check-board" / NAME
PATIENCE_S = int(os.environ.get("PATIENCE_S", 1150))
PROMPT = emulation.PROMPT

# With this inittab limber does not start by itself.
BY_HAND = {"etc/inittab": "::sysinit:/etc/rc\nttymxc0::respawn:-/bin/sh\n"}

_count = 0
_failed = 0
_machines = []


def check(name, good, why=""):
    global _count, _failed
    _count += 1
    print(f"{'ok' if good else 'not ok'} {_count} - {name}", flush=True)
    if not good:
        _failed += 1
        for line in str(why).splitlines()[-40:]:
            print(f"# {line}", flush=True)
    return good


def note(text):
    print(f"# {text}", flush=True)


def done():
    print(f"1..{_count}")
    sys.exit(1 if _failed else 0)


def _surprise(kind, error, trace):
    """Reports a test that ends early as failed, with its traceback."""
    check(f"goes on to its end: {kind.__name__}", False,
          "".join(traceback.format_exception(kind, error, trace)))
    for machine in _machines:
        if machine.pid():
            note("the end of the console's output:")
            for line in machine.log().splitlines()[-25:]:
                note(line)
    print(f"1..{_count}", flush=True)


sys.excepthook = _surprise


def _stop_all():
    for machine in _machines:
        machine.stop()


atexit.register(_stop_all)


def _too_long(*_):
    raise Error(f"{NAME} takes longer than {PATIENCE_S} s")


signal.signal(signal.SIGALRM, _too_long)
signal.alarm(PATIENCE_S)


def archive(files):
    """Makes an initramfs archive of executable files from a dictionary
    {path: text, bytes or Path}."""
    out = bytearray()
    inode = 0

    def add(name, mode, data):
        nonlocal inode
        inode += 1
        name = name.encode() + b"\0"
        fields = (inode, mode, 0, 0, 1, 0, len(data), 0, 0, 0, 0, len(name), 0)
        out.extend(b"070701" + b"".join(b"%08X" % field for field in fields))
        out.extend(name)
        out.extend(b"\0" * (-len(out) % 4))
        out.extend(data)
        out.extend(b"\0" * (-len(out) % 4))

    made = set()
    for path, data in files.items():
        for folder in reversed(pathlib.PurePath(path).parents):
            if str(folder) not in made | {"."}:
                made.add(str(folder))
                add(str(folder), 0o40755, b"")
        if isinstance(data, pathlib.Path):
            data = data.read_bytes()
        elif isinstance(data, str):
            data = data.encode()
        add(path, 0o100755, data)
    add("TRAILER!!!", 0, b"")
    return bytes(out)


def device_tree(*disabled):
    """Makes the board's device tree without some of its nodes."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    tree = FOLDER / "tree.dtb"
    shutil.copyfile(IMAGE / "imx31-pdk-limber.dtb", tree)
    for node in disabled:
        subprocess.run(["fdtput", "-t", "s", str(tree), node, "status",
                        "disabled"], check=True)
    return tree


def needs_pdk():
    """Ends the test, skipped, where the machine imx31-pdk is not built."""
    if machines.choose() is not machines.Pdk:
        print("1..0 # SKIP the machine imx31-pdk is not built here")
        sys.exit(0)


def flashed():
    """A new file with the NAND chip that flash.sh has written, as a Nand."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    return nand.flashed(FOLDER / "nand.bin", IMAGE)


def flash_write(loader, path, *faults):
    """flash.sh write at the console of that boot loader, into the NAND's file;
    faults are those of tests/flash/boot_console.py. Returns the exit status and
    the output of flash.sh."""
    command = [sys.executable, "-B", TOP / "tests/flash/boot_console.py", loader,
               IMAGE, f"{path}.console", *faults]
    with subprocess.Popen(command, env=os.environ | {"NAND": str(path)},
                          stdout=subprocess.PIPE, text=True) as console:
        line = console.stdout.readline().strip()
        run = subprocess.run(
            [TOP / "board/imx31-pdk/flash.sh", "write", "--yes", "--port", line,
             "--images", IMAGE, "--tries", "1"],
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True)
        console.terminate()
    return run.returncode, run.stdout


def stopped_at_end(machine):
    """Stops a machine with the test; its console is shown if the test fails."""
    _machines.append(machine)
    return machine


def booted(files=None, drivers=False, tree=None, shell=True, kind=None, **how):
    """A machine that runs the image; files lie over its root file system. Its
    time is a count of instructions, so a busy host changes nothing. kind names
    the machine (machines.choose)."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    extra = []
    if files:
        overlay = FOLDER / "overlay.cpio"
        overlay.write_bytes(archive(files))
        extra.append(overlay)
    if drivers:
        extra.append(DRIVERS)
    machine = stopped_at_end(
        emulation.Machine(FOLDER / f"machine-{len(_machines)}", kind))
    machine.start(IMAGE, extra, tree=tree, icount=True, **how)
    if shell:
        machine.wait(PROMPT)
    return machine


def guest_tool():
    """The small program for what the board's shell cannot do."""
    return {"usr/bin/guest": GUEST}


def wait_until(machine, condition, seconds, look_s=0.01):
    """Until condition() is true, for at most this long on the board; the time
    on the board then, or None. Looks every look_s of this machine's time, and
    at least once when the time is over, as the board runs on while a busy
    machine does not look at it."""
    begun = machine.time_s()
    while True:
        over = machine.time_s() - begun > seconds
        if condition():
            return machine.time_s()
        if over:
            return None
        time.sleep(look_s)


def first_picture_s(machine, seconds=10):
    """The time from power-on or reset to the first picture, or None."""
    if machine.kind is machines.Pdk:
        wait_until(machine, machine.first_picture_s, seconds)
        return machine.first_picture_s()
    return wait_until(machine, lambda: is_drawn(machine.frame()), seconds)


def shown_after_s(machine, press, seconds=2):
    """Calls press() while the board stands still; the board's time from then
    until its panel shows a change, or infinity. A busy host changes nothing."""
    machine.monitor.run("stop")
    machine.watch_panel()
    begun_s = machine.time_s()
    press()
    machine.monitor.run("cont")
    wait_until(machine, machine.changed_s, seconds)
    return (machine.changed_s() or float("inf")) - begun_s


def pause(machine, seconds):
    """Lets time pass on the board."""
    until = machine.time_s() + seconds
    while machine.time_s() < until:
        time.sleep(0.005)


def pixel(frame, x, y):
    at = 2 * (y * emulation.WIDTH + x)
    return frame[at] | frame[at + 1] << 8


def is_drawn(frame):
    """More than a console's few colours."""
    return len({frame[at:at + 2] for at in range(0, len(frame), 1998)}) > 12


def save(frame, name):
    """Keeps a picture for a person to look at."""
    path = FOLDER / name
    path.write_bytes(emulation.png_of(frame))
    return path


def host_picture(*arguments):
    """What limber draws on this machine, as RGB565."""
    path = FOLDER / "host.png"
    path.unlink(missing_ok=True)
    subprocess.run([HOST, "render", *arguments, "--gl", "soft", "--format",
                    "rgb565", "-o", str(path)], check=True,
                   stdin=subprocess.DEVNULL)
    return frame_of_png(path.read_bytes())


def frame_of_png(data):
    """RGB565 of a picture as limber writes it: 8-bit RGB or RGBA."""
    at, packed, header = 8, b"", None
    while at < len(data):
        length = int.from_bytes(data[at:at + 4], "big")
        kind, body = data[at + 4:at + 8], data[at + 8:at + 8 + length]
        header = body if kind == b"IHDR" else header
        packed += body if kind == b"IDAT" else b""
        at += 12 + length
    width, height = (int.from_bytes(header[i:i + 4], "big") for i in (0, 4))
    if header[8] != 8 or header[9] not in (2, 6) or header[12]:
        raise Error("the host's picture is no 8-bit RGB PNG")
    size = 4 if header[9] == 6 else 3
    raw, rows, above = zlib.decompress(packed), [], bytes(width * size)
    for y in range(height):
        start = y * (width * size + 1)
        above = unfilter(raw[start], raw[start + 1:start + 1 + width * size],
                         above, size)
        rows.append(above)
    out = bytearray()
    for row in rows:
        for x in range(0, len(row), size):
            value = row[x] >> 3 << 11 | row[x + 1] >> 2 << 5 | row[x + 2] >> 3
            out += value.to_bytes(2, "little")
    return bytes(out)


def unfilter(kind, row, above, size):
    """PNG's five filters, section 9.2 of its specification."""
    row = bytearray(row)
    for x in range(len(row)):
        left = row[x - size] if x >= size else 0
        up = above[x]
        corner = above[x - size] if x >= size else 0
        if kind == 1:
            add = left
        elif kind == 2:
            add = up
        elif kind == 3:
            add = (left + up) // 2
        elif kind == 4:
            near = left + up - corner
            apart = (abs(near - left), abs(near - up), abs(near - corner))
            add = (left, up, corner)[apart.index(min(apart))]
        else:
            add = 0
        row[x] = (row[x] + add) & 255
    return bytes(row)


def limber_pid(machine):
    status, said = machine.shell("pidof limber")
    return int(re.findall(r"^(\d+)$", said, re.M)[0]) if status == 0 else None


# Commands that run while limber runs take time from its frames. So the shell
# executes them itself; a program that it starts would take about 20 ms.

def start_limber(machine, arguments, seconds=10):
    """Starts it by hand in the background, until its picture is there."""
    machine.clear()
    status, said = machine.shell(f"cd /run/tmp; limber play {arguments} "
                                 ">/run/said 2>&1 & limber=$!")
    if wait_until(machine, lambda: is_drawn(machine.frame()), seconds) is None:
        raise Error(f"limber {arguments} shows nothing:\n"
                    + machine.shell("cat /run/said")[1])


def limber_memory_kib(machine):
    """What start_limber()'s has taken for itself, and its peak in all."""
    said = machine.shell(
        "while read -r line; do case $line in RssAnon*|VmHWM*) echo $line;; "
        "esac; done </proc/$limber/status")[1]
    return [int(re.search(rf"^{name}:\s+(\d+)", said, re.M)[1])
            for name in ("RssAnon", "VmHWM")]


def stop_limber(machine):
    """Ends what start_limber() started; what it has said. In one command, because
    the shell tells after it, at a moment of its own, that the job has ended."""
    return machine.shell("kill $limber; wait $limber; cat /run/said")[1]


def frames_of(machine, demo, frames):
    """Frames and memory of a run on the framebuffer, as fast as it can."""
    status, said = machine.shell(
        f"limber play --demo {demo} --gl soft --clock fixed:25 --frames "
        f"{frames} --stats /run/stats >/dev/null & "
        "while kill -0 $! 2>/dev/null; do grep VmHWM /proc/$!/status "
        "2>/dev/null; usleep 200000; done; cat /run/stats", 300)
    peaks = [int(peak) for peak in re.findall(r"VmHWM:\s+(\d+)", said)]
    stats = json.loads(re.search(r"\{.*\}", said, re.S)[0])
    return {"fps": stats["fps"], "work_ms": stats["work_ms"],
            "memory_mib": round(max(peaks) / 1024, 1)}


def region(frame, x, y, width, height):
    row = 2 * emulation.WIDTH
    return b"".join(frame[at * row + 2 * x:at * row + 2 * (x + width)]
                    for at in range(y, y + height))


def difference(a, b):
    """How many pixels differ."""
    a, b = array.array("H", a), array.array("H", b)
    return sum(map(operator.ne, a, b))
