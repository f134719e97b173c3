#!/usr/bin/env python3
"""arm11_table.py FIGURES TABLE.c: copies recorded figures of the board's loops
into the table that limber compare predicts with (app/anim/kernel/arm11_cost.h)."""

import pathlib
import re
import sys

from arm11 import read_figures

BEST = ("armv6", "pose")


def main():
    figures = read_figures(sys.argv[1])
    table = pathlib.Path(sys.argv[2])

    def renewed(line):
        row = line[1]
        kernel = next(k for k in BEST if (row, k, "cold") in figures)
        cycles, instructions = (figures[row, kernel, f] for f in ("cold", "instructions"))
        return f'{{"{row}", {cycles:.2f}f, {instructions:.2f}f}}'

    text = table.read_text(encoding="ascii")
    renewed_text = re.sub(r'\{"([^"]+)", [\d.f]+, [\d.f]+\}', renewed, text)
    if renewed_text != text:
        table.write_text(renewed_text, encoding="ascii")


if __name__ == "__main__":
    main()
