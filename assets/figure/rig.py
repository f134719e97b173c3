"""The walker's bones and the skin weights.

Weights are functions of the rest position and of the marks of a piece. Shirt,
belt and trousers therefore move together where they touch.
"""

import bpy
import numpy as np
from mathutils import Vector

from .features import BALL as EYEBALL, BALL_FRONT
from .head import TAIL
from .mesh import smoothstep, unit

ARM_DROP = np.radians(42)  # rest pose: angle of the arms below the horizontal
ARM_BEND = np.radians(9)   # and of the forearm to the front

SHOULDER = np.array([0.150, 0.018, 1.372])
UPPER_ARM, FOREARM, PALM, FINGERS = 0.262, 0.232, 0.088, 0.080

ARM_UP = np.array([np.sin(ARM_DROP), 0, np.cos(ARM_DROP)])
ARM_DIR = np.array([np.cos(ARM_DROP), 0, -np.sin(ARM_DROP)])
FORE_DIR = ARM_DIR * np.cos(ARM_BEND) + np.array([0, -1, 0]) * np.sin(ARM_BEND)
ELBOW = SHOULDER + ARM_DIR * UPPER_ARM
WRIST = ELBOW + FORE_DIR * FOREARM
KNUCKLE = WRIST + FORE_DIR * PALM
FINGERTIP = KNUCKLE + FORE_DIR * FINGERS
FORE_SIDE = np.cross(ARM_UP, FORE_DIR)  # towards the little finger

HIP = np.array([0.090, 0.002, 0.925])
KNEE = np.array([0.094, -0.010, 0.492])
ANKLE = np.array([0.098, 0.014, 0.088])
BALL = np.array([0.106, -0.118, 0.030])
TOE = np.array([0.110, -0.195, 0.022])

# the head is modelled at life size, then enlarged and lowered
HEAD_SCALE, HEAD_DROP = 1.10, 0.020
HEAD_PIVOT = np.array([0, 0.012, 1.475])


def place_head(p):
    """Converts from the head's modelling space to the figure's."""
    p = np.asarray(p, dtype=float)
    return HEAD_PIVOT + (p - HEAD_PIVOT) * HEAD_SCALE - (0, 0, HEAD_DROP)


def unplace_head(p):
    return HEAD_PIVOT + (p + (0, 0, HEAD_DROP) - HEAD_PIVOT) / HEAD_SCALE


# bones: name, parent, head, tail; bone_table() mirrors those of LEFT
CENTRE = [
    ("hips", None, (0, 0.004, 0.950), (0, 0.004, 1.040)),
    ("spine", "hips", (0, 0.004, 1.040), (0, 0.012, 1.170)),
    ("chest", "spine", (0, 0.012, 1.170), (0, 0.022, 1.390)),
    ("neck", "chest", (0, 0.022, 1.395), (0, 0.010, 1.480)),
    ("head", "neck", (0, 0.010, 1.480), (0, 0.000, 1.740)),
] + [(f"ponytail.{i + 1}", f"ponytail.{i}" if i else "head",
      place_head(TAIL[i]), place_head(TAIL[i + 1])) for i in range(4)]
THUMB_ROOT = WRIST + FORE_DIR * 0.022 - FORE_SIDE * 0.026
THUMB_DIR = unit(FORE_DIR - 0.75 * FORE_SIDE - 0.10 * ARM_UP)
LEFT = [
    ("shoulder", "chest", (0.028, 0.014, 1.372), SHOULDER),
    ("upper_arm", "shoulder", SHOULDER, ELBOW),
    ("forearm", "upper_arm", ELBOW, WRIST),
    ("hand", "forearm", WRIST, KNUCKLE),
    ("fingers", "hand", KNUCKLE, FINGERTIP),
    ("thumb", "hand", THUMB_ROOT, THUMB_ROOT + THUMB_DIR * 0.062),
    ("thigh", "hips", HIP, KNEE),
    ("shin", "thigh", KNEE, ANKLE),
    ("foot", "shin", ANKLE, BALL),
    ("toe", "foot", BALL, TOE),
    ("eye", "head", place_head(EYEBALL), place_head(BALL_FRONT)),
]


def bone_table():
    """All bones as (name, parent, head, tail), parents first."""
    bones = [(n, p, np.array(h, float), np.array(t, float))
             for n, p, h, t in CENTRE]
    both = {n for n, *_ in LEFT}
    for suffix, sign in ((".L", 1), (".R", -1)):
        for name, parent, head, tail in LEFT:
            parent = parent + suffix if parent in both else parent
            flip = np.array([sign, 1, 1])
            bones.append((name + suffix, parent, np.array(head) * flip,
                          np.array(tail) * flip))
    return bones


