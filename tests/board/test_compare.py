"""limber compare gives the same figures on the board as on the host."""
import json
import re
import subprocess

from harness import BY_HAND, HOST, MODELS, booted, check, done

# Where an instruction of the board takes several of this machine, a small model goes
# the same ways as a large one.
QUESTION = ("compare", "--clip", "0", "--error", "2", "--format", "json",
            "--kernel", "float", "--size", "160x96", "RiggedFigure.glb")


def by_name(report):
    return {row["name"]: row for row in report["candidates"] if row["listed"]}


machine = booted(BY_HAND | {QUESTION[-1]: MODELS / QUESTION[-1]})
status, _ = machine.shell(f"cd /; limber {' '.join(QUESTION)} >/run/report", 300)
check("it runs", status == 0)
said = machine.shell("cat /run/report")[1]
board = by_name(json.loads(re.search(r"\{.*\}", said, re.S)[0]))
host = by_name(json.loads(subprocess.run(
    [HOST, *QUESTION], cwd=MODELS, check=True, stdout=subprocess.PIPE,
    text=True).stdout))
check("it has the same candidates", board.keys() == host.keys(),
      f"{board.keys()} {host.keys()}")
for name, row in host.items():
    there = board.get(name, {})
    check(f"{name}: the same bytes",
          all(there.get(key) == row[key] for key in ("file_bytes", "vertices")),
          there)
    check(f"{name}: off by as many pixels, {row['peak_px']:.3f}",
          abs(there.get("peak_px", 1e9) - row["peak_px"]) < 0.001, there)
    there_us = there.get("arm11_predicted", {}).get("us_per_frame", 0)
    told_us = row["arm11_predicted"]["us_per_frame"]
    check(f"{name}: predicted as {told_us:.0f} us, within 0.1%",
          abs(there_us - told_us) < 0.001 * told_us, there)
    check(f"{name}: a frame takes {there.get('us_per_frame', 0):.0f} us there",
          there.get("us_per_frame", 0) > 0, there)
done()
