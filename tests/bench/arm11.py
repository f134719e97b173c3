#!/usr/bin/env python3
"""make bench-arm11: measures loops, poses and frames on the timing model.

    arm11.py [OPTIONS]                 the table
    arm11.py --check FILE [OPTIONS]    TAP: nothing worse, or far better, than FILE records
    arm11.py --record FILE [OPTIONS]   writes FILE

ROWS lists what is measured. Every figure comes from the model in tests/arm1136:
no hardware was measured.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import threading
from dataclasses import dataclass, field

from arm11_frame import check_stages, places, print_split, split_as_json
from arm11_rows import ROWS, Row

# The model's options for each column. In "warm" every access hits L1; in the
# others the pass that counts begins with all data in memory.
MEMORIES = {
    "warm": "ideal=on",
    "cold": "",
    "cold low": "l2=8,ddr=50",
    "cold high": "l2=16,ddr=110",
}
WORSE = 1.05
# A figure this far below the recorded one is recorded anew, or the loop has
# stopped doing its work.
BETTER = 0.8
MODEL_NOTE = (
    "An ARM1136JF-S at 532 MHz by the timing model of tests/arm1136: "
    "no hardware was measured."
)


@dataclass
class Figures:
    """What one kernel takes for one row, for each vertex, joint or frame."""

    row: Row
    kernel: str
    per: int = 0
    cycles: dict = field(default_factory=dict)
    instructions: float = 0.0
    report: dict = None  # the model's, of cold

    def number(self, name):
        return self.instructions if name == "instructions" else self.cycles.get(name)


class Bench:
    """Runs programs under qemu-arm with the model."""

    def __init__(self, options):
        self.options = options
        self.scratch = tempfile.TemporaryDirectory(prefix="limber-bench-")
        self.copying = threading.Lock()

    def plugin(self, number, memory, report):
        """The argument for the model with this memory. A process loads a file
        once, so each memory has a copy of its own."""
        copy = pathlib.Path(self.scratch.name, f"model-{number}.so")
        with self.copying:
            if not copy.exists():
                shutil.copy(self.options.model, copy)
        words = [str(copy), f"json={report}", MEMORIES[memory], self.options.model_options]
        return ["-plugin", ",".join(filter(None, words))]

    def run(self, row, kernel):
        """The program's count and the model's report for each memory, or None
        when the kernel has no such loop. One process serves all memories."""
        reports = {}
        plugins = []
        for number, memory in enumerate(row.short if self.options.short else row.full):
            name = f"{row.name}-{kernel}-{memory}.json".replace(" ", "-")
            reports[memory] = pathlib.Path(self.scratch.name, name)
            plugins += self.plugin(number, memory, reports[memory])
        result = subprocess.run(
            ["qemu-arm", "-cpu", "arm1136", "-L", self.options.sysroot, *plugins,
             *row.command(self.options, kernel)],
            capture_output=True, text=True, check=False,
            env={"LC_ALL": "C"},  # the same everywhere, as in play_check.py
        )  # fmt: skip
        if result.returncode == 3:
            return None
        if result.returncode or not all(r.exists() for r in reports.values()):
            raise RuntimeError(f"{row.name}, {kernel}: {result.stderr.strip()}")
        count = re.search(r"^(?:count|joints) (\d+)", result.stdout, re.M)
        return int(count[1]) if count else 1, {
            memory: json.loads(report.read_text()) for memory, report in reports.items()
        }

    def figures(self, row, kernel):
        answer = self.run(row, kernel)
        if not answer:
            return None
        figures = Figures(row, kernel, answer[0])
        per = figures.per * row.scale
        for memory, figures.report in answer[1].items():
            counts = [counts_of(figures.report, number) for number in row.region(memory)]
            figures.cycles[memory] = sum(c["cycles"] / c["entries"] for c in counts) / per
            figures.instructions = (
                sum(c["instructions"] / c["entries"] for c in counts) / per
            )
        return figures

    def osmesa(self, row):
        """Counts the instructions of a frame that the osmesa driver draws."""
        command = row.command(self.options, "osmesa")
        counts = []
        for frames in ("1", "3"):
            result = subprocess.run(
                [
                    "qemu-arm", "-cpu", "arm1136", "-L", self.options.sysroot,
                    "-plugin", self.options.counter, "-d", "plugin",
                    *command[:-2], frames, "osmesa",
                ],
                capture_output=True, text=True, check=False,
                env={**os.environ, "LP_NUM_THREADS": "0"},
            )  # fmt: skip
            found = re.search(r"^instructions: (\d+)", result.stderr, re.M)
            if result.returncode or not found:
                raise RuntimeError(f"{row.name}, osmesa: {result.stderr.strip()}")
            counts.append(int(found[1]))
        figures = Figures(row, "osmesa")
        figures.instructions = (counts[1] - counts[0]) / 2 / row.scale
        return figures

    def all(self):
        jobs = []
        for row in wanted_rows(self.options):
            if row.missing(self.options):
                continue
            if row.stages:
                check_stages()
            kernels = wanted_kernels(row, self.options)
            jobs += [lambda row=row, kernel=k: self.figures(row, kernel) for k in kernels]
            if row.osmesa and self.options.osmesa and kernels:
                jobs.append(lambda row=row: self.osmesa(row))
        with concurrent.futures.ThreadPoolExecutor(self.options.jobs) as pool:
            results = pool.map(lambda job: job(), jobs)
            return [figures for figures in results if figures]


def wanted_rows(options):
    return [r for r in ROWS if not options.rows or r.name in options.rows]


def wanted_kernels(row, options):
    return [k for k in row.kernels if not options.kernel or k in options.kernel]


def counts_of(report, number):
    suffix = f"#{number}"
    return next(r["counts"] for r in report["regions"] if r["name"].endswith(suffix))


def cycles_by_file(figures):
    """The region's cycles by chapter, largest first, as text."""
    where = places(figures.row.chapters)
    sums = {}
    for symbol in figures.report["symbols"]:
        chapter = where.get(symbol["name"], "the rest")
        sums[chapter] = sums.get(chapter, 0) + symbol["cycles"]
    total = sum(sums.values())
    largest = sorted(sums.items(), key=lambda item: -item[1])
    return [f"{name} {cycles / total:.0%}" for name, cycles in largest[:6]]


