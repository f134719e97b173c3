"""The picture's way through the IPU onto the panel: pictures that equal the
host's, also by screendump and VNC, garbled ones where the IPU is told a wrong
stride or format, flips at the panel's rate that are not torn, and their cost."""
import array
import json
import re
import struct

from harness import (BY_HAND, Error, booted, check, difference, done,
                     emulation, guest_tool, host_picture, links, needs_pdk,
                     note, pause, save, start_limber, stop_limber, wait_until)

SHOWS = "the panel shows the picture"
# The shell may be there before the panel is awake.
AWAKE_S = 2
FLIPS = 16
# The Epson panel's clocks a frame and the dividers of 133 MHz that reach them.
PANEL_HZ = 133e6 * 16 / 88 / (561 * 665)

# Words of the background's channel (14) in the IPU's parameter memory.
IPU = 0x53FC0000
IPU_MEMORY_ADDRESS, IPU_MEMORY_DATA = IPU + 0x20, IPU + 0x24
STRIDE_WORD, COLORS_WORD = (0x10000 + 16 * 14 + word for word in (10, 11))

VNC = ("-vnc", "unix:vnc.sock")


def rgb565(pixels):
    """Packs (red, green, blue) of eight bits each."""
    return b"".join(struct.pack("<H", red >> 3 << 11 | green >> 2 << 5
                                | blue >> 3) for red, green, blue in pixels)


def by_screendump(machine):
    machine.monitor.run("screendump", filename="screen.ppm")
    path = machine.folder / "screen.ppm"
    data = path.read_bytes()
    head = b"P6\n%d %d\n255\n" % (emulation.WIDTH, emulation.HEIGHT)
    if not data.startswith(head):
        raise Error(f"screendump gives {data[:20]} for a picture")
    data = data[len(head):]
    return rgb565(zip(data[0::3], data[1::3], data[2::3]))


def by_vnc(machine):
    """One whole picture (RFC 6143)."""
    link = links.connect(machine.folder, "vnc.sock")
    file = link.makefile("rb")

    def unpack(form):
        return struct.unpack(form, file.read(struct.calcsize(form)))

    file.read(12)
    link.sendall(b"RFB 003.008\n")
    file.read(*unpack("B"))
    link.sendall(b"\1")
    if unpack(">I") != (0,):
        raise Error("VNC wants a password")
    link.sendall(b"\1")
    width, height = unpack(">HH")
    file.read(16)
    file.read(*unpack(">I"))
    # 32 bits a pixel, blue in the first byte; pixels as they are.
    link.sendall(struct.pack(">B3xBBBBHHHBBB3x", 0, 32, 24, 0, 1, 255, 255, 255,
                             16, 8, 0) + struct.pack(">BxHi", 2, 1, 0)
                 + struct.pack(">BBHHHH", 3, 0, 0, 0, width, height))
    picture = bytearray(width * height * 4)
    left = width * height
    while left > 0:
        kind, rectangles = unpack(">BxH")
        if kind:
            raise Error(f"VNC sends the message {kind}")
        for _ in range(rectangles):
            x, y, across, down, _ = unpack(">HHHHi")
            for row in range(y, y + down):
                at = 4 * (row * width + x)
                picture[at:at + 4 * across] = file.read(4 * across)
            left -= across * down
    file.close()
    link.close()
    return rgb565(zip(picture[2::4], picture[1::4], picture[0::4]))


needs_pdk()
machine = booted(BY_HAND | guest_tool(), more=VNC)


ipu = machine.ipu


def sent():
    """The time, and the pictures sent until then: the board stands still while
    this looks, however busy this machine is."""
    machine.monitor.run("stop")
    now = machine.time_s(), ipu("frames")
    machine.monitor.run("cont")
    return now


wait_until(machine, lambda: machine.reports()[-1:] == [SHOWS], AWAKE_S)
check("no device has anything to complain of but a panel that waits for its "
      "driver", machine.reports()[-1:] == [SHOWS]
      and all(line.startswith(("no picture: the panel", SHOWS))
              for line in machine.reports()), machine.reports())

begun_s, begun = sent()
pause(machine, 2)
ended_s, ended = sent()
rate_hz = (ended - begun) / (ended_s - begun_s)
check(f"the panel gets {PANEL_HZ:.1f} pictures a second",
      abs(rate_hz - PANEL_HZ) < 1, rate_hz)

