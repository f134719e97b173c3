#!/usr/bin/env python3
"""Writes models as users have them, to measure what their frames cost.

    user_models.py FOLDER

box is 12 triangles with a texture, duck 4,000 with one, duck-two-sided the same
without culling, colors has a colour at each vertex besides, cards are quads in
all alpha modes, and layers are six blended quads behind each other. banner has
long strips in perspective, glass a blended sphere, leaves one with an alpha test.
shells are three spheres in each other: opaque, tested and blended. stone is a sphere
without texture, crate a cube without. facets have no normals, panes are blended quads
that stand askew, and rope is thin and long, of small triangles. blocks are many
small boxes of uneven scale, prism is a blended box without a texture around a ball,
signs are large, textured and unlit, and bush is 150 small alpha-tested cards. gem has
a texture and no normals; so has worm, which joints bend in its clip, and mosaic has
a texture, a colour at each vertex and no normals. Most of tail, a worm, never moves, and
snake is a dense worm with normals. hair is thin blended strips around
a ball, rags are a sphere of which the alpha test leaves little, dice are 500 small
textured cubes, and shapes is a head of 52 targets. net is blended, thin and long;
tiles are small squares of a texture each, mirrors, poster and bricks repeat a texture
mirrored, clamped and with sides of no power of two. blocky has no filter, paper is a
flat sphere, beads are 600 plain cubes, petals have colours with alpha, lamp shines, and
tower has lit windows. shoal is 150 nodes that show four meshes, and the texture of
yard's 60 boxes repeats three times on each side. tube and drums show a small texture
large from outside and inside, by 672 triangles and by few. mast is a thin pole,
pipe a thin tube that lies, plate a flat box and speck a dense ball seen from afar, so
that the floor is most of the picture. bird has thin wings, and 60 vanes turn. parasol
is a cone of one texture, house has lit windows, and sail is a quad without normals.
moving_models.py makes those that have clips.
"""
import math
import pathlib
import sys

from glb import Model, checks, discs, png, windows
from moving_models import (
    make_bird, make_mast, make_pipe, make_shapes, make_snake, make_tail, make_vanes, make_worm)
from shapes import blob, cube, grid, quad, rope, sized, strips, tube

MIRRORED, CLAMPED = 33648, 33071


def make_box(model):
    model.mesh(model.material(model.texture(png(256, checks(256), 3))), cube())


def make_duck(model, **more):
    model.mesh(model.material(model.texture(png(512, checks(512), 3)), **more), blob(64, 32))


def make_two_sided_duck(model):
    make_duck(model, doubleSided=True)


def make_colors(model):
    shape = blob(32, 16)
    colors = [(*(int(127 + 127 * c) for c in normal), 255) for normal in shape[1]]
    model.mesh(model.material(model.texture(png(256, checks(256), 3))), shape, colors)


