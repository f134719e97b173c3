#!/usr/bin/env python3
"""texts.py check FOLDER LIMBER... | make LIMBER...

Runs limber with the arguments of each line of texts.txt, and compares what it
prints and writes with the reference texts/NAME.txt: words and whole numbers must
be equal, others within 0.1%, as libraries of other machines round differently. What
limber measures is left out. Files are kept as text, too: of a .glb its JSON, and of
each accessor two sums, in which every value and its place count, and of a .y4m a
line for each picture. Each line of films.txt names such a film, by arguments of
limber render: the soft driver draws the same on every machine. check prints TAP, and
leaves what differs in FOLDER; make writes the references again. The environment
may set GOLDEN, the folder of texts.txt, films.txt and the references, and TEXTS, a
regular expression that names begin like; others are left out.
"""
import difflib
import json
import os
import pathlib
import re
import shlex
import struct
import subprocess
import sys
import tempfile
import zlib

GOLDEN = pathlib.Path(os.environ.get("GOLDEN") or pathlib.Path(__file__).parent)
NAMES = re.compile(os.environ.get("TEXTS") or "")
TIME_S = 300
RELATIVE, ABSOLUTE = 1e-3, 1e-4
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
# Columns of a table in Markdown or CSV, and members of JSON.
MEASURED = {"us_per_frame", "warm_ns", "cold_ns"}
MEASURED_COLUMNS = MEASURED | {"instructions_per_frame"}
LAST_MEASURED = "us here k instr."
OUTSIDE_QUOTES = r'(?=(?:[^"]*"[^"]*")*[^"]*$)'
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
LETTERS = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}
FILM = ["--gl", "soft", "-o", "OUT/film.y4m"]
# A picture's brightness is shown for so many columns and rows.
COLUMNS, ROWS = 4, 4


def lines_of(name):
    for line in (GOLDEN / name).read_text().splitlines():
        if line and not line.startswith("#"):
            yield shlex.split(line)


def commands():
    """The names of texts.txt and films.txt, each with the arguments of its lines."""
    named = {}
    for name, *arguments in lines_of("texts.txt"):
        named.setdefault(name, []).append(arguments)
    for name, *arguments in lines_of("films.txt"):
        named.setdefault(f"film-{name}", []).append(["render", *arguments, *FILM])
    return named.items()


def sums_of(accessor, view, binary):
    """The sum of an accessor's values, and that of values times their place."""
    width = WIDTHS[accessor["type"]]
    letter = LETTERS[accessor["componentType"]]
    size = struct.calcsize(letter) * width
    at = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    step = view.get("byteStride", size)
    values = [value for i in range(accessor["count"])
              for value in struct.unpack_from(
                  f"<{width}{letter}", binary, at + i * step)]
    return [sum(values), sum(i * v for i, v in enumerate(values, 1))]


def text_of_glb(data):
    size, = struct.unpack_from("<I", data, 12)
    root = json.loads(data[20:20 + size])
    binary = data[28 + size:]
    views = root.get("bufferViews", [])
    rest = set(range(len(views)))
    for accessor in root.get("accessors", []):
        if "bufferView" in accessor:
            view = accessor["bufferView"]
            rest.discard(view)
            accessor["sums"] = sums_of(accessor, views[view], binary)
    for view in map(views.__getitem__, rest):
        start = view.get("byteOffset", 0)
        view["crc32"] = "%08x" % zlib.crc32(
            binary[start:start + view["byteLength"]])
    lines = []
    for name, part in root.items():
        lines += [f"{name}: {json.dumps(item)}\n"
                  for item in (part if isinstance(part, list) else [part])]
    return "".join(lines)


