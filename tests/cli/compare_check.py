#!/usr/bin/env python3
"""compare_check.py REPORT.json MODEL BAKED COMMAND...: recomputes the figures.

It poses the model and the baked models with `COMMAND pose` and projects both
with the report's view, so the errors come from files and not from the program's
own arrays. Bytes come from the files' accessors. It prints TAP.
"""
import functools
import json
import math
import os
import struct
import subprocess
import sys
import tempfile
import zlib

COMPONENT_BYTES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
FORMAT = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}
WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class Glb:
    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        length = struct.unpack_from("<I", data, 12)[0]
        self.json = json.loads(data[20:20 + length])
        self.binary = data[20 + length + 8:]

    def accessor_bytes(self, index):
        accessor = self.json["accessors"][index]
        views = self.json["bufferViews"]
        if "sparse" in accessor:
            sparse = accessor["sparse"]
            return sum(views[sparse[part]["bufferView"]]["byteLength"]
                       for part in ("indices", "values"))
        view = views[accessor["bufferView"]]
        if "byteStride" in view:
            return accessor["count"] * view["byteStride"]
        return (accessor["count"] * WIDTH[accessor["type"]]
                * COMPONENT_BYTES[accessor["componentType"]])

    def read(self, index):
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        width = WIDTH[accessor["type"]]
        kind = accessor["componentType"]
        stride = view.get("byteStride", width * COMPONENT_BYTES[kind])
        at = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        return [struct.unpack_from(f"<{width}{FORMAT[kind]}", self.binary,
                                   at + i * stride)
                for i in range(accessor["count"])]

    def moving_bytes(self):
        """The bytes of vertices, targets and clips: file_bytes of a baked model.

        Levels of detail have the accessors of the full mesh.
        """
        used = set()
        for mesh in self.json["meshes"]:
            for primitive in mesh["primitives"]:
                used |= {index for name, index in primitive["attributes"].items()
                         if name in ("POSITION", "NORMAL")}
                for target in primitive.get("targets", []):
                    used |= set(target.values())
        total = sum(map(self.accessor_bytes, used))
        for clip in self.json["animations"]:
            for sampler in clip["samplers"]:
                total += self.accessor_bytes(sampler["input"])
                total += self.accessor_bytes(sampler["output"])
        return total


def png_rows(path):
    """The rows of a picture of limber's: 8 bits, not interlaced."""
    with open(path, "rb") as file:
        data = file.read()
    width, height, _, colors = struct.unpack_from(">IIBB", data, 16)
    step = {2: 3, 6: 4}[colors]
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        packed += data[at + 8:at + 8 + length] if kind == b"IDAT" else b""
        at += length + 12
    plain, above, rows = zlib.decompress(packed), bytes(width * step), []
    for y in range(height):
        start = y * (width * step + 1)
        row = bytearray(plain[start + 1:start + 1 + width * step])
        for i in range(len(row)):
            left = row[i - step] if i >= step else 0
            corner = above[i - step] if i >= step else 0
            guess = left + above[i] - corner
            paeth = min((left, above[i], corner), key=lambda c: abs(guess - c))
            row[i] = row[i] + (0, left, above[i], (left + above[i]) // 2,
                               paeth)[plain[start]] & 255
        rows.append(bytes(row))
        above = row
    return rows


class Check:
    count = 0
    failed = 0

    def __call__(self, good, name, why=""):
        self.count += 1
        self.failed += not good
        print(f"{'ok' if good else 'not ok'} {self.count} - {name}")
        if not good:
            print(f"# {why}")