def make_armature():
    """The armature object, in its rest pose."""
    data = bpy.data.armatures.new("walker")
    obj = bpy.data.objects.new("walker", data)
    bpy.context.scene.collection.objects.link(obj)
    bpy.context.view_layer.objects.active = obj
    bpy.ops.object.mode_set(mode="EDIT")
    for name, parent, head, tail in bone_table():
        bone = data.edit_bones.new(name)
        bone.head, bone.tail = Vector(head), Vector(tail)
        if parent:
            bone.parent = data.edit_bones[parent]
        if not name.startswith(("hips", "spine", "chest", "neck", "head",
                                "eye")):
            bone.align_roll(Vector((0, -1, 0)))
    bpy.ops.object.mode_set(mode="OBJECT")
    return obj


# --- weights ----------------------------------------------------------------


def blend(a, b, t):
    """Blends two weight dictionaries; t is the weight of b."""
    out = {}
    for part, share in ((a, 1 - t), (b, t)):
        for name, w in part.items():
            out[name] = out.get(name, 0) + w * share
    return out


def spine_weights(co):
    z = co[2]
    out = blend({"hips": 1}, {"spine": 1}, smoothstep(0.985, 1.10, z))
    out = blend(out, {"chest": 1}, smoothstep(1.10, 1.245, z))
    return blend(out, {"neck": 1}, 0.35 * smoothstep(1.405, 1.45, z))


def side_of(co):
    return ".L" if co[0] >= 0 else ".R"


def shirt_weights(co, marks):
    """Weights of torso and sleeves: spine, collar bone, upper arm."""
    side = side_of(co)
    p = np.array([abs(co[0]), co[1], co[2]])
    out = spine_weights(co)
    collar = (smoothstep(0.035, 0.125, p[0])
              * smoothstep(1.255, 1.375, p[2]) * 0.85)
    out = blend(out, {"shoulder" + side: 1}, collar)
    return blend(out, {"upper_arm" + side: 1}, marks.get("sleeve", 0))


def arm_weights(co, marks):
    side = side_of(co)
    p = np.array([abs(co[0]), co[1], co[2]])
    out = {"upper_arm" + side: 1}
    bend = (p - ELBOW) @ unit(ARM_DIR + FORE_DIR)
    out = blend(out, {"forearm" + side: 1}, smoothstep(-0.042, 0.042, bend))
    wrist = (p - WRIST) @ FORE_DIR
    out = blend(out, {"hand" + side: 1}, smoothstep(-0.022, 0.020, wrist))
    out = blend(out, {"fingers" + side: 1}, marks.get("fingers", 0))
    return blend(out, {"thumb" + side: 1}, marks.get("thumb", 0))


def leg_weights(co, marks):
    """Weights of the trousers: the hips, then each leg."""
    side = side_of(co)
    p = np.array([abs(co[0]), co[1], co[2]])
    out = spine_weights(co)
    # the back of the seat follows the thigh less than the front does
    line = p[2] + 0.25 * p[1]
    thigh = smoothstep(0.985, 0.815, line)
    other = 0.5 * smoothstep(0.030, 0.0, p[0])
    mix = blend({"thigh" + side: 1},
                {"thigh" + (".R" if side == ".L" else ".L"): 1}, other)
    out = blend(out, mix, thigh * (1 - 0.35 * smoothstep(0.05, 0.0, p[0])
                                   * smoothstep(0.80, 0.84, p[2])))
    bend = KNEE[2] - p[2]
    out = blend(out, {"shin" + side: 1}, smoothstep(-0.058, 0.058, bend))
    return out


def ankle_weights(co, marks):
    """Weights of a sock, from the shin into the shoe."""
    side = side_of(co)
    t = smoothstep(ANKLE[2] + 0.050, ANKLE[2] - 0.005, co[2])
    return blend({"shin" + side: 1}, {"foot" + side: 1}, t)


def shoe_weights(co, marks):
    side = side_of(co)
    t = smoothstep(BALL[1] + 0.030, BALL[1] - 0.024, co[1])
    return blend({"foot" + side: 1}, {"toe" + side: 1}, t)


def neck_weights(co, marks):
    out = blend({"chest": 1}, {"neck": 1}, smoothstep(1.385, 1.43, co[2]))
    return blend(out, {"head": 1}, smoothstep(1.445, 1.495, co[2]))


def head_weights(co, marks):
    return {"head": 1}


def eye_weights(co, marks):
    return {"eye" + side_of(co): 1}


def tail_weights(co, marks):
    """Weights of the ponytail by the position along its chain, 0 .. 4."""
    s = marks.get("along", 0) * 4
    out = {"head": 1}
    for i in range(4):
        low = i - 0.45
        out = blend(out, {f"ponytail.{i + 1}": 1},
                    smoothstep(low, low + 0.9, s))
    return out


def limited(weights, most=4, least=0.02):
    """At most four bones with weights that are not negligible and sum to 1."""
    top = sorted(weights.items(), key=lambda item: (-item[1], item[0]))[:most]
    top = [(n, w) for n, w in top if w >= least * top[0][1]]
    total = sum(w for _, w in top)
    return {n: w / total for n, w in top}