def brightness(luma, width, height):
    """The mean of each part of a picture, row by row, as 00 to 99."""
    rows = []
    for row in range(ROWS):
        lines = range(row * height // ROWS, (row + 1) * height // ROWS)
        means = []
        for column in range(COLUMNS):
            left = column * width // COLUMNS
            right = (column + 1) * width // COLUMNS
            total = sum(sum(luma[y * width + left:y * width + right])
                        for y in lines)
            means.append(total * 100 // (256 * len(lines) * (right - left)))
        rows.append(" ".join(f"{mean:02}" for mean in means))
    return ", ".join(rows)


def text_of_film(data):
    """A line for each picture: its sum, and how bright its parts are."""
    header, *_ = data.split(b"\n", 1)
    width, height, rate, per = map(int, re.search(
        rb" W(\d+) H(\d+) F(\d+):(\d+)", header).groups())
    area = width * height
    size = area + 2 * ((width + 1) // 2) * ((height + 1) // 2)
    lines = [header.decode() + "\n"]
    begin = len(header) + 1 + len(b"FRAME\n")
    for number, at in enumerate(range(begin, len(data), size + len(b"FRAME\n"))):
        picture = data[at:at + size]
        lines.append("%.2f s  %08x  %s\n" % (
            number * per / rate, zlib.crc32(picture),
            brightness(picture[:area], width, height)))
    return "".join(lines)


def text_of_file(path):
    data = path.read_bytes()
    if path.suffix == ".glb":
        return text_of_glb(data)
    if path.suffix == ".y4m":
        return text_of_film(data)
    if data.startswith(b"\x89PNG"):
        return text_of_png(data)
    try:
        return data.decode()
    except UnicodeDecodeError:
        return "%d bytes\n" % len(data) + "".join(
            "%08x\n" % zlib.crc32(data[i:i + 4096])
            for i in range(0, len(data), 4096))


def hide_columns(lines, mark):
    """Puts dashes into the measured columns of the table in lines, if any."""
    rows = [re.split(mark + OUTSIDE_QUOTES, line) for line in lines]
    columns = [i for row in rows for i, cell in enumerate(row)
               if cell.strip() in MEASURED_COLUMNS]
    for i, row in enumerate(rows):
        for column in columns:
            cell = row[column].strip() if column < len(row) else "none"
            if not cell or NUMBER.fullmatch(cell):
                row[column] = "-"
                lines[i] = mark.strip("\\").join(row)


def hide_last_columns(lines):
    """The same for a table of limber compare whose last columns are measured."""
    inside = False
    for i, line in enumerate(lines):
        if inside and line:
            lines[i] = re.sub(r"( +\S+ +\S+)$", " - -", line)
        inside = bool(line) and (inside or line.endswith(LAST_MEASURED))


def without_measured(text):
    """Text in which dashes stand for what was measured."""
    lines = text.splitlines()
    for mark in (r"\|", ","):
        hide_columns(lines, mark)
    hide_last_columns(lines)
    return re.sub(f'"({"|".join(MEASURED)})": {NUMBER.pattern}',
                  r'"\1": "-"', "\n".join(lines) + "\n")


def text_of_png(data):
    """A line for each chunk; of the pixels, the sum without their compression."""
    lines, pixels, at = [], b"", 8
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        if kind == b"IDAT":
            pixels += data[at + 8:at + 8 + size]
        else:
            lines.append(f"{kind.decode()} {data[at + 8:at + 8 + size].hex()}\n")
        at += 12 + size
    return "".join(lines) + "IDAT %08x\n" % zlib.crc32(zlib.decompress(pixels))


def text_of_all(limber, commands):
    """What commands say and write; where there are several, after their names."""
    if len(commands) == 1:
        return text_of(limber, commands[0])
    return "\n".join(f"limber {shlex.join(arguments)}\n{text_of(limber, arguments)}"
                     for arguments in commands)


def text_of(limber, arguments):
    """What a command says and writes."""
    with tempfile.TemporaryDirectory() as folder:
        words = [word.replace("OUT", folder, 1) if word.split("/")[0] == "OUT"
                 else word for word in arguments]
        result = subprocess.run(
            [*limber, *words], stdin=subprocess.DEVNULL, timeout=TIME_S,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            encoding="utf-8", errors="replace", check=False)
        parts = [f"status {result.returncode}\n",
                 without_measured(result.stdout.replace(folder, "OUT"))]
        for path in sorted(pathlib.Path(folder).iterdir()):
            parts.append(f"\n{path.name}:\n" +
                         without_measured(text_of_file(path)))
    return "".join(parts)


def is_near(wanted, found):
    if re.fullmatch(r"[-+]?\d+", wanted) and re.fullmatch(r"[-+]?\d+", found):
        return int(wanted) == int(found)
    difference = abs(float(wanted) - float(found))
    return difference <= ABSOLUTE + RELATIVE * abs(float(wanted))


def is_same_line(wanted, found):
    return wanted == found or (
        NUMBER.split(wanted) == NUMBER.split(found) and
        all(map(is_near, NUMBER.findall(wanted), NUMBER.findall(found))))


def is_same(wanted, found):
    wanted, found = wanted.splitlines(), found.splitlines()
    return len(wanted) == len(found) and all(map(is_same_line, wanted, found))


def check(name, named, limber, folder):
    """The lines that say why a text is not its reference; none if it is."""
    reference = GOLDEN / "texts" / f"{name}.txt"
    try:
        found = text_of_all(limber, named)
    except subprocess.TimeoutExpired:
        return [f"limber ran for more than {TIME_S} s"]
    if not reference.exists():
        return [f"{reference} does not exist: run make golden, and read it"]
    wanted = reference.read_text()
    if is_same(wanted, found):
        return []
    (folder / f"{name}.txt").write_text(found)
    return list(difflib.unified_diff(
        wanted.splitlines(), found.splitlines(), str(reference),
        str(folder / f"{name}.txt"), lineterm="", n=1))[:40]


def check_all(folder, limber):
    folder.mkdir(parents=True, exist_ok=True)
    names, failed = set(), False
    count = 1
    for name, named in commands():
        names.add(f"{name}.txt")
        if NAMES.match(name):
            reasons = check(name, named, limber, folder)
            print(f"{'not ok' if reasons else 'ok'} {count} - {name}")
            print("".join(f"# {line}\n" for line in reasons), end="")
            failed |= bool(reasons)
            count += 1
    rest = {path.name for path in (GOLDEN / "texts").glob("*")} - names
    print(f"{'not ok' if rest else 'ok'} {count} - every reference is listed")
    print("".join(f"# texts.txt and films.txt do not list {name}\n" for name in rest), end="")
    print(f"1..{count}")
    return 1 if failed or rest else 0


def make_all(limber):
    (GOLDEN / "texts").mkdir(exist_ok=True)
    for name, named in commands():
        if NAMES.match(name):
            print(f"  TEXT    {GOLDEN}/texts/{name}.txt")
            (GOLDEN / "texts" / f"{name}.txt").write_text(
                text_of_all(limber, named))
    return 0


def main():
    if len(sys.argv) > 3 and sys.argv[1] == "check":
        return check_all(pathlib.Path(sys.argv[2]), sys.argv[3:])
    if len(sys.argv) > 2 and sys.argv[1] == "make":
        return make_all(sys.argv[2:])
    print(__doc__.splitlines()[0], file=sys.stderr)
    return 2


sys.exit(main())
