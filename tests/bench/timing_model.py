"""Runs play_cost.c on the timing model (tests/arm1136)."""
import subprocess


def run_play_cost(tools, *arguments):
    """What play_cost prints for these arguments, and its regions by number: of
    each the figures by name. TOOLS are the program, the plugin and the sysroot.

    It gets an empty environment. Its environment lies at the top of its stack, so
    other variables would move the stack and change which lines share a place in
    the caches: up to 1% of the cycles of a small picture.
    """
    program, model_so, sysroot = tools
    run = subprocess.run(
        ["qemu-arm", "-cpu", "arm1136", "-L", sysroot, "-plugin", model_so,
         program, *map(str, arguments)],
        check=True, capture_output=True, text=True, env={})
    regions = {}
    for line in run.stderr.splitlines():
        words = line.split()
        if words[:1] == ["region"]:
            figures = words[2:]
            regions[int(words[1].split("#")[1])] = dict(
                zip(figures[::2], map(int, figures[1::2])))
    return run.stdout, regions
