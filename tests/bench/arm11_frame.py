"""What a frame of --gl soft goes to, stage by stage.

The timing model counts by symbol; the object file that a symbol is from tells
the stage. What lies in none is libc's clearing of memory.
"""

import pathlib
import subprocess
from dataclasses import dataclass

MHZ = 532
BOARD_INSTRUCTIONS_S = 250e6  # QEMU's -icount shift=2
SOFT = "platform/gl/soft/"
# Files of platform/gl/soft by stage, without their folders.
STAGES = {
    "transform and light": "array array_state cache context defaults draw_arrays key"
    " largest_float light matrix number parameter paths prepare prepare_light"
    " prepare_second prepare_spans shade state unindexed vertex vertices",
    "set-up": "begin begin_list bend clip count_runs counts fill_flat fill_glyph fill_narrow"
    " fill_small fill_texture hidden layout line list set_up triangle triangles walk walk_list",
    "pixels": "band beside blend_row combine_rows coverage cut fill loops"
    " luminance made mix narrow_rows rows samplers spans_565 spans_8888"
    " spans_joined spans_second tests texture tile_row thin_line tiles tint"
    " untested",
    "clear": "clear",
}
ORDER = ("animate", *STAGES, "present")


@dataclass
class Share:
    instructions: int = 0
    cycles: int = 0

    def add(self, counts):
        self.instructions += counts["instructions"]
        self.cycles += counts["cycles"]

    def ms(self):
        return self.cycles / MHZ / 1e3


def places(folder):
    """symbol -> file under build/arm/obj/FOLDER it is from, without its ending."""
    found = {}
    root = pathlib.Path("build/arm/obj", folder)
    for path in sorted(root.rglob("*.o")):
        listing = subprocess.run(
            ["arm-linux-gnueabi-nm", path], capture_output=True, text=True, check=True
        ).stdout
        for line in listing.splitlines():
            if (words := line.split())[-2] in "tT":
                found.setdefault(words[-1], str(path.relative_to(root).with_suffix("")))
    return found


def stage_of(place):
    """place: a file under build/arm/obj, or None."""
    if place is None:
        return "clear"
    if place.startswith("platform/display/"):
        return "present"
    if not place.startswith(SOFT):
        return "animate"
    name = place.split("/")[-1]
    for stage, names in STAGES.items():
        if name in names.split():
            return stage
    raise RuntimeError(f"STAGES in tests/bench/arm11_frame.py lacks {place}.c")


def check_stages():
    """Raises an error if a file of the driver has no stage. Measuring takes minutes."""
    for path in pathlib.Path(SOFT).rglob("*.[cS]"):
        stage_of(str(path.with_suffix("")))


def split(report):
    """stage -> Share of the model's report of one frame, in ORDER."""
    where = {
        **places(""),
        **{symbol: SOFT + name for symbol, name in places(SOFT).items()},
    }
    shares = {stage: Share() for stage in ORDER}
    for symbol in report["symbols"]:
        place = where.get(symbol["name"])
        shares[stage_of(place)].add(symbol)
    return shares


def print_split(report, out):
    shares = split(report)
    total = Share()
    print(f"    {'of them':22} {'instr.':>7} {'cycles':>7} {'ms':>6}", file=out)
    for stage, share in shares.items():
        total.add(vars(share))
        print(
            f"    {stage:22} {share.instructions / 1e6:7.2f} "
            f"{share.cycles / 1e6:7.2f} {share.ms():6.2f}",
            file=out,
        )
    print(
        f"    {total.ms():.1f} ms at {MHZ} MHz: {1e3 / total.ms():.0f} frames a second; "
        f"{BOARD_INSTRUCTIONS_S / total.instructions:.0f} at "
        f"{BOARD_INSTRUCTIONS_S / 1e6:.0f} million instructions a second",
        file=out,
    )


def split_as_json(report):
    return {stage: vars(share) for stage, share in split(report).items()}
