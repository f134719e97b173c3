"""The frame rate of each demo on the board, without waiting for the panel: the
machine kzm has a framebuffer that does not flip (test_ipu.py flips)."""
from harness import BY_HAND, booted, check, done, frames_of, note

# The walker's rate is the project's goal. Those of the others are below what
# the board reaches, to leave some time for larger scenes.
WANTED_FPS = {"walker": 30, "arm": 22, "face": 22}
FRAMES = 60
MEMORY_MIB = 24

machine = booted(BY_HAND, kind="kzm")
for demo, wanted_fps in WANTED_FPS.items():
    run = frames_of(machine, demo, FRAMES)
    check(f"{demo}: at least {wanted_fps} frames a second",
          run["fps"] >= wanted_fps, run)
    check(f"{demo}: at most {MEMORY_MIB} MB", run["memory_mib"] <= MEMORY_MIB,
          run)
    note(f"{demo}: {run['fps']:.1f} frames a second, "
         f"{run['work_ms']['mean']:.1f} ms a frame, {run['memory_mib']} MiB")
done()
