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
from figure import body, clips, expression, head, rig
from figure.mesh import Piece, gauss, hidden_behind, smoothstep

COLORS = {
    "skin": "#f8c199", "lip": "#d07566", "upperlip": "#b35850",
    "rim": "#d99a80", "mouth": "#5a1a1a", "teeth": "#fbf6ea",
    "eyewhite": "#fbf7f2", "iris": "#3f7d6a", "pupil": "#17110f",
    "glint": "#ffffff", "lash": "#2b1812", "brow": "#5a2e1c",
    "hair": "#7b3a1e", "tie": "#e2583e",
    "trousers": "#3a4f86", "cuff": "#6f86b8", "sock": "#f4efe6",
    "sole": "#f6f1e7", "toecap": "#f6f1e7", "upper": "#e2583e",
    "tongue": "#f3dfc4", "heel": "#a93a2b", "lining": "#7a2d24",
    "lace": "#fffaf0", "brass": "#d9a441",
}
PLAIN, SHIRT, LEATHER = "plain", "shirt", "leather"
BAKED = "surprise"  # the pose of the bake, which lets light onto teeth and eyes
TEXTURED = {"shirt": SHIRT, "belt": LEATHER}


def shirt_texture():
    """Striped knitwear, 256 x 256 texels."""
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
    """Colours and normals of a stitched strap, 128 x 64 texels."""
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


def build_body():
    """All pieces but the head's, with the functions of their weights."""
    shirt, trousers = body.make_shirt(), body.make_trousers()
    belt = body.make_belt(shirt, trousers)
    pieces = [(shirt, rig.shirt_weights), (trousers, rig.leg_weights),
              (belt, rig.leg_weights),
              (body.make_buckle(belt), rig.leg_weights),
              (head.make_neck(), rig.neck_weights)]
    for make, weigh in ((body.make_arm, rig.arm_weights),
                        (body.make_sock, rig.ankle_weights),
                        (body.make_shoe, rig.shoe_weights)):
        pieces += [(p, weigh) for p in both(make())]
    return pieces


def build_head():
    """The pieces of the hair, which belongs to the body, and of the head."""
    skin = head.Surface(head.make_skull())
    cap = head.make_cap(skin)
    hair = [(cap, rig.head_weights)]
    hair += [(head.make_lock(skin, *lock), rig.head_weights)
             for lock in head.LOCKS]
    hair += [(head.make_tail(), rig.tail_weights),
             (head.make_tie(), rig.tail_weights)]
    face = expression.make_face() + both(head.make_ear())
    face = [(piece, rig.eye_weights if piece.region[0] == "eyewhite"
             else rig.head_weights) for piece in face]
    for piece, _ in hair + face:
        piece.move(rig.place_head)
    # pieces that can hide others for good, because they move with the head;
    # the ponytail cannot, because it swings
    solid = [p for p, weigh in hair + face if weigh != rig.tail_weights]
    hidden = hidden_behind(solid + [head.make_neck()])
    return trimmed(hair, hidden), trimmed(face, hidden)


def trimmed(pieces, hidden):
    """Removes the faces that never move and are never visible."""
    out = []
    for piece, weigh in pieces:
        moves = {tuple(co) for s in piece.shapes.values()
                 for co, to in zip(piece.co, s) if any(co != to)}
        if piece.region[0] in ("skin", "hair") and weigh == rig.head_weights:
            piece = piece.triangulated().without_faces(
                lambda points: not any(tuple(p) in moves for p in points)
                and hidden(points))
        out.append((piece, weigh))
    return out


def denim_fade(co):
    """How much lighter denim is where it wears, and darker along seams.

    Thighs and knees in front; the pockets, below them and the calves behind.
    """
    across, height = abs(co[0]), co[2]
    front = smoothstep(0.02, -0.05, co[1]) * gauss(across, 0.10, 0.05)
    k = front * (0.75 * gauss(height, 0.70, 0.13)
                 + 0.45 * gauss(height, 0.50, 0.06))
    back = smoothstep(0.02, 0.07, co[1])
    k += back * gauss(across, 0.085, 0.038) * (
        0.85 * gauss(height, 0.90, 0.045) + 0.45 * gauss(height, 0.70, 0.07)
        + 0.40 * gauss(height, 0.34, 0.09))
    k -= 0.35 * back * gauss(across, 0.0, 0.022) * smoothstep(
        0.78, 0.86, height)
    k -= 0.30 * back * gauss(height, 0.812, 0.016)
    return k


def vertex_tint(co, region, light, dark):
    """Linear factors for a region's colour: brightness and blush."""
    if dark:  # the line where the lips meet
        return np.ones(3) * 0.45
    if region == "hair":
        k = 0.72 + 0.62 * light
        return np.array([k, k, k])
    if region == "trousers":
        return 1 + denim_fade(co) * np.array([1.0, 0.95, 0.75])
    if region == "skin" and co[1] < 0 and co[2] > 1.47:
        co = rig.unplace_head(co)
        blush = 0.55 * gauss(abs(co[0]), 0.043, 0.016) * gauss(
            co[2], 1.545, 0.016)
        blush += 0.20 * gauss(co[0], 0, 0.010) * gauss(co[2], 1.549, 0.012)
        return 1 - blush * np.array([0.02, 0.34, 0.30])
    return np.ones(3)