def ratios(all_figures):
    """(row, kernel, column) -> how many times as fast as an4044."""
    base = {f.row.name: f for f in all_figures if f.kernel == "an4044"}
    return {
        (f.row.name, f.kernel, column): base[f.row.name].cycles[column] / cycles
        for f in all_figures
        if f.row.name in base
        for column, cycles in f.cycles.items()
        if cycles
    }


def number(value, width, digits=1):
    return f"{value:{width}.{digits}f}" if value is not None else " " * width


def aims(figures, ratio):
    """The limits of the row, and whether they are met, as text."""
    row, kernel = figures.row, figures.kernel
    if not row.is_best(kernel):
        return ""
    texts = []
    for figure, limit in (row.limit or {}).items():
        met = round(figures.number(figure), 1) <= limit
        texts.append(f"{limit:g}" + ("" if met else " not yet"))
    for figure, limit in (row.times or {}).items():
        times = ratio.get((row.name, kernel, figure))
        if times:
            texts.append(f"{limit:g}x" + ("" if times >= limit else " not yet"))
    return ", ".join(texts)


def print_table(all_figures, out):
    ratio = ratios(all_figures)
    unit = None
    print(MODEL_NOTE, file=out)
    for f in all_figures:
        if f.row.unit != unit:
            unit = f.row.unit
            print(
                f"\n{'cycles a ' + unit:38} {'warm':>9} {'cold':>9} "
                f"{'(sweep)':^17} {'instr.':>9} {'warm':>6} {'cold':>6} {'bound':>6}  aim",
                file=out,
            )
        first = f.kernel == f.row.kernels[0]
        low, high = f.cycles.get("cold low"), f.cycles.get("cold high")
        cold = f.cycles.get("cold")
        sweep = f"({low:.1f} - {high:.1f})" if low else ""
        times = [
            f"{ratio[key]:5.2f}x" if (key := (f.row.name, f.kernel, c)) in ratio else ""
            for c in ("warm", "cold")
        ]
        bound = number(f.row.bound, 6, 0) if f.row.is_best(f.kernel) else " " * 6
        print(
            f"{f.row.title if first else '':31} {f.kernel:6} "
            f"{number(f.cycles.get('warm'), 9)} {number(cold, 9)} "
            f"{sweep:^17} {number(f.instructions, 9)} {times[0]:>6} {times[1]:>6} {bound}"
            f"  {aims(f, ratio)}".rstrip(),
            file=out,
        )
        if f.row.chapters and f.report:
            print(f"    {', '.join(cycles_by_file(f))}", file=out)
        if f.row.stages and f.report:
            print_split(f.report, out)
    print(NOTES, file=out)


