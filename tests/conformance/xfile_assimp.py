#!/usr/bin/env python3
"""xfile_assimp.py FILE.x TIME_S POSED.obj

Compares a pose that limber wrote for a .x file with assimp's reading of the
file. This script skins the mesh at the time, from the nodes, bones and keys that
`assimp dump` prints. It prints the largest distance, as a fraction of the extent,
from a vertex of either pose to the nearest vertex of the other, and fails above
1e-4.

assimp duplicates vertices and limber shares them, so their orders differ. A bone
without a node follows the mesh's own node, as in limber.
"""
import math
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

TOLERANCE = 1e-4


def numbers(element):
    return [float(word) for word in element.text.split()]


def matrix(element):
    values = numbers(element.find("Matrix4"))
    return [values[row * 4:row * 4 + 4] for row in range(4)]


def multiply(a, b):
    return [[sum(a[r][k] * b[k][c] for k in range(4)) for c in range(4)]
            for r in range(4)]


def apply(m, p):
    return [sum(m[r][k] * p[k] for k in range(3)) + m[r][3] for r in range(3)]


def from_trs(t, q, s):
    x, y, z, w = q
    length = math.sqrt(w * w + x * x + y * y + z * z)
    w, x, y, z = w / length, x / length, y / length, z / length
    rotation = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    rows = [[rotation[r][c] * s[c] for c in range(3)] + [t[r]]
            for r in range(3)]
    return rows + [[0, 0, 0, 1]]


def value_at(node, kind, tick):
    """The value at a tick; the tick is on a key or between two."""
    keys = [(float(key.get("time")), numbers(key))
            for key in node.iter(kind)]
    if tick <= keys[0][0]:
        return keys[0][1]
    for (t0, v0), (t1, v1) in zip(keys, keys[1:]):
        if tick <= t1:
            u = (tick - t0) / (t1 - t0)
            if kind == "RotationKey" and sum(a * b for a, b in zip(v0, v1)) < 0:
                v1 = [-v for v in v1]
            if kind == "RotationKey":
                return slerp(v0, v1, u)
            return [a + (b - a) * u for a, b in zip(v0, v1)]
    return keys[-1][1]


def slerp(a, b, u):
    cosine = min(1.0, sum(x * y for x, y in zip(a, b)))
    angle = math.acos(cosine)
    if angle < 1e-6:
        return a
    return [(math.sin((1 - u) * angle) * x + math.sin(u * angle) * y) /
            math.sin(angle) for x, y in zip(a, b)]


def worlds(scene, tick):
    """The world matrices of nodes by name and of meshes by number; first clip."""
    animated = {}
    clips = scene.find("AnimationList")
    for node in clips[0].iter("NodeAnim") if clips is not None else []:
        animated[node.get("node")] = from_trs(
            value_at(node, "PositionKey", tick),
            value_at(node, "RotationKey", tick),
            value_at(node, "ScalingKey", tick))
    world, meshes = {}, {}

    def visit(node, above):
        name = node.get("name")
        local = animated.get(name) if tick is not None else None
        world[name] = multiply(above, local or matrix(node))
        refs = node.find("MeshRefs")
        if refs is not None:
            for number in refs.text.split():
                meshes[int(number)] = world[name]
        children = node.find("NodeList")
        for child in children if children is not None else []:
            visit(child, world[name])

    identity = [[float(r == c) for c in range(4)] for r in range(4)]
    visit(scene.find("Node"), identity)
    return world, meshes


def posed(scene, time_s, ticks_per_s):
    world, mesh_world = worlds(scene, time_s * ticks_per_s)
    out = []
    for number, mesh in enumerate(scene.find("MeshList")):
        flat = numbers(mesh.find("Positions"))
        points = [flat[i:i + 3] for i in range(0, len(flat), 3)]
        sums = [[0.0, 0.0, 0.0] for _ in points]
        bones = mesh.find("BoneList")
        if bones is None:
            out += [apply(mesh_world[number], p) for p in points]
            continue
        totals = [0.0] * len(points)
        for bone in bones:
            for weight in bone.iter("Weight"):
                totals[int(weight.get("index"))] += float(weight.text)
        for bone in bones:
            name = bone.get("name")
            to_world = (multiply(world[name], matrix(bone))
                        if name in world else mesh_world[number])
            for weight in bone.iter("Weight"):
                index = int(weight.get("index"))
                fraction = float(weight.text) / totals[index]
                moved = apply(to_world, points[index])
                for axis in range(3):
                    sums[index][axis] += fraction * moved[axis]
        out += sums
    return out


def farthest(a, b, cell):
    """The largest distance from a point of a to the nearest of b."""
    grid = {}
    for point in b:
        key = tuple(math.floor(x / cell) for x in point)
        grid.setdefault(key, []).append(point)
    worst = 0.0
    for point in set(map(tuple, a)):
        key = [math.floor(x / cell) for x in point]
        near = [q for dx in (-1, 0, 1) for dy in (-1, 0, 1)
                for dz in (-1, 0, 1)
                for q in grid.get((key[0] + dx, key[1] + dy, key[2] + dz), [])]
        worst = max(worst, min((math.dist(point, q) for q in near),
                               default=math.inf))
    return worst


def ticks_of(path):
    with open(path, "rb") as file:
        found = re.search(rb"AnimTicksPerSecond\s*\{\s*(\d+)", file.read())
    return float(found.group(1)) if found else 4800.0


def main():
    path, time_s, obj = sys.argv[1], float(sys.argv[2]), sys.argv[3]
    with tempfile.NamedTemporaryFile(suffix=".assxml") as dump:
        subprocess.run(["assimp", "dump", path, dump.name], check=True,
                       stdout=subprocess.DEVNULL)
        scene = ElementTree.parse(dump.name).getroot().find("Scene")
    theirs = posed(scene, time_s, ticks_of(path))
    with open(obj, encoding="ascii") as file:
        ours = [[float(x) for x in line.split()[1:4]]
                for line in file if line.startswith("v ")]
    extent = max(max(p[k] for p in theirs) - min(p[k] for p in theirs)
                 for k in range(3))
    worst = max(farthest(ours, theirs, extent / 20),
                farthest(theirs, ours, extent / 20)) / extent
    print(f"# {path} at {time_s} s: {len(ours)} vertices, {len(theirs)} by "
          f"assimp, worst {worst:.2g} of the extent")
    return 0 if worst <= TOLERANCE else 1


if __name__ == "__main__":
    sys.exit(main())
