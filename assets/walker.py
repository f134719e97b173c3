"""The walker: a skinned figure with five clips.

    blender -b --factory-startup -P assets/walker.py -- assets/walker.glb
"""

import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import bpy
import numpy as np

import common
from figure import body, clips, head, rig
from figure.mesh import Piece, gauss, smoothstep

COLORS = {
    "skin": "#f8c199", "lip": "#d07566", "upperlip": "#b35850",
    "eyewhite": "#fbf7f2", "iris": "#3f7d6a", "pupil": "#17110f",
    "glint": "#ffffff", "lash": "#2b1812", "brow": "#5a2e1c",
    "hair": "#7b3a1e", "tie": "#e2583e",
    "trousers": "#2f3f6b", "cuff": "#6f86b8", "sock": "#f4efe6",
    "sole": "#f6f1e7", "toecap": "#f6f1e7", "upper": "#e2583e",
    "tongue": "#f3dfc4", "heel": "#a93a2b", "lining": "#7a2d24",
    "lace": "#fffaf0", "brass": "#d9a441",
}
SHIRT, LEATHER = "shirt", "leather"
TEXTURED = {"shirt": SHIRT, "belt": LEATHER}


def shirt_texture():
    """256 x 256 texels of striped knitwear."""
    size = 256
    y, x = np.mgrid[0:size, 0:size]
    base = np.array(common.srgb("#1d8a8a"))
    cream = np.array(common.srgb("#f6ead0"))
    band = (y % 64) / 64
    stripe = ((band > 0.50) & (band < 0.82)).astype(float)
    stripe = (stripe + np.roll(stripe, 1, 0)) / 2
    out = base + (cream - base) * stripe[..., None]
    knit = 0.5 + 0.5 * np.sin((x * 2 + np.abs((y % 8) - 4) * 2) * np.pi / 8)
    knit = 0.90 + 0.10 * knit * (0.7 + 0.3 * ((y // 4) % 2))
    return np.clip(out * knit[..., None], 0, 1)


def leather_textures():
    """128 x 64 texels of a stitched strap: colours and normals."""
    h, w = 64, 128
    y, x = np.mgrid[0:h, 0:w]
    grain = np.random.RandomState(1).rand(h, w)
    for _ in range(2):
        grain = (grain + np.roll(grain, 1, 0) + np.roll(grain, 1, 1)
                 + np.roll(grain, -1, 1)) / 4
    across = np.minimum(y, h - 1 - y)
    seam, stitch = np.abs(across - 10), np.abs(x % 16 - 5)
    thread = (seam < 2) & (stitch < 5)
    out = (np.array(common.srgb("#a5622f"))
           * (0.86 + 0.5 * (grain - 0.5))[..., None])
    out[thread] = np.array(common.srgb("#f0cf96"))
    out[across < 4] *= 0.62
    height = 0.25 * grain + 0.5 * gauss(across, 14, 5) - 0.3 * gauss(
        seam, 0, 2.5)
    height = height + 0.5 * gauss(seam, 0, 1.5) * (stitch < 5)
    height -= 0.8 * gauss(across, 0, 3)
    return np.clip(out, 0, 1), common.normal_map(height, 4.0)


def both(piece):
    return [piece, piece.mirrored()]


def build_pieces():
    """Every piece with the function that weighs its vertices."""
    shirt, trousers = body.make_shirt(), body.make_trousers()
    belt = body.make_belt(shirt, trousers)
    skull = head.make_skull()
    skin = head.Surface(skull)
    eye = head.make_eye(skin)
    pieces = [(shirt, rig.shirt_weights), (trousers, rig.leg_weights),
              (belt, rig.leg_weights),
              (body.make_buckle(belt), rig.leg_weights),
              (head.make_neck(), rig.neck_weights)]
    for make, weigh in ((body.make_arm, rig.arm_weights),
                        (body.make_sock, rig.ankle_weights),
                        (body.make_shoe, rig.shoe_weights)):
        pieces += [(p, weigh) for p in both(make())]
    cap = head.make_cap(skin)
    face = [head.bare_skin(skull, cap), head.make_mouth(skin), cap]
    for piece in (eye, head.make_brow(skin), head.make_ear()):
        face += both(piece)
    for side, it in zip((1, -1), both(eye)):
        face.append(head.drop_on(head.make_glint(side), it, 0.0012))
    face += [head.make_lock(skin, *lock) for lock in head.LOCKS]
    face = [(p, rig.head_weights) for p in face]
    face += [(p, rig.tail_weights) for p in (head.make_tail(),
                                             head.make_tie())]
    for piece, _ in face:
        piece.move(rig.place_head)
    pieces += face
    return [(piece.triangulated(), weigh) for piece, weigh in pieces]


def vertex_tint(co, region, light):
    """Brightness and blush on top of a region's colour, linear factors."""
    if region == "hair":
        k = 0.72 + 0.62 * light
        return np.array([k, k, k])
    if region == "trousers":  # worn pale in front, on thighs and knees
        front = smoothstep(0.02, -0.05, co[1]) * gauss(abs(co[0]), 0.10, 0.05)
        k = front * (0.75 * gauss(co[2], 0.70, 0.13)
                     + 0.45 * gauss(co[2], 0.50, 0.06))
        return 1 + k * np.array([1.0, 0.95, 0.75])
    if region == "skin" and co[1] < 0 and co[2] > 1.47:
        co = rig.unplace_head(co)
        blush = 0.55 * gauss(abs(co[0]), 0.043, 0.016) * gauss(
            co[2], 1.545, 0.016)
        blush += 0.20 * gauss(co[0], 0, 0.010) * gauss(co[2], 1.549, 0.012)
        return 1 - blush * np.array([0.02, 0.34, 0.30])
    return np.ones(3)


def corner_colors(piece):
    out = []
    light = piece.marks.get("light", {})
    flat = {r: common.to_linear(common.srgb(c)) for r, c in COLORS.items()}
    for face, region in zip(piece.faces, piece.region):
        base = flat.get(region, np.ones(3))
        for v in face:
            out.append(base * vertex_tint(piece.co[v], region,
                                          light.get(v, 0)))
    return common.to_srgb(out)


def weigh_vertices(obj, pieces):
    groups = {n: obj.vertex_groups.new(name=n)
              for n, *_ in rig.bone_table()}
    base = 0
    for piece, weigh in pieces:
        for v, co in enumerate(piece.co):
            marks = {n: m[v] for n, m in piece.marks.items() if v in m}
            for name, w in rig.limited(weigh(co, marks)).items():
                groups[name].add([base + v], w, "REPLACE")
        base += len(piece.co)


def make_body(pieces):
    """One mesh out of all pieces, coloured, with its materials."""
    whole = Piece()
    colors = []
    for piece, _ in pieces:
        colors.append(corner_colors(piece))
        piece.drop_uv(lambda region: region not in TEXTURED)
        whole.add(piece)
    mesh, names = whole.to_mesh("walker_body")
    order = ["plain", SHIRT, LEATHER]
    mesh.materials.append(common.material("plain"))
    mesh.materials.append(common.material(
        SHIRT, texture=common.image("knit", shirt_texture())))
    color, normals = leather_textures()
    mesh.materials.append(common.material(
        LEATHER, texture=common.image("leather", color),
        normals=common.image("leather_normals", normals, data=True),
        roughness=0.5))
    slot = [order.index(TEXTURED.get(r, "plain")) for r in whole.region]
    mesh.polygons.foreach_set("material_index", slot)
    mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
    common.set_colors(mesh, np.concatenate(colors))
    mesh.validate()
    obj = bpy.data.objects.new("walker_body", mesh)
    return common.link(obj)


def build(path):
    common.reset_scene()
    pieces = build_pieces()
    obj = make_body(pieces)
    common.bake_ao([obj], distance=0.22, strength=0.8, samples=int(
        os.environ.get("AO", 192)))
    armature = rig.make_armature()
    weigh_vertices(obj, pieces)
    obj.parent = armature
    obj.modifiers.new("armature", "ARMATURE").object = armature
    clips.add_clips(armature)
    common.export_glb(path, tangents_for=(LEATHER,))


common.run(build)