NOTES = """
warm   every access hits L1.
cold   data is in memory and code in L1; L2 takes 10, DDR 80 cycles more than L1.
       The sweep goes from L2 8, DDR 50 to L2 16, DDR 110. Poses and frames find
       the caches as the previous ones left them.
x      how many times as fast as an4044 in the same run. an4044 is AN4044's own
       float loop and layout; its normals are not unit length, float's are.
bound  the core's limits on MACs and loads, for the best loop (a search).
aim    at most so many cycles (loops, warm) or instructions (poses, frames), or
       at least so many times as fast as an4044.
Loops over made meshes are the loops alone, with 1024 vertices, 24 joints and 24
sets of joints unless stated (CesiumMan has 54 sets, the walker 63). A model's
mesh includes the work of once a frame; "all that moves" is everything from pose
to drawing. A pose is sampling, world matrices and palette. Frames are 480x640,
RGB565; the files of platform/gl/soft with most cycles are listed below them (the
rest is libc's memset and the program). A demo's frame is drawn into the
framebuffer and not copied. osmesa is Debian's armel build: its instructions are
counted, and it computes floats in software."""


def as_json(all_figures):
    ratio = ratios(all_figures)
    return {
        "note": MODEL_NOTE,
        "memories": MEMORIES,
        "rows": [
            {
                "name": f.row.name,
                "title": f.row.title,
                "kernel": f.kernel,
                "unit": f.row.unit,
                "count": f.per,
                "cycles": {k: round(v, 2) for k, v in f.cycles.items()},
                "instructions": round(f.instructions, 2),
                "times_an4044": {
                    column: round(ratio[key], 2)
                    for column in f.cycles
                    if (key := (f.row.name, f.kernel, column)) in ratio
                },
                "bound": f.row.bound,
                "aim": aims(f, ratio),
                "shares": cycles_by_file(f) if f.row.chapters and f.report else [],
                "stages": split_as_json(f.report) if f.row.stages and f.report else {},
            }
            for f in all_figures
        ],
    }


RECORDED = ("warm", "cold", "instructions")


def read_figures(path):
    """(row, kernel, figure) -> value"""
    recorded = {}
    for line in pathlib.Path(path).read_text().splitlines():
        if line.strip() and not line.startswith("#"):
            row, kernel, figure, value = line.split()
            recorded[row, kernel, figure] = float(value)
    return recorded


def write_figures(path, all_figures):
    with open(path, "w", encoding="ascii") as out:
        print(f"# {MODEL_NOTE}", file=out)
        print("# ROW KERNEL FIGURE VALUE; make bench-arm11-record renews it.", file=out)
        for f in all_figures:
            for name in RECORDED:
                if f.number(name) is not None:
                    value = f"{f.number(name):.2f}"
                    print(f.row.name, f.kernel, name, value, file=out)


class Tap:
    def __init__(self):
        self.count = 0
        self.failed = 0

    def check(self, good, name):
        self.count += 1
        self.failed += not good
        print(f"{'ok' if good else 'not ok'} {self.count} - {name}")

    def skip(self, name, why):
        self.count += 1
        print(f"ok {self.count} - {name} # SKIP {why}")

    def done(self):
        print(f"1..{self.count}")
        return 1 if self.failed else 0


