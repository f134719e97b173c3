"""Character files played on the board by its GPIO buttons: each button changes
the picture, and the host, with the same presses, shows the same bytes. GPIO
outputs follow the events of the file, which limber also prints."""
import re
import subprocess

from harness import (BY_HAND, FOLDER, HOST, MODELS, TOP, booted, check,
                     difference, done, frame_of_png, is_drawn, links, note, pause,
                     save, wait_until)

CHARACTERS = TOP / "assets/characters"
RUNS = (("CesiumMan", "UP ENTER RIGHT F6"),
        ("RiggedFigure", "DOWN ENTER LEFT RIGHT"),
        ("AnimatedMorphCube", "UP DOWN F6 RIGHT"))
HOLD_S, APART_S, LAST_S = 0.12, 0.25, 0.8
CLOCK_HZ = 25

# Two lights, one for each foot, on the lines of buttons that are not used here.
LIGHTS = {"left": 24, "right": 25}
STEPS = """include = CesiumMan.character

[output left]
line = 53fd0000.gpio/24

[output right]
line = 53fd0000.gpio/25

[clip 0]
event = 0.4 output left 120
event = 1.4 output right 120

[trigger fast]
when = speed > 1.2
then = line "faster than 1.2"
"""


def wires(buttons):
    return "gpiod:" + ",".join(
        f"{name}=53fd0000.gpio/{links.BUTTONS[name]}"
        for name in buttons.split())


def play(model):
    return ["play", f"{model}.glb", "--clock", f"fixed:{CLOCK_HZ}",
            "--math", "fixed", "--gl", "soft"]


def on_board(machine, model, buttons):
    """Plays the model, presses each button once and ends it. Returns the last
    picture on each page, limber's lines, its record of the presses, and the
    number of its frames."""
    machine.clear()
    machine.mark()
    begun = machine.seen
    machine.shell(f"cd /models; limber {' '.join(play(model))} "
                  f"--buttons {wires(buttons)} --record-buttons /run/record "
                  "--stats /run/stats 2>/run/said & limber=$!")
    wait_until(machine, lambda: is_drawn(machine.frame()), 10)
    for button in buttons.split():
        for down in (True, False):
            machine.wires.level(button, down)
            pause(machine, HOLD_S if down else APART_S)
    pause(machine, LAST_S)
    machine.shell("kill $limber; wait $limber; cat /run/said")
    # Any command reads what the outputs did until now.
    machine.wires.level(buttons.split()[0], False)
    pages, said = machine.pages(), machine.log()[begun:]
    stats = machine.shell("cat /run/stats")[1]
    return (pages, said, machine.shell("cat /run/record")[1],
            int(re.search(r'"frames": (\d+)', stats)[1]))


def on_host(model, script, frames, *shown):
    """The last of the frames with these presses, and limber's lines."""
    folder = FOLDER / "models"
    for old in folder.glob("*.png"):
        old.unlink()
    (folder / "press.txt").write_text(script)
    run = subprocess.run(
        [HOST, *play(model), "--script", "press.txt", "--display", "image",
         "--format", "rgb565", "-o", "shown.png", "--frames", str(frames),
         *shown], cwd=folder, check=True, stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL, text=True)
    return (frame_of_png(max(folder.glob("shown*.png")).read_bytes()),
            run.stdout)


def steps_of(said):
    return re.findall(r"^(left|right) foot$", said, re.M)


files = {f"models/{name}": data for name, data in (
    *((f"{model}.glb", MODELS / f"{model}.glb") for model, _ in RUNS),
    ("RiggedFigure.character", CHARACTERS / "RiggedFigure.character"),
    ("biped.character", CHARACTERS / "biped.character"),
    ("AnimatedMorphCube.character", CHARACTERS / "AnimatedMorphCube.character"),
    ("walk.character", CHARACTERS / "CesiumMan.character"),
    ("CesiumMan.character", STEPS.replace("CesiumMan.", "walk.")))}
for name, data in files.items():
    path = FOLDER / name
    path.parent.mkdir(parents=True, exist_ok=True)
    if isinstance(data, str):
        path.write_text(data)
    else:
        path.write_bytes(data.read_bytes())
machine = booted(BY_HAND | files)
# Otherwise the console draws on the screen when limber ends.
machine.shell("echo 0 >/sys/class/vtconsole/vtcon1/bind")
machine.wires.watch()

for model, buttons in RUNS:
    machine.wires.changes.clear()
    pages, said, record, frames = on_board(machine, model, buttons)
    lines = re.findall(r"^\d+ \w+ (?:down|up)$", record, re.M)
    script = "\n".join(lines) + "\n"
    (FOLDER / f"{model}.buttons").write_text(script)
    pressed = [line.split()[1] for line in lines if line.endswith("down")]
    check(f"{model}: limber hears each button", pressed == buttons.split(),
          f"{script}{said}")
    wanted, host_said = on_host(model, script, frames)
    apart, frame = min((difference(page, wanted), page) for page in pages)
    save(frame, f"{model}.png")
    note(f"{model}: {frames} frames")
    if not check(f"{model}: its picture is the host's", apart == 0,
                 f"{apart} pixels differ\n{script}{said}"):
        save(wanted, f"{model}-host.png")
    for button in pressed:
        without = "".join(f"{line}\n" for line in lines
                          if line.split()[1] != button)
        check(f"{model}: {button} changes it",
              difference(on_host(model, without, 1, "--time",
                                 str((frames - 1) / CLOCK_HZ))[0], frame) > 100)
    if model == "CesiumMan":
        steps = steps_of(said)
        raised = [name for line, high in machine.wires.changes
                  for name, at in LIGHTS.items() if line == at and high]
        check("a light goes on at each footstep, in limber's order",
              len(steps) > 2 and raised == steps,
              f"{machine.wires.changes}\n{said}")
        check("and off after it", [high for _, high in machine.wires.changes]
              == [True, False] * len(steps), machine.wires.changes)
        check("the steps are the host's", steps == steps_of(host_said), said)
        check("UP has set the speed", "faster than 1.2" in said, said)
done()