def make_cards(model):
    texture = model.texture(png(256, discs(256), 4))
    materials = [
        model.material(texture, alphaMode="BLEND", doubleSided=True),
        model.material(texture, alphaMode="MASK", doubleSided=True),
        model.material(texture),
        model.material(color=(0.2, 0.7, 0.3, 0.5), alphaMode="BLEND"),
    ]
    for k in range(12):
        at = (k % 3 * 1.05, k // 3 * 1.05, k % 5 * 0.1)
        model.mesh(materials[k % 4], quad(0.5, 0.5), translation=at)


def make_layers(model):
    texture = model.texture(png(256, discs(256), 4))
    material = model.material(texture, alphaMode="BLEND", doubleSided=True)
    for k in range(6):
        model.mesh(material, quad(0.75, 1), translation=(0, 0, k * 0.1))


def make_banner(model):
    texture = model.texture(png(256, checks(256), 3))
    model.mesh(model.material(texture, doubleSided=True), strips(16))


def make_glass(model):
    material = model.material(color=(0.3, 0.6, 0.9, 0.5), alphaMode="BLEND")
    model.mesh(material, blob(24, 12))


def make_leaves(model):
    texture = model.texture(png(256, discs(256), 4))
    model.mesh(model.material(texture, alphaMode="MASK", doubleSided=True), blob(32, 16))


def make_shells(model):
    texture = model.texture(png(128, discs(128), 4))
    opaque = model.material(model.texture(png(128, checks(128), 3)))
    model.mesh(opaque, blob(24, 30, 0.6))
    tested = model.material(texture, alphaMode="MASK", doubleSided=True)
    model.mesh(tested, blob(20, 20, 0.8))
    blended = model.material(texture, alphaMode="BLEND", doubleSided=True)
    model.mesh(blended, blob(16, 16))


def make_stone(model):
    model.mesh(model.material(color=(0.8, 0.5, 0.4, 1)), blob(28, 28))


def make_crate(model):
    model.mesh(model.material(color=(0.3, 0.7, 0.4, 1)), cube())


def make_facets(model):
    positions, _, texcoords, indices = blob(26, 22)
    model.mesh(model.material(color=(0.5, 0.6, 0.8, 1)), (positions, None, texcoords, indices))


def make_gem(model):
    positions, _, texcoords, indices = blob(40, 30)
    material = model.material(model.texture(png(128, checks(128), 3)), color=(1, 0.8, 0.7, 1))
    model.mesh(material, (positions, None, texcoords, indices))


def make_mosaic(model):
    positions, _, texcoords, indices = blob(32, 26)
    colors = [(40 * k % 256, 90, 25 * k % 256, 255) for k in range(len(positions))]
    material = model.material(model.texture(png(128, checks(128), 3)))
    model.mesh(material, (positions, None, texcoords, indices), colors)


def make_panes(model):
    texture = model.texture(png(256, discs(256), 4))
    material = model.material(texture, alphaMode="BLEND", doubleSided=True)
    for k in range(4):
        turn = (0, math.sin(0.3 + 0.2 * k), 0, math.cos(0.3 + 0.2 * k))
        model.mesh(material, quad(0.7, 0.9), rotation=turn, translation=(0, 0, k * 0.2))


def make_rope(model):
    model.mesh(model.material(model.texture(png(128, checks(128), 3))), rope(20, 160))


def make_blocks(model):
    materials = [model.material(model.texture(png(64, checks(64), 3)), color=(1, k / 5, 0.6, 1))
                 for k in range(4)]  # fmt: skip
    for k in range(40):
        place = {"translation": (k % 7 * 0.7 - 2, 0, k // 7 * 0.7 - 2)}
        model.mesh(materials[k % 4], cube(), scale=(0.25, 0.2 + k % 5 * 0.2, 0.2), **place)


def make_prism(model):
    glass = model.material(color=(0.5, 0.8, 0.9, 0.4), alphaMode="BLEND", doubleSided=True)
    model.mesh(glass, cube(), rotation=(0.2, 0.3, 0.1, 0.927))
    model.mesh(model.material(color=(0.9, 0.3, 0.2, 1)), blob(18, 10, 0.5))


def make_signs(model):
    unlit = {"KHR_materials_unlit": {}}
    model.json["extensionsUsed"] = list(unlit)
    material = model.material(model.texture(png(256, checks(256), 3)), extensions=unlit)
    for k in range(3):
        turn = (0, math.sin(0.2 * k), 0, math.cos(0.2 * k))
        model.mesh(material, quad(1.1, 0.4), translation=(0.1 * k, k, -0.5 * k), rotation=turn)


def make_bush(model):
    texture = model.texture(png(128, discs(128), 4))
    shape = positions, normals, texcoords, indices = [], [], [], []
    for k in range(150):
        x, y, z = (math.sin(k * c) for c in (1.3, 2.7, 4.1))
        a, first = k * 0.7, len(positions)
        for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            positions.append((x + 0.15 * u * math.cos(a), y + 0.15 * v, z + 0.15 * u * math.sin(a)))
            normals.append((math.sin(a), 0, -math.cos(a)))
            texcoords.append(((u + 1) / 2, (1 - v) / 2))
        indices += [first + i for i in (0, 1, 2, 0, 2, 3)]
    model.mesh(model.material(texture, alphaMode="MASK", doubleSided=True), shape)


def make_hair(model):
    texture = model.texture(png(128, discs(128), 4))
    material = model.material(texture, alphaMode="BLEND", doubleSided=True)
    shape = positions, normals, texcoords, indices = [], [], [], []
    for k in range(200):
        x, z = math.cos(0.31 * k), math.sin(0.31 * k)
        fall = 0.3 * abs(math.sin(1.7 * k))
        for s in range(5):
            for side in (-1, 1):
                out, across = 0.5 + 0.05 * s, 0.04 * side
                positions.append((x * out + z * across, 0.6 - s * fall, z * out - x * across))
                normals.append((x, 0, z))
                texcoords.append(((side + 1) / 2, s / 4))
        first = 10 * k
        for s in range(first, first + 8, 2):
            indices += [s, s + 1, s + 3, s, s + 3, s + 2]
    model.mesh(model.material(color=(0.8, 0.6, 0.5, 1)), blob(16, 10, 0.45))
    model.mesh(material, shape)


def make_rags(model):
    texture = model.texture(png(128, discs(128), 4))
    more = {"alphaMode": "MASK", "alphaCutoff": 0.99, "doubleSided": True}
    thin = model.material(texture, color=(1, 1, 1, 0.995), **more)
    model.mesh(thin, blob(24, 16))
    gone = model.material(texture, color=(1, 1, 1, 0.9), **more)
    model.mesh(gone, blob(20, 12, 0.8))


def make_dice(model):
    material = model.material(model.texture(png(64, checks(64), 3)))
    for k in range(500):
        x, y, z = k % 8, k // 8 % 8, k // 64
        turn = (0, math.sin(k), 0, math.cos(k))
        model.mesh(material, cube(), scale=(0.2, 0.2, 0.2), translation=(x, y, z), rotation=turn)


def make_net(model):
    texture = model.texture(png(64, checks(64), 3))
    glassy = model.material(texture, color=(1, 1, 1, 0.5), alphaMode="BLEND")
    model.mesh(glassy, rope(12, 60))


def make_tiles(model):
    texture = model.texture(png(256, checks(256), 3))
    model.mesh(model.material(texture), grid(20, 20), rotation=(-0.5, 0, 0, 0.866))


def make_mirrors(model):
    texture = model.texture(png(64, checks(64), 3), wrapS=MIRRORED, wrapT=MIRRORED)
    model.mesh(model.material(texture), grid(6, 4))


def make_poster(model):
    texture = model.texture(png(64, checks(64), 3), wrapS=CLAMPED, wrapT=CLAMPED)
    model.mesh(model.material(texture), grid(6, 4))


def make_bricks(model):
    texture = model.texture(png(100, checks(100), 3))
    model.mesh(model.material(texture), grid(12, 2))


def make_blocky(model):
    texture = model.texture(png(512, checks(512), 3), magFilter=9728, minFilter=9728)
    model.mesh(model.material(texture), blob(30, 20))


def make_paper(model):
    shape = blob(30, 20)
    flat = [(x, y, z * 0.0005) for x, y, z in shape[0]]
    model.mesh(model.material(color=(0.8, 0.4, 0.2, 1)), (flat, *shape[1:]))


def make_beads(model):
    materials = [model.material(color=(k / 8, 0.5, 1 - k / 8, 1)) for k in range(8)]
    for k in range(600):
        at = k % 9, k // 9 % 9, k // 81
        model.mesh(materials[k % 8], cube(), scale=(0.3, 0.3, 0.3), translation=at)


def make_petals(model):
    shape = blob(24, 16)
    colors = [(255, 40 * k % 256, 25 * k % 256, 13 * k % 256) for k in range(len(shape[0]))]
    model.mesh(model.material(alphaMode="BLEND", doubleSided=True), shape, colors)


def make_lamp(model):
    texture = model.texture(png(256, checks(256), 3))
    model.mesh(model.material(texture, emissiveFactor=(0.4, 0.2, 0)), blob(40, 24))


def make_shoal(model):
    positions, normals, *rest = blob(10, 6, 0.2)
    shape = [(2 * x, 0.7 * y, 0.5 * z) for x, y, z in positions], normals, *rest
    shown = []
    for k in range(150):
        x, y, z = (1.5 * math.sin(k * c) for c in (1.3, 2.7, 4.1))
        place = {"translation": (x, y, z), "rotation": (0, math.sin(k), 0, math.cos(k))}
        if k < 4:
            shown.append(model.mesh(model.material(color=(k / 4, 0.5, 0.8, 1)), shape, **place))
        else:
            model.show(shown[k % 4], **place)


def make_yard(model):
    positions, normals, texcoords, indices = cube()
    shape = positions, normals, [(3 * s, 3 * t) for s, t in texcoords], indices
    for k in range(60):
        texture = model.texture(png(128, checks(128), 3)) if k % 15 == 0 else texture
        size = [0.2 + (k * c % 10) / 10 for c in (3, 7, 1)]
        at = (8 * math.sin(1.3 * k), size[1], 8 * math.sin(2.7 * k))
        model.mesh(model.material(texture), shape, scale=size, translation=at)


def make_tower(model):
    lit = {"index": model.texture(png(512, windows(512), 3))}
    make_duck(model, emissiveTexture=lit, emissiveFactor=(1, 1, 1))


def make_tube(model):
    texture = model.texture(png(32, checks(32), 3))
    model.mesh(model.material(texture, doubleSided=True), tube(14, 24))


def make_drums(model):
    texture = model.texture(png(32, checks(32), 3))
    material = model.material(texture, doubleSided=True)
    for k in range(4):
        turn = (0, 0, math.sin(0.2 * k), math.cos(0.2 * k))
        place = (k - 1.5, 2.2 * k, 0.3 * k)
        model.mesh(material, tube(8, 1), rotation=turn, translation=place, scale=(1, 0.4, 1))


def make_plate(model):
    model.mesh(model.material(color=(0.8, 0.6, 0.4, 1)), sized(cube(), 5, 0.05, 5))


def make_speck(model):
    material = model.material(color=(0.6, 0.6, 0.2, 1))
    model.mesh(material, blob(96, 48))
    model.mesh(material, sized(cube(), 0.3, 0.3, 0.3), translation=(40, 0, 0))


def make_parasol(model):
    count = 90
    rim = [(math.cos(2 * math.pi * k / count), math.sin(2 * math.pi * k / count)) for k in range(count)]
    positions = [(0, 0.2, 0)] + [(x, 0, z) for x, z in rim]
    texcoords = [(0.5, 0.5)] + [(0.5 + x / 2, 0.5 + z / 2) for x, z in rim]
    indices = [i for k in range(count) for i in (0, 1 + (k + 1) % count, 1 + k)]
    shape = positions, [(0, 1, 0)] * (count + 1), texcoords, indices
    texture = model.texture(png(128, checks(128), 3))
    turn = (math.sin(0.6), 0, 0, math.cos(0.6))
    model.mesh(model.material(texture, doubleSided=True), shape, rotation=turn)


def make_house(model):
    lit = {"index": model.texture(png(256, windows(256), 3))}
    material = model.material(color=(0.5, 0.3, 0.2, 1), emissiveTexture=lit, emissiveFactor=(0.8, 1, 0.6))
    model.mesh(material, sized(cube(), 1.4, 1, 0.9), rotation=(0, 0.3, 0, 0.954))


def make_sail(model):
    positions, _, texcoords, indices = quad(0.6, 1)
    model.mesh(model.material(color=(0.9, 0.85, 0.7, 1), doubleSided=True), (positions, None, texcoords, indices))


MODELS = {
    "box": make_box,
    "duck": make_duck,
    "duck-two-sided": make_two_sided_duck,
    "colors": make_colors,
    "cards": make_cards,
    "layers": make_layers,
    "banner": make_banner,
    "glass": make_glass,
    "leaves": make_leaves,
    "shells": make_shells,
    "stone": make_stone,
    "crate": make_crate,
    "facets": make_facets,
    "panes": make_panes,
    "rope": make_rope,
    "blocks": make_blocks,
    "prism": make_prism,
    "signs": make_signs,
    "bush": make_bush,
    "gem": make_gem,
    "mosaic": make_mosaic,
    "worm": make_worm,
    "tail": make_tail,
    "snake": make_snake,
    "shapes": make_shapes,
    "hair": make_hair,
    "rags": make_rags,
    "dice": make_dice,
    "net": make_net,
    "tiles": make_tiles,
    "mirrors": make_mirrors,
    "poster": make_poster,
    "bricks": make_bricks,
    "blocky": make_blocky,
    "paper": make_paper,
    "beads": make_beads,
    "petals": make_petals,
    "lamp": make_lamp,
    "shoal": make_shoal,
    "yard": make_yard,
    "tower": make_tower,
    "tube": make_tube,
    "drums": make_drums,
    "mast": make_mast,
    "pipe": make_pipe,
    "plate": make_plate,
    "speck": make_speck,
    "bird": make_bird,
    "vanes": make_vanes,
    "parasol": make_parasol,
    "house": make_house,
    "sail": make_sail,
}


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, make in MODELS.items():
        model = Model()
        make(model)
        model.save(folder / f"{name}.glb")


main()