@functools.lru_cache(None)
def posed(command, model, clip, time_s, folder, math_kind="float"):
    """The vertices in world space, and the faces in the order of the nodes.

    Rows have moments in common, and limber poses the model once for each.
    """
    path = os.path.join(folder, "posed.obj")
    subprocess.run([*command, "pose", model, "--clip", str(clip), "--time",
                    f"{time_s:.9f}", "--math", math_kind, "-o", path],
                   check=True)
    vertices, objects = [], {}
    with open(path, encoding="ascii") as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                vertices.append(tuple(map(float, words[1:4])))
            elif words[:1] == ["o"]:
                node = int(words[1].split("_")[0][len("node"):])
                faces = objects.setdefault(node, [])
            elif words[:1] == ["f"]:
                faces.append([int(word.split("/")[0]) - 1
                              for word in words[1:4]])
    return vertices, [face for node in sorted(objects)
                      for face in objects[node]]


def project(screen, point):
    view = screen["view"]
    eye = [sum(view[column * 4 + row] * (point + (1.0,))[column]
               for column in range(4)) for row in range(3)]
    return (eye[0] * screen["focal_px"] / -eye[2],
            eye[1] * screen["focal_px"] / -eye[2])


def distance_px(screen, a, b):
    (ax, ay), (bx, by) = project(screen, a), project(screen, b)
    return math.hypot(ax - bx, ay - by)


def joint_of_triangle(joints, weights, corners):
    sums = {}
    for corner in corners:
        for joint, weight in zip(joints[corner], weights[corner]):
            sums[joint] = sums.get(joint, 0.0) + weight
    best = max(sums.values())
    return next(joint for joint, value in sums.items() if value == best)


def rigid_corners(original, rigid):
    """The model's corners in the order of the nodes that move the parts."""
    primitive = original.json["meshes"][0]["primitives"][0]
    joints = original.read(primitive["attributes"]["JOINTS_0"])
    weights = original.read(primitive["attributes"]["WEIGHTS_0"])
    index = [i for (i,) in original.read(primitive["indices"])]
    triangles = [index[i:i + 3] for i in range(0, len(index), 3)]
    parts = {}
    for triangle in triangles:
        joint = joint_of_triangle(joints, weights, triangle)
        parts.setdefault(joint, []).extend(triangle)
    names = [node.get("name") for node in rigid.json["nodes"]]
    skin = original.json["skins"][0]["joints"]

    def place(joint):
        return names.index(original.json["nodes"][skin[joint]]["name"])
    return [corner for joint in sorted(parts, key=place)
            for corner in parts[joint]]


def check_predictions(check, candidates):
    """The steps of a frame are its sum; play_check.py plays what is quoted."""
    for candidate in filter(lambda c: c["listed"], candidates):
        cell = candidate["clips"][0]
        for figure in ("us_per_frame", "instructions_per_frame"):
            parts = sum(step[figure] for step in cell["arm11_split"].values())
            whole = cell["arm11_predicted"][figure]
            check(abs(parts - whole) < 1e-3 * whole and whole > 0,
                  f"{candidate['name']}: the steps' {figure} sum to {whole:.1f}",
                  f"{parts:.1f}")


def check_advice(check, report):
    """The least sum of both prices of those that keep within the limits."""
    def cost_us(candidate):
        return candidate["arm11_predicted"]["us_per_frame"]

    def price(candidate):
        return (cost_us(candidate) / (report["board_frame_ms"] * 10)
                + candidate["ram_bytes"] / report["bytes_per_percent"])

    good = [c for c in report["candidates"]
            if c["listed"] and c["peak_px"] <= report["bound_px"]
            and c["ram_bytes"] <= report["ram_limit_bytes"]
            and cost_us(c) <= report["frame_limit_us"]]
    # Less than 0.3 percent is not worth converting a model.
    best = [c["name"] for c in good
            if price(c) <= min(map(price, good)) + 0.3]
    check(report["advice"] in best if good else report["advice"],
          "the advice is by the prices of time and memory",
          f"{report['advice']}, not {best}")


def file_of(candidate):
    """The file that holds a row's bake, or None for the model itself."""
    name = candidate["name"]
    if name.startswith("morph, "):
        kind = "morph" if name.endswith("fitted") else "morph-even"
        return f"{kind}-{candidate['keys']}.glb"
    if name == "rigid parts":
        return "rigid.glb"
    if "influence" in name:
        return f"skin-{name.split(', ')[1].split()[0]}.glb"
    return "skin.glb" if name == "skin" else None


