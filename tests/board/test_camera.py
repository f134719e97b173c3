"""A real V4L2 device, the kernel's vivid: its colour bars appear as background
and as texture, and limber continues when the device disappears."""
import array
import colorsys

from harness import (BY_HAND, booted, check, done, guest_tool, note, pause,
                     save, start_limber, stop_limber, wait_until)

DRIVER = "/sys/bus/platform/drivers/vivid"
# vivid's controls: no text over the bars; disconnected until it is closed.
TEXT_MODE, NO_TEXT = "0x00f0f001", 2
DISCONNECT = "0x00f0f041"
HUES = ("red", "yellow", "green", "cyan", "blue", "magenta")


def bars(frame, least=0.002):
    """The saturated colours that fill at least that fraction of the picture."""
    pixels = array.array("H", frame)
    seen = dict.fromkeys(HUES, 0)
    colours = {}
    for pixel in pixels[::7]:
        colours[pixel] = colours.get(pixel, 0) + 1
    for pixel, count in colours.items():
        hue, full, bright = colorsys.rgb_to_hsv(
            (pixel >> 11) / 31, (pixel >> 5 & 63) / 63, (pixel & 31) / 31)
        if full > 0.7 and bright > 0.5 and abs(hue * 6 % 1 - 0.5) > 0.3:
            seen[HUES[round(hue * 6) % 6]] += count
    return [name for name in HUES if seen[name] > least * len(pixels) / 7]


def plug_in(machine, command):
    return machine.shell(f"{command} && while ! guest control /dev/video0 "
                         f"{TEXT_MODE} {NO_TEXT}; do usleep 100000; done")


def wait_for_bars(machine, wanted, seconds=10):
    return wait_until(machine, lambda: (len(bars(machine.frame())) >= 4)
                      == wanted, seconds, 0.1)


ARGUMENTS = "--demo walker --no-labels --camera /dev/video0,320x240"

machine = booted(BY_HAND | guest_tool(), drivers=True)
start_limber(machine, f"{ARGUMENTS} --camera-use background")
pause(machine, 3)
frame = machine.frame()
save(frame, "none.png")
check("without a camera its place is empty", len(bars(frame)) < 3, bars(frame))
plug_in(machine, "modprobe vivid n_devs=1")
check("a camera that is plugged in later is the background",
      wait_for_bars(machine, True, 15) is not None, bars(machine.frame()))
save(machine.frame(), "background.png")

machine.shell(f"echo vivid.0 >{DRIVER}/unbind")
check("a camera that is pulled out leaves the picture",
      wait_for_bars(machine, False, 15) is not None, bars(machine.frame()))
save(machine.frame(), "gone.png")
plug_in(machine, f"echo vivid.0 >{DRIVER}/bind")
check("and is back when it is plugged in again",
      wait_for_bars(machine, True, 15) is not None, bars(machine.frame()))
status, said = machine.shell(f"guest control /dev/video0 {DISCONNECT} 1")
check("vivid takes the control that disconnects it", status == 0, said)
pause(machine, 6)
check("after a disconnection of a moment it is back, too",
      wait_for_bars(machine, True, 15) is not None, bars(machine.frame()))
said = stop_limber(machine)
about = [line for line in said.splitlines() if "/dev/video0" in line]
check("each time is said in a sentence",
      len(about) == 3 and "no such device" in about[0] and
      all("unplugged" in line for line in about[1:]), said)
for line in about:
    note(line)

start_limber(machine, f"{ARGUMENTS} --camera-use screen")
check("it is the texture of a screen in the scene",
      wait_for_bars(machine, True, 15) is not None, bars(machine.frame()))
pause(machine, 1)
save(machine.frame(), "screen.png")
stop_limber(machine)
done()
