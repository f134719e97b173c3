#!/usr/bin/env python3
"""doctor_models.py DIR: writes a sound model, and one more for each pitfall.

It writes DIR/NAME.gltf and prints lines "NAME PATTERN": limber doctor reports the
pattern for NAME, and not for the sound model.
"""
import base64
import copy
import json
import struct
import sys


class Model:
    def __init__(self):
        self.data = b""
        self.json = {"asset": {"version": "2.0"}, "scene": 0,
                     "scenes": [{"nodes": [0, 3]}], "accessors": [],
                     "bufferViews": [], "animations": []}

    def array(self, values, kind="f", wide=3, **more):
        codes = {"f": 5126, "B": 5121, "b": 5120, "H": 5123}
        names = {1: "SCALAR", 3: "VEC3", 4: "VEC4", 16: "MAT4"}
        raw = struct.pack(f"<{len(values)}{kind}", *values)
        self.data += b"\0" * (-len(self.data) % 4)
        self.json["bufferViews"].append(
            {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(raw)})
        self.data += raw
        accessor = {"bufferView": len(self.json["bufferViews"]) - 1,
                    "componentType": codes[kind], "count": len(values) // wide,
                    "type": names[wide]}
        accessor.update(more)
        if wide == 3 and kind == "f":
            accessor["min"] = [min(values[i::3]) for i in range(3)]
            accessor["max"] = [max(values[i::3]) for i in range(3)]
        if wide == 1 and kind == "f":
            accessor["min"], accessor["max"] = [min(values)], [max(values)]
        self.json["accessors"].append(accessor)
        return len(self.json["accessors"]) - 1

    def write(self, path):
        out = copy.deepcopy(self.json)
        out["buffers"] = [{"byteLength": len(self.data),
                           "uri": "data:application/octet-stream;base64,"
                           + base64.b64encode(self.data).decode()}]
        with open(path, "w", encoding="ascii") as file:
            json.dump(out, file)


IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]


def sound():
    """A skinned triangle on two joints, which a clip rotates a little."""
    m = Model()
    position = m.array([0, 0, 0, 1, 0, 0, 0, 1, 0])
    normal = m.array([0, 0, 1] * 3)
    joints = m.array([0, 1, 0, 0] * 3, "B", 4)
    weights = m.array([0.5, 0.5, 0, 0] * 3, "f", 4)
    bind = m.array(IDENTITY * 2, "f", 16)
    m.times = m.array([0.0, 1.0], "f", 1)
    m.turns = m.array([0, 0, 0, 1, 0, 0, 0.005, 0.9999875], "f", 4)
    m.json["meshes"] = [{"primitives": [{"attributes": {
        "POSITION": position, "NORMAL": normal, "JOINTS_0": joints,
        "WEIGHTS_0": weights}}]}]
    m.json["nodes"] = [{"children": [1]}, {"children": [2]}, {},
                       {"mesh": 0, "skin": 0}]
    m.json["skins"] = [{"joints": [1, 2], "inverseBindMatrices": bind}]
    m.json["animations"] = [{
        "name": "turn",
        "samplers": [{"input": m.times, "output": m.turns}],
        "channels": [{"sampler": 0, "target": {"node": 1, "path": "rotation"}},
                     {"sampler": 0, "target": {"node": 2, "path": "rotation"}}]}]
    return m


def sampler(m, **values):
    m.json["animations"][0]["samplers"][0].update(values)


def attributes(m):
    return m.json["meshes"][0]["primitives"][0]["attributes"]


def cubic(m):
    turns = [0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0] * 2
    sampler(m, output=m.array(turns, "f", 4), interpolation="CUBICSPLINE")


def opens(m):
    sampler(m, output=m.array([0, 0, 0, 1, 0, 0, 0.6, 0.8], "f", 4))


def late(m):
    clip = m.json["animations"][0]
    clip["samplers"].append({"input": m.array([0.25, 1.0], "f", 1),
                             "output": m.turns})
    clip["channels"][1]["sampler"] = 1


def all_late(m):
    sampler(m, input=m.array([0.25, 1.0], "f", 1))


def short(m):
    clip = m.json["animations"][0]
    clip["samplers"].append({"input": m.array([0.0, 0.5], "f", 1),
                             "output": m.turns})
    clip["channels"][1]["sampler"] = 1


def single(m):
    clip = m.json["animations"][0]
    clip["samplers"].append({"input": m.array([0.0], "f", 1),
                             "output": m.array([0, 0, 0, 1], "f", 4)})
    clip["channels"][1]["sampler"] = 1


def step(m):
    sampler(m, interpolation="STEP")


def far(m):
    sampler(m, output=m.array([0, 0, 0, 1, 0, 0, 0.6, -0.8], "f", 4))


def two_clips(m):
    clip = copy.deepcopy(m.json["animations"][0])
    del clip["channels"][1]
    m.json["animations"].append(clip)


def apart(m):
    two_clips(m)
    del m.json["animations"][0]["channels"][0]


def namesakes(m):
    two_clips(m)
    for clip in m.json["animations"]:
        clip["name"] = "mixamo.com"


def integers(m):
    sampler(m, output=m.array([0, 0, 0, 127, 0, 0, 76, 102], "b", 4,
                              normalized=True))


def placed(m):
    m.json["nodes"][3]["translation"] = [0, 1, 0]


def ancestor(m):
    m.json["nodes"][0]["translation"] = [0, 1, 0]


