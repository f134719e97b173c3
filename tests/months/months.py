#!/usr/bin/env python3
"""months.py LIBRARY COMMAND...: lets limber, COMMAND, play for a month, and prints
TAP. LIBRARY is months.so, which leaves out what lies between the first second of
an hour and the next hour. In each second buttons are pressed at random; each hour
the model's file is replaced, by another model, by a broken file or by none.

The memory, the descriptors and the processor time of an hour must be in the last
quarter of the month what they were in the second one. The time is counted in
yardsticks, a piece of work that the library does after each frame. The environment may set
DAYS (30), SEED, and PRELOAD, the option with which COMMAND's emulator preloads.
"""
import math
import os
import pathlib
import random
import shutil
import statistics
import subprocess
import sys
import tempfile

TOP = pathlib.Path(__file__).resolve().parents[2]
DAYS = float(os.environ.get("DAYS", 30))
# The same buttons and files come again in each eighth of the month. A button that
# leads through two or four states has then led through the same ones in the second
# quarter and in the last.
PERIOD = math.ceil(3 * DAYS)
HOURS = 8 * PERIOD
SEED = int(os.environ.get("SEED", 1))
# Of each hour. The viewer takes a file that has not changed for a second.
FRAMES = 80
BUTTONS = "UP DOWN LEFT RIGHT ENTER F6 F8 F10".split()
# Not F9: with F8 it saves pictures, and F6 with it shows the technique, which
# takes longer the more techniques are shown.
MODELS = ("walker.glb", "arm.glb", "face.glb")
MEMORY_SLACK = 1.02
TIME_SLACK = 1.5
RUNS = {
    "a model that changes": ["MODEL"],
    "the walker": ["--demo", "walker", "--camera", "pattern",
                   "--camera-use", "screen"],
    "the face": ["--demo", "face"],
}

tests = 0
failures = 0


def check(name, good, said=""):
    global tests, failures
    tests += 1
    failures += not good
    print(f"{'ok' if good else 'not ok'} {tests} - {name}", flush=True)
    if not good:
        print("\n".join(f"# {line}" for line in str(said).splitlines()))


def script():
    """Three presses in the first second of each hour."""
    lines = []
    for hour in range(HOURS):
        chance = random.Random(f"{SEED} press {hour % PERIOD}")
        for part in range(3):
            begin = hour * 3600000 + 300 * part + chance.randrange(20, 100)
            button = chance.choice(BUTTONS)
            lines.append(f"{begin} {button} down")
            lines.append(f"{begin + chance.randrange(40, 180)} {button} up")
    return "\n".join(lines) + "\n"


def replace(path, hour):
    """Puts another file there, as an editor does."""
    chance = random.Random(f"{SEED} replace {hour % PERIOD}")
    new = path.with_suffix(".new")
    kind = chance.randrange(8)
    if kind == 0:
        path.unlink(missing_ok=True)
        return
    shutil.copyfile(TOP / "assets" / MODELS[hour % PERIOD % len(MODELS)], new)
    if kind == 1:
        os.truncate(new, chance.randrange(1, new.stat().st_size))
    new.rename(path)


def play(library, command, options, folder):
    """What limber said of each hour, its exit status and its messages."""
    model = folder / "model.glb"
    shutil.copyfile(TOP / "assets/walker.glb", model)
    (folder / "script").write_text(script())
    told, tell = os.pipe()
    answered, answer = os.pipe()
    environment = {**os.environ, "MONTHS_OUT": str(tell), "MONTHS_IN":
                   str(answered), "MONTHS_FRAMES": str(FRAMES),
                   "MONTHS_HOURS": str(HOURS), "LIMBER_CONFIG": "none"}
    preload = os.environ.get("PRELOAD", "").split()
    if preload:
        command = [command[0], *preload, *command[1:]]
    else:
        environment["LD_PRELOAD"] = str(library)
    options = [str(model) if option == "MODEL" else option
               for option in options]
    with open(folder / "said", "w+") as said:
        limber = subprocess.Popen(
            [*command, "play", *options, "--display", "null", "--gl", "soft",
             "--size", "96x128", "--script", str(folder / "script"),
             "--stats", str(folder / "stats")],
            stdin=subprocess.DEVNULL, stdout=said, stderr=said,
            env=environment, pass_fds=(tell, answered))
        os.close(tell)
        os.close(answered)
        hours = []
        with open(told) as lines:
            for hour, line in enumerate(lines):
                hours.append([int(word) for word in line.split()])
                if str(model) in options:
                    replace(model, hour)
                os.write(answer, b"\n")
        os.close(answer)
        status = limber.wait()
        said.seek(0)
        return hours, status, said.read()


def quarters(values):
    """The second quarter, when all is warm, and the last one."""
    quarter = len(values) // 4
    return values[quarter:2 * quarter], values[-quarter:]


def judge(name, hours, status, said):
    check(f"{name}: plays for {DAYS:g} days", status == 0 and
          len(hours) == HOURS, f"status {status}, {len(hours)} hours\n{said}")
    if len(hours) < 8:
        return
    early, late = quarters([hour[0] for hour in hours])
    check(f"{name}: memory stays flat",
          max(late) <= max(early) * MEMORY_SLACK, f"{early}\n{late}")
    print(f"# {min(early)} to {max(early)} bytes in the second quarter, "
          f"{min(late)} to {max(late)} in the last")
    early, late = quarters([hour[1] for hour in hours])
    check(f"{name}: the descriptors stay", max(late) <= max(early),
          f"{early}\n{late}")
    costs = [(after[2] - before[2]) / (after[3] - before[3])
             for before, after in zip(hours, hours[1:])]
    early, late = quarters(costs)
    listed = [" ".join(f"{cost:.2f}" for cost in part)
              for part in (early, late)]
    # Some buttons make an hour dearer.
    early, late = statistics.median(early), statistics.median(late)
    check(f"{name}: a frame costs what it did", late <= early * TIME_SLACK,
          "yardsticks a frame: {}, then {}".format(*listed))
    print(f"# {early:.2f} yardsticks a frame, then {late:.2f}")


def main():
    library, *command = sys.argv[1:]
    for name, options in RUNS.items():
        with tempfile.TemporaryDirectory(prefix="limber-months-") as folder:
            judge(name, *play(pathlib.Path(library).resolve(), command, options,
                              pathlib.Path(folder)))
    print(f"1..{tests}")
    sys.exit(failures > 0)


if __name__ == "__main__":
    main()
