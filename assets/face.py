"""The face: a bust with eight expressions as morph targets.

    blender -b --factory-startup -P assets/face.py -- assets/face.glb

bust/ computes the mesh and its key frames with numpy. This script makes a
Blender object of them, with shape keys, baked ambient occlusion and two clips.
"""

import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import bpy
import numpy as np

import common
from bust import expression
from bust.model import Bust

SCALE = 0.12  # metres for one unit of the bust
FOOT = -2.05  # the height of the bust's base, in its own unit

# The expression in which the ambient occlusion is baked: an open mouth lets
# light onto teeth and tongue.
BAKE = expression.both(mouth=expression.Mouth(
    width=0.30, corner_y=0.05, upper=0.06, lower=-0.04, jaw=18))

EASE_S, HOLD_S = 0.45, 0.65

# Keyframes of the clip "talk": seconds, and the targets with a weight above 0.
TALK = (
    (0.0, {}), (0.25, {"laugh": 0.35}), (0.4, {"kiss": 0.35}),
    (0.55, {"surprise": 0.35}), (0.7, {"smile": 0.3}),
    (0.85, {"laugh": 0.45}), (1.0, {"kiss": 0.25}),
    (1.15, {"surprise": 0.4}), (1.35, {"smile": 0.5}),
    (1.6, {"smile": 0.6}), (1.7, {"sleep": 0.97}), (1.8, {"smile": 0.2}),
    (1.95, {"surprise": 0.3}), (2.1, {"kiss": 0.5}),
    (2.25, {"laugh": 0.3}), (2.4, {"frown": 0.3}),
    (2.55, {"surprise": 0.25, "frown": 0.2}), (2.7, {"kiss": 0.2}),
    (2.9, {"laugh": 0.5}), (3.05, {"smile": 0.4}),
    (3.2, {"surprise": 0.45}), (3.4, {"smile": 0.8}), (3.75, {"smile": 0.8}),
    (3.85, {"sleep": 0.97}), (3.95, {"smile": 0.3}), (4.2, {}),
)


def to_blender(points):
    """Converts the bust's axes and unit to Blender's."""
    p = (points - np.array([0, FOOT, 0])) * SCALE
    return np.stack([p[:, 0], -p[:, 2], p[:, 1]], axis=1)


def make_object(bust):
    """The bust in the pose for the bake, coloured."""
    mesh = bpy.data.meshes.new("Face")
    mesh.from_pydata(to_blender(bust.points(BAKE)).tolist(), [], bust.face)
    mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
    mesh.materials.append(common.material("Face", roughness=0.7))
    mesh.update()
    common.set_colors(mesh, bust.color[common.corner_vertices(mesh)])
    return common.link(bpy.data.objects.new("Face", mesh))


def add_shape_keys(obj, bust):
    rest = to_blender(bust.points(expression.REST)).ravel()
    obj.data.vertices.foreach_set("co", rest)
    obj.data.update()
    obj.shape_key_add(name="Basis", from_mix=False)
    for name, what in expression.KEY_FRAMES.items():
        key = obj.shape_key_add(name=name, from_mix=False)
        key.data.foreach_set("co", to_blender(bust.points(what)).ravel())


def cycle():
    """All key frames one after another, from rest to rest, as rows like TALK."""
    rows, time = [(0.0, {})], 0.2
    rows.append((time, {}))
    for name in expression.KEY_FRAMES:
        rows.append((time + EASE_S, {name: 1.0}))
        rows.append((time + EASE_S + HOLD_S, {name: 1.0}))
        time += EASE_S + HOLD_S
    rows.append((time + EASE_S, {}))
    rows.append((time + EASE_S + 0.2, {}))
    return rows


def add_clip(obj, name, rows):
    """Adds an action of weights on its own NLA track."""
    keys = obj.data.shape_keys
    anim = keys.animation_data or keys.animation_data_create()
    action = bpy.data.actions.new(name)
    for key in keys.key_blocks[1:]:
        curve = action.fcurves.new(f'key_blocks["{key.name}"].value')
        for time, weights in rows:
            point = curve.keyframe_points.insert(
                time * common.FPS, weights.get(key.name, 0.0))
            point.handle_left_type = point.handle_right_type = "AUTO_CLAMPED"
        curve.update()
    track = anim.nla_tracks.new()
    track.name = name
    strip = track.strips.new(name, 0, action)
    strip.name = name


class Sparse(common.Tidy):
    """Writes morph targets as sparse accessors where that is smaller."""

    def primitive(self, prim, tangents_for):
        targets = prim.pop("targets")
        super().primitive(prim, tangents_for)
        prim["targets"] = [
            {name: self.sparse(index) for name, index in target.items()}
            for target in targets]

    def sparse(self, index):
        array = self.read(index).copy()
        array[np.abs(array).max(axis=1) < 2e-6] = 0
        rows = np.flatnonzero(array.any(axis=1))
        if not len(rows) or 14 * len(rows) >= 12 * len(array):
            return self.keep(index, array)
        acc = dict(self.json["accessors"][index])
        acc.pop("bufferView")
        acc.pop("byteOffset", None)
        if "min" in acc:
            acc["min"] = [float(v) for v in array.min(axis=0)]
            acc["max"] = [float(v) for v in array.max(axis=0)]
        acc["sparse"] = {
            "count": len(rows),
            "indices": {"componentType": 5123,
                        "bufferView": self.add_view(
                            rows.astype("<u2").tobytes())},
            "values": {"bufferView": self.add_view(array[rows].tobytes())},
        }
        self.accessors.append(acc)
        return len(self.accessors) - 1


def build(path):
    common.reset_scene()
    bust = Bust()
    obj = make_object(bust)
    common.bake_ao([obj], distance=0.06, samples=512, strength=0.75, rounds=2)
    add_shape_keys(obj, bust)
    add_clip(obj, "cycle", cycle())
    add_clip(obj, "talk", TALK)
    common.export_glb(path, tolerance=0.004)
    Sparse(path).write(path, tolerance=0.004)


common.run(build)