start_limber(machine, "--demo arm --script /dev/null --math fixed")
pause(machine, 1)
frame = machine.frame()
said = stop_limber(machine)
save(frame, "arm.png")
apart = difference(frame, host_picture(
    "--demo", "arm", "--math", "fixed", "--script", "/dev/null", "--time", "1"))
check("the picture on the panel is the host's, to the byte", apart == 0,
      f"{apart} pixels differ\n{said}")



def ipu_word(address, value=None):
    """Writes a word of the IPU's parameter memory, or reads it."""
    machine.wires.run(f"writel {IPU_MEMORY_ADDRESS:#x} {address:#x}")
    if value is not None:
        return machine.wires.run(f"writel {IPU_MEMORY_DATA:#x} {value:#x}")
    return int(machine.wires.run(f"readl {IPU_MEMORY_DATA:#x}"), 16)


def looks(name, expected):
    """Whether the panel, screendump and VNC show these bytes."""
    pause(machine, 0.1)
    seen = {"the panel": machine.frame(),
            "screendump": by_screendump(machine),
            "VNC": by_vnc(machine)}
    apart = {way: difference(expected, frame) for way, frame in seen.items()}
    check(f"{name} on the panel, in screendump and over VNC",
          not any(apart.values()), apart)
    save(seen["VNC"], "vnc.png")


def with_stride(stride):
    """What the IPU fetches from the page on the screen with this stride."""
    machine.monitor.run("pmemsave", val=ipu("picture0"), filename="page.raw",
                        size=stride * emulation.HEIGHT)
    page = (machine.folder / "page.raw").read_bytes()
    return b"".join(page[y * stride:y * stride + 2 * emulation.WIDTH]
                    for y in range(emulation.HEIGHT))


def swapped(frame):
    """Red for blue."""
    pixels = array.array("H", frame)
    return array.array("H", ((p & 31) << 11 | p & 0x7E0 | p >> 11
                             for p in pixels)).tobytes()


frame = machine.frame()
looks("the same picture is", frame)
stride, colors = ipu_word(STRIDE_WORD), ipu_word(COLORS_WORD)
# Bits 3 to 16 have the bytes of a line less one, bits 3 to 7 and 13 to 17 of the
# other word the places of red and blue in a pixel.
ipu_word(STRIDE_WORD, stride + (64 << 3))
looks("a stride of 64 bytes too many garbles the picture", with_stride(1024))
ipu_word(STRIDE_WORD, stride)
ipu_word(COLORS_WORD, colors & ~(31 << 3 | 31 << 13) | 11 << 3)
looks("the wrong order of colours shows red for blue", swapped(frame))
ipu_word(COLORS_WORD, colors)
looks("with the right ones the picture is back", frame)

# guest flip shows pictures of one colour, each on the page that is not sent.
machine.shell("echo 0 >/sys/class/vtconsole/vtcon1/bind")
torn = ipu("torn")
status, said = machine.shell(f"guest flip {FLIPS}", 60)
check(f"{FLIPS} flips in a row succeed", status == 0, said)
check("none of their pictures is torn", ipu("torn") == torn,
      f"{ipu('torn') - torn} are torn")
took_us = int(re.search(r"^(\d+) us$", said, re.M)[1])
spent_us = int(re.search(r"^(\d+) us of the processor$", said, re.M)[1])
check("each waits for the end of a frame",
      took_us >= (FLIPS - 1) * 1e6 / PANEL_HZ, said)
note(f"a flip takes {took_us / FLIPS:.0f} us, of which the processor works "
     f"{spent_us / FLIPS:.0f} us")

torn, begun = ipu("torn"), ipu("frames")
status, said = machine.shell(
    "limber play --demo walker --gl soft --clock fixed:25 --frames 60 "
    "--stats /run/stats >/dev/null; cat /run/stats", 300)
stats = json.loads(re.search(r"\{.*\}", said, re.S)[0])
check("the walker reaches 40 frames a second on the panel",
      stats["fps"] >= 40, stats)
check("no picture of it is torn after its first two",
      ipu("torn") - torn <= 2,
      f"{ipu('torn') - torn} of {ipu('frames') - begun} are torn")
note(f"walker on the panel: {stats['fps']:.1f} frames a second, "
     f"{stats['work_ms']['mean']:.1f} ms of work each")
done()