def far_off(screen, wanted, shown, pairs):
    return max(distance_px(screen, shown[a], wanted[b]) for a, b in pairs)


def check_row(check, report, candidate, model, path, corners, command, folder):
    """Plays a baked file and compares it with the model at many times."""
    name = os.path.basename(path)
    clip, cell = report["clips"][0], candidate["clips"][0]
    screen, times = clip["screen"], clip["times_s"]
    peak = cell["peak_px"]
    worst = {}
    for time_s in times[::max(1, len(times) // 6)] + [cell["peak_s"]]:
        wanted, _ = posed(command, model, clip["clip"], time_s, folder)
        shown, faces = posed(command, path, 0, time_s, folder)
        if corners:
            flat = [corner for face in faces for corner in face]
            pairs = list(zip(flat, corners))
        else:
            pairs = [(i, i) for i in range(len(wanted))]
        worst[time_s] = far_off(screen, wanted, shown, pairs)
    # The files have six decimals of a model a metre or two high; skins and
    # morphs are quoted in fixed point but posed in float here.
    slack = 0.002 if corners else 0.03
    at_peak = worst[cell["peak_s"]]
    check(abs(at_peak - peak) < slack + 0.001 * peak,
          f"{name}: off by {peak:.3f} px at {cell['peak_s']:.3f} s",
          f"{at_peak:.4f} px recomputed")
    # What a refined search may miss.
    check(all(value < max(peak * 1.05, peak + 0.05)
              for value in worst.values()),
          f"{name}: nowhere further off", f"{worst}")
    wanted, _ = posed(command, model, clip["clip"], cell["peak_s"], folder)
    shown, _ = posed(command, path, 0, cell["peak_s"], folder, "fixed")
    value = far_off(screen, wanted, shown, pairs)
    check(abs(value - peak) < 0.03 + 0.001 * peak,
          f"{name}: as far off when fixed point plays it",
          f"{value:.4f} px, {peak:.4f} in the report")
    if candidate["name"].endswith("fitted"):
        check(peak <= report["bound_px"] * 1.0001,
              f"{name}: keeps within the accepted error", f"{peak} px")


def check_bytes(check, candidate, path):
    """Sparse accessors may save some of the bytes that are quoted."""
    quoted, found = candidate["file_bytes"], Glb(path).moving_bytes()
    check(0.4 * quoted < found <= quoted if "keys" in candidate["name"]
          else found == quoted,
          f"{os.path.basename(path)}: as many bytes as the report says",
          f"{found} in the file, {quoted} in the report")


def main():
    report_path, model, baked = sys.argv[1:4]
    command = tuple(sys.argv[4:])
    check = Check()
    with open(report_path, encoding="utf-8") as file:
        report = json.load(file)
    original = Glb(model) if model.endswith(".glb") else None
    simple = original and len(original.json["meshes"]) == 1 and \
        len(original.json["meshes"][0]["primitives"]) == 1

    with tempfile.TemporaryDirectory() as folder:
        for candidate in report["candidates"]:
            name = file_of(candidate)
            if not candidate["listed"] or not name:
                continue
            # The order of triangles is known only for a single part.
            if name == "rigid.glb" and not simple:
                continue
            path = os.path.join(baked, name)
            if not os.path.exists(path):
                continue
            corners = rigid_corners(original, Glb(path)) \
                if name == "rigid.glb" else None
            if not name.startswith("skin"):
                check_bytes(check, candidate, path)
            check_row(check, report, candidate, model, path, corners, command,
                      folder)
    check_predictions(check, report["candidates"])
    check_advice(check, report)
    print(f"1..{check.count}")
    return check.failed > 0


if __name__ == "__main__":
    sys.exit(main())
