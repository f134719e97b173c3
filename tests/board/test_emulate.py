"""The command line of the emulated board, board/imx31-pdk/emulate."""
import subprocess
import time

from harness import FOLDER, IMAGE, TOP, check, done, frame_of_png, is_drawn

TOOL = TOP / "board/imx31-pdk/emulate"
STATE = FOLDER / "state"
FOLDER.mkdir(parents=True, exist_ok=True)


def emulate(*words):
    run = subprocess.run([TOOL, "--image", IMAGE, "--state", STATE, *words],
                         stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                         stderr=subprocess.PIPE, text=True, timeout=120)
    return run.returncode, run.stdout + run.stderr


def shot(name):
    path = FOLDER / name
    status, said = emulate("shot", str(path))
    return frame_of_png(path.read_bytes()) if status == 0 else b""


def shot_until(name, condition):
    """Takes pictures until one meets the condition, for half a minute."""
    for _ in range(60):
        frame = shot(name)
        if frame and condition(frame):
            return frame
        time.sleep(0.5)
    return b""


status, said = emulate("shot", "nothing.png")
check("before the start it says what to do", status == 1 and
      said.startswith("limber: ") and "start it first" in said, said)
status, said = emulate("--camera", "start")
check("start", status == 0, said)
try:
    status, said = emulate("start")
    check("one at a time in a folder", status == 1 and "already" in said, said)
    check("shot writes a picture", shot_until("first.png", is_drawn) != b"")
    status, said = emulate("press", "F6", "200")
    check("press", status == 0, said)
    status, said = emulate("press", "F7")
    check("press of no button is wrong usage", status == 2, said)
    status, said = emulate("shell", "cat", "/etc/limber.conf")
    check("shell shows what a command says", status == 0 and
          "53fd0000.gpio" in said, said)
    check("and ends like it", emulate("shell", "(exit 3)")[0] == 3)
    status, said = emulate("camera", "off")
    check("camera off", status == 0 and
          emulate("shell", "ls /dev/video0")[0] != 0, said)
    status, said = emulate("camera", "on")
    check("camera on", status == 0 and
          emulate("shell", "ls /dev/video0")[0] == 0, said)
    status, said = emulate("time")
    check("time", status == 0 and float(said) > 0, said)
    status, said = emulate("log")
    check("log", status == 0 and "Booting Linux" in said, said)
finally:
    status, said = emulate("stop")
check("stop", status == 0 and emulate("time")[0] == 1, said)
done()