def check_limits(tap, all_figures, recorded):
    """A limit that was reached once must stay reached."""
    ratio = ratios(all_figures)
    was = {}
    for (row, kernel, figure), value in recorded.items():
        if kernel != "an4044" and (base := recorded.get((row, "an4044", figure))):
            was[row, kernel, figure] = base / value
    for f in all_figures:
        if not f.row.is_best(f.kernel):
            continue
        for figure, limit in (f.row.limit or {}).items():
            value = round(f.number(figure), 1)
            before = recorded.get((f.row.name, f.kernel, figure), 1e9)
            reached = round(before, 1) <= limit
            tap.check(
                value <= limit or not reached,
                f"{f.row.name} {f.kernel} {figure}: {value:.1f} of at most {limit}"
                + ("" if value <= limit else ", reached before" if reached else ", not yet"),
            )
        for figure, limit in (f.row.times or {}).items():
            key = (f.row.name, f.kernel, figure)
            if key not in ratio:
                continue
            reached = was.get(key, 0) >= limit
            tap.check(
                ratio[key] >= limit or not reached,
                f"{f.row.name} {f.kernel} {figure}: {ratio[key]:.2f} times an4044 of {limit}"
                + ("" if ratio[key] >= limit else ", reached before" if reached else ", not yet"),
            )


def check_figures(all_figures, path, options):
    tap = Tap()
    recorded = read_figures(path)
    seen = set()
    for f in all_figures:
        for name in RECORDED:
            key = (f.row.name, f.kernel, name)
            value, before = f.number(name), recorded.get(key)
            if value is None:
                continue
            seen.add(key)
            label = " ".join(key)
            if before is None:
                tap.check(False, f"{label}: {value:.2f}, but no figure is recorded")
            else:
                tap.check(
                    before * BETTER - 0.01 <= value <= before * WORSE + 0.01,
                    f"{label}: {value:.2f}, recorded {before:.2f}",
                )
    for row in wanted_rows(options):
        if row.missing(options):
            tap.skip(row.name, f"no {row.path(options, row.model())}")
            continue
        for key in sorted(k for k in recorded.keys() - seen if k[0] == row.name):
            if key[1] in wanted_kernels(row, options):
                tap.check(False, f"{' '.join(key)} is recorded, but was not measured")
    check_limits(tap, all_figures, recorded)
    return tap.done()


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    add = parser.add_argument
    add("--model", default="build/arm1136/model.so")
    add("--programs", default="build/arm/bench")
    add("--sysroot", default="build/sysroot")
    add("--samples", default="../shared")
    add("--json", metavar="FILE", help="the table for programs, to a file")
    add("--short", action="store_true", help="without the sweep")
    add("--rows", metavar="NAME,...", type=lambda s: s.split(","))
    add("--kernel", metavar="NAME,...", type=lambda s: s.split(","))
    add("--model-options", default="", metavar="KEY=VALUE,...")
    add("--jobs", type=int, default=os.cpu_count())
    add("--osmesa", action="store_true", help="Debian's OSMesa as well")
    add("--counter", default="build/arm1136/insn_count.so")
    add("--check", metavar="FILE")
    add("--record", metavar="FILE")
    return parser.parse_args()


def refuse_part(options):
    """--record replaces the whole file, so that it needs all figures."""
    if options.rows or options.kernel:
        sys.exit("arm11.py: --record writes all figures: leave out --rows and --kernel")
    absent = sorted({row.path(options, row.model()) for row in ROWS if row.missing(options)})
    if absent:
        sys.exit(
            f"arm11.py: {options.record} stays as it was, as there is no "
            f"{', '.join(absent)}: name the folder of the models with --samples DIR"
        )


def main():
    options = parse_options()
    if options.record:
        refuse_part(options)
    all_figures = Bench(options).all()
    if options.json:
        text = json.dumps(as_json(all_figures), indent=2)
        pathlib.Path(options.json).write_text(text + "\n")
    if options.record:
        write_figures(options.record, all_figures)
    if options.check:
        return check_figures(all_figures, options.check, options)
    print_table(all_figures, sys.stdout)
    return 0


if __name__ == "__main__":
    sys.exit(main())