def scaled(m):
    m.json["nodes"][1]["scale"] = [2, 2, 2]


def no_bind(m):
    del m.json["skins"][0]["inverseBindMatrices"]


def order(m):
    m.json["skins"][0]["joints"] = [2, 1]


def backwards(m):
    nodes = m.json["nodes"]
    nodes[0]["children"], nodes[2]["children"] = [2], [1]
    del nodes[1]["children"]


def two_skins(m):
    m.json["skins"].append({"joints": [1, 2], "inverseBindMatrices":
                            m.json["skins"][0]["inverseBindMatrices"]})
    m.json["nodes"].append({"mesh": 0, "skin": 1})
    m.json["scenes"][0]["nodes"].append(4)


def weightless(m):
    attributes(m)["WEIGHTS_0"] = m.array(
        [0, 0, 0, 0] + [0.5, 0.5, 0, 0] * 2, "f", 4)


def uneven(m):
    attributes(m)["WEIGHTS_0"] = m.array([0.5, 0.7, 0, 0] * 3, "f", 4)


def eight(m):
    attributes(m)["JOINTS_1"] = attributes(m)["JOINTS_0"]
    attributes(m)["WEIGHTS_1"] = m.array([0, 0, 0, 0] * 3, "f", 4)


def flat(m):
    del attributes(m)["NORMAL"]


def morphed(m):
    m.json["meshes"][0]["primitives"][0]["targets"] = [
        {"POSITION": attributes(m)["POSITION"]}]


def own_weights(m):
    morphed(m)
    m.json["meshes"][0]["weights"] = [0.0]
    m.json["nodes"][3]["weights"] = [1.0]


def carried(m):
    mesh = copy.deepcopy(m.json["meshes"][0])
    for name in ("JOINTS_0", "WEIGHTS_0"):
        del mesh["primitives"][0]["attributes"][name]
    m.json["meshes"].append(mesh)
    m.json["nodes"].append({"mesh": 1})
    m.json["nodes"][2]["children"] = [4]


def empty(m):
    morphed(m)
    index = m.array([0.0] * 9)
    del m.json["accessors"][index]["bufferView"]
    m.json["meshes"][0]["primitives"][0]["targets"][0]["POSITION"] = index


def sheared(m):
    m.json["nodes"][0]["matrix"] = [1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0,
                                    0, 0, 0, 1]


def extended(m):
    m.json["extensionsUsed"] = ["KHR_texture_transform", "MSFT_lod",
                                "KHR_xmp_json_ld", "KHR_materials_ior"]


def filmed(m):
    m.json["cameras"] = [{"type": "perspective",
                          "perspective": {"yfov": 0.7, "znear": 0.1}}]
    m.json["nodes"][0]["camera"] = 0


def levels(m):
    m.json["nodes"][3]["name"] = "Tree_LOD0"
    m.json["nodes"].append({"name": "Tree_LOD1", "mesh": 0, "skin": 0})
    m.json["scenes"][0]["nodes"].append(4)


def collider(m):
    m.json["nodes"][3]["name"] = "UCX_Tree"


def scenes(m):
    m.json["scenes"] += [{"nodes": [0]}, {"nodes": [3]}]


PITFALLS = [
    (extended, "ignores .2.,.* shown: KHR_xmp_json_ld, KHR_materials_ior"),
    (cubic, "CUBICSPLINE channels"),
    (opens, "end in another shape than they begin with .1., such as turn: "),
    (late, "some first keys lie up to 0.2500 s after the start"),
    (all_late, "no key lies before 0.2500 s; .* from frame 0"),
    (short, "some channels end at 0.5000 s"),
    (single, "channels with a single key"),
    (step, "STEP channels"),
    (far, "rotation keys with a negative dot product"),
    (two_clips, "a node that another clip does not move"),
    (apart, "each move nodes of their own .2 of 2."),
    (namesakes, "clips with the name of an earlier clip .1.: "),
    (integers, "samplers with integer outputs"),
    (placed, "skinned nodes with a transform of their own"),
    (ancestor, "joints whose parent is not a joint"),
    (scaled, "joints with a scale"),
    (no_bind, "skins without inverse bind matrices"),
    (order, "joints in another order than the nodes"),
    (backwards, "before their parents in the file"),
    (two_skins, "mesh 0 is drawn with 2 skins"),
    (weightless, "vertices without a weight above 0"),
    (uneven, "weights do not sum to 1"),
    (eight, "second set of joints and weights"),
    (flat, "primitives without normals"),
    (morphed, "node 3 is morphed and skinned"),
    (own_weights, "nodes with morph weights of their own"),
    (carried, "meshes without a skin that are attached to joints"),
    (empty, "accessors without a buffer view"),
    (sheared, "nodes with a sheared matrix"),
    (filmed, "cameras .1.: limber looks at the whole model from outside"),
    (levels, "levels of detail as nodes of their own .1., such as Tree_LOD1: "),
    (collider, "shapes for collisions .1., such as UCX_Tree: "),
    (scenes, "scenes beside the one that is shown .2.: "),
]


def main():
    folder = sys.argv[1]
    sound().write(f"{folder}/sound.gltf")
    for change, pattern in PITFALLS:
        model = sound()
        change(model)
        model.write(f"{folder}/{change.__name__}.gltf")
        print(change.__name__, pattern)


if __name__ == "__main__":
    main()