def corner_colors(piece):
    out = []
    light, dark = (piece.marks.get(n, {}) for n in ("light", "dark"))
    flat = {r: common.to_linear(common.srgb(c)) for r, c in COLORS.items()}
    for face, region in zip(piece.faces, piece.region):
        base = flat.get(region, np.ones(3))
        for v in face:
            out.append(base * vertex_tint(piece.co[v], region,
                                          light.get(v, 0), v in dark))
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


def make_object(name, pieces, materials):
    """Makes one coloured mesh of pieces; the texture gives the material."""
    whole = Piece()
    colors = []
    for piece, _ in pieces:
        piece = piece.triangulated()
        colors.append(corner_colors(piece))
        piece.drop_uv(lambda region: region not in TEXTURED)
        whole.add(piece)
    mesh, _ = whole.to_mesh(name)
    order = [m.name for m in materials]
    for material in materials:
        mesh.materials.append(material)
    slot = [order.index(TEXTURED.get(r, PLAIN)) for r in whole.region]
    mesh.polygons.foreach_set("material_index", slot)
    mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
    common.set_colors(mesh, np.concatenate(colors))
    mesh.validate()
    return common.link(bpy.data.objects.new(name, mesh)), whole


def set_points(obj, points):
    obj.data.vertices.foreach_set("co", np.array(points).ravel())
    obj.data.update()


def add_shapes(obj, whole):
    """The morph targets as shape keys."""
    set_points(obj, whole.co)
    obj.shape_key_add(name="Basis", from_mix=False)
    for name, points in whole.shapes.items():
        key = obj.shape_key_add(name=name, from_mix=False)
        key.data.foreach_set("co", np.array(points).ravel())


def make_materials():
    color, normals = leather_textures()
    return [common.material(PLAIN),
            common.material(SHIRT,
                            texture=common.image("knit", shirt_texture())),
            common.material(LEATHER, texture=common.image("leather", color),
                            normals=common.image("leather_normals", normals,
                                                 data=True),
                            roughness=0.5)]


def smooth_normals(co, corners, place):
    """Normals that corners at one position share, weighted by angle."""
    total = np.zeros((place.max() + 1, 3))
    edge = np.roll(co[corners], -1, axis=1) - co[corners]
    edge /= np.maximum(np.linalg.norm(edge, axis=2), 1e-12)[..., None]
    flat = np.cross(edge[:, 0], edge[:, 1])
    flat /= np.maximum(np.linalg.norm(flat, axis=1), 1e-12)[:, None]
    for k in range(3):
        cosine = -(edge[:, k] * edge[:, k - 1]).sum(axis=1)
        angle = np.arccos(np.clip(cosine, -1, 1))
        np.add.at(total, place[corners[:, k]], flat * angle[:, None])
    total /= np.maximum(np.linalg.norm(total, axis=1), 1e-12)[:, None]
    return total[place]


class Morphs(common.Tidy):
    """Recomputes the normals of morph targets.

    Blender's differ in the last bit from run to run. These are reproducible,
    and 0 where no vertex moves. Other normals only lose the sign of zero,
    which also differs from run to run.
    """

    def __init__(self, path):
        super().__init__(path)
        self.fresh = {}

    def read(self, index):
        return self.fresh[index] if index in self.fresh else super().read(
            index)

    def primitive(self, prim, tangents_for):
        normal = prim["attributes"]["NORMAL"]
        self.fresh[normal] = self.read(normal) + np.float32(0)
        targets = prim.get("targets", [])
        if targets:
            co = self.read(prim["attributes"]["POSITION"]).astype(float)
            corners = self.read(prim["indices"]).reshape(-1, 3)
            moves = [self.read(t["POSITION"]) for t in targets]
            _, place = np.unique(np.hstack([co, *moves]), axis=0,
                                 return_inverse=True)
            rest = smooth_normals(co, corners, place)
            for target, move in zip(targets, moves):
                turn = smooth_normals(co + move, corners, place) - rest
                self.fresh[target["NORMAL"]] = (
                    np.round(turn * 4096) / 4096 + 0.0).astype("f4")
        super().primitive(prim, tangents_for)


def build(path):
    common.reset_scene()
    hair, face = build_head()
    dressed = build_body() + hair
    materials = make_materials()
    body_object, _ = make_object("walker_body", dressed, materials)
    head_object, whole = make_object("walker_head", face, materials[:1])
    set_points(head_object, whole.shapes[BAKED])
    common.bake_ao([body_object, head_object], distance=0.22, strength=0.8,
                   samples=int(os.environ.get("AO", 192)))
    add_shapes(head_object, whole)
    armature = rig.make_armature()
    for obj, pieces in ((body_object, dressed), (head_object, face)):
        weigh_vertices(obj, pieces)
        obj.parent = armature
        obj.modifiers.new("armature", "ARMATURE").object = armature
    clips.add_clips(armature)
    clips.add_faces(head_object)
    common.export_glb(path, tangents_for=(LEATHER,))
    Morphs(path).write(path, tangents_for=(LEATHER,))


common.run(build)
