"""Models that move, for user_models.py, which describes them."""
import math

from glb import BYTE, FLOAT, checks, png
from shapes import blob, cube, grid, rope, sized, tube


def make_worm(model, around=16, along=96, still=0):
    joints = 8
    positions, _, texcoords, indices = rope(around, along)
    material = model.material(model.texture(png(64, checks(64), 3)))
    model.mesh(material, (positions, None, texcoords, indices), skin=0)
    attributes = model.json["meshes"][0]["primitives"][0]["attributes"]
    places = [j / along * (joints - 1) for j in range(along + 1) for i in range(around + 1)]
    shares = [(int(p), min(int(p) + 1, joints - 1), p % 1) for p in places]
    attributes["JOINTS_0"] = model.accessor("VEC4", BYTE, [(a, b if s else 0, 0, 0) for a, b, s in shares])
    weights = [(1 - s, s, 0, 0) for a, b, s in shares]
    attributes["WEIGHTS_0"] = model.accessor("VEC4", FLOAT, weights)
    first = len(model.json["nodes"])
    times = model.accessor("SCALAR", FLOAT, [(t / 4,) for t in range(9)], min=[0], max=[2])
    animation = {"name": "crawl", "samplers": [], "channels": []}
    inverse = []
    for k in range(joints):
        at = 6 * k / (joints - 1)
        model.add("nodes", {"translation": (0, 6 / (joints - 1) if k else 0, 0)})
        if k:
            model.json["nodes"][first + k - 1]["children"] = [first + k]
        size = 0.12 if k >= still else 0
        angles = [size * math.sin(math.pi * t / 4 + 0.7 * k) for t in range(9)]
        turns = [(0, 0, math.sin(a), math.cos(a)) for a in angles]
        sampler = {"input": times, "output": model.accessor("VEC4", FLOAT, turns)}
        target = {"node": first + k, "path": "rotation"}
        animation["samplers"].append(sampler)
        animation["channels"].append({"sampler": k, "target": target})
        inverse.append((1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -at, 0, 1))
    model.json["scenes"][0]["nodes"].append(first)
    bones = list(range(first, first + joints))
    matrices = model.accessor("MAT4", FLOAT, inverse)
    model.add("skins", {"joints": bones, "inverseBindMatrices": matrices})
    model.add("animations", animation)


def make_tail(model):
    """Seven of ten vertices never move."""
    make_worm(model, 12, 40, 5)


def make_snake(model):
    """So many vertices that limber play poses those of the level of detail."""
    make_worm(model, 40, 210)
    attributes = model.json["meshes"][0]["primitives"][0]["attributes"]
    attributes["NORMAL"] = model.accessor("VEC3", FLOAT, rope(40, 210)[1])


def make_shapes(model):
    """52 targets, as the faces of phones' cameras have them: patches of several
    sizes, of which some have weights at a time."""
    count, times = 52, 9
    shape = positions, normals, _, _ = blob(30, 20)
    model.mesh(model.material(color=(0.7, 0.5, 0.4, 1)), shape)
    mesh = model.json["meshes"][0]
    targets = mesh["primitives"][0]["targets"] = []
    for k in range(count):
        middle = positions[k * 12 + 10]
        reach = 4 if k % 8 == 0 else 0.5 + k % 5 * 0.1
        parts = [max(0, 1 - (math.dist(p, middle) / reach) ** 2) for p in positions]
        moves = [(0, 0.15 * part, 0.05 * part) for part in parts]
        turns = [(0.2 * part, 0, -0.1 * part) for part in parts]
        ends = {f.__name__: [f(m[i] for m in moves) for i in range(3)] for f in (min, max)}
        targets.append({
            "POSITION": model.accessor("VEC3", FLOAT, moves, **ends),
            "NORMAL": model.accessor("VEC3", FLOAT, turns),
        })  # fmt: skip
    mesh["weights"] = [0] * count
    keys = model.accessor("SCALAR", FLOAT, [(t / 8,) for t in range(times)], min=[0], max=[1])
    weights = [(max(0, math.sin(k + t * (1 + k % 3) / 2) - 0.5),) for t in range(times) for k in range(count)]
    sampler = {"input": keys, "output": model.accessor("SCALAR", FLOAT, weights)}
    channel = {"sampler": 0, "target": {"node": 0, "path": "weights"}}
    model.add("animations", {"name": "talk", "samplers": [sampler], "channels": [channel]})


def add_turns(model, count, size):
    """A clip in which so many nodes turn by up to twice this angle between keys."""
    times = model.accessor("SCALAR", FLOAT, [(0,), (1,), (2,)], min=[0], max=[2])
    animation = {"name": "turn", "samplers": [], "channels": []}
    for k in range(count):
        angles = [size * math.sin(3 * t + 0.3 * k) for t in range(3)]
        turns = [(0, math.sin(a), 0, math.cos(a)) for a in angles]
        output = model.accessor("VEC4", FLOAT, turns)
        animation["samplers"].append({"input": times, "output": output})
        animation["channels"].append({"sampler": k, "target": {"node": k, "path": "rotation"}})
    model.add("animations", animation)


def make_mast(model):
    texture = model.texture(png(256, checks(256), 3))
    model.mesh(model.material(texture), sized(cube(), 0.02, 5, 0.02))
    add_turns(model, 1, 0.1)


def make_pipe(model):
    lying = (0, 0, -math.sqrt(0.5), math.sqrt(0.5))
    material = model.material(color=(0.3, 0.7, 0.3, 1))
    model.mesh(material, sized(tube(16, 160), 0.25, 1, 0.25), rotation=lying)
    add_turns(model, 1, 0.1)


def make_bird(model):
    color = {"color": (0.5, 0.4, 0.3, 1)}
    model.mesh(model.material(**color), sized(blob(16, 8), 0.3, 0.3, 1))
    wing = model.material(**color, doubleSided=True)
    for side in (-1, 1):
        positions, normals, texcoords, indices = grid(8, 1)
        places = [(side * (x + 1) * 1.2, z * 0.1, y * 0.4) for x, y, z in positions]
        model.mesh(wing, (places, [(0, 1, 0)] * len(normals), texcoords, indices))
    add_turns(model, 1, 0.1)


def make_vanes(model):
    count = 60
    mesh = model.mesh(model.material(color=(0.8, 0.5, 0.3, 1)), cube())
    for k in range(1, count):
        model.show(mesh, translation=(k % 10 * 2.5, 0, k // 10 * 2.5))
    add_turns(model, count, 1.5)
