#!/usr/bin/env python3
"""uneven_normals.py MODEL.gltf: writes a model whose normals are easy to tell.

Tetrahedrons with a normal a face, below nodes that scale unevenly, shear and
mirror: each with a node of its own, and skinned by such nodes, one a
tetrahedron. In any pose a vertex's normal is the normal of its own triangle.

uneven_normals.py --check FILE: reads "v" and "vn" lines, three a triangle and
four triangles a tetrahedron, and says whether each normal is its triangle's,
pointing out of the tetrahedron.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                "../fixtures/gltf"))
import writer

CORNERS = ((1, 1, 1), (-1, -1, 1), (-1, 1, -1), (1, -1, -1))
FACES = ((0, 1, 3), (0, 2, 1), (0, 3, 2), (1, 2, 3))
TURN = {"rotation": [0.36, 0.48, 0.64, 0.48]}
SHAPES = ({"scale": [1, 3, 0.5], **TURN}, {"scale": [-1, 2, 2], **TURN},
          {"scale": [1e-3, 1e-3, 2e-3]}, {"scale": [0.7, 0.7, 0.7]})


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    size = dot(a, a) ** 0.5
    return [x / size for x in a]


def faces():
    """The positions and normals of a tetrahedron's twelve vertices."""
    positions, normals = [], []
    for face in FACES:
        corners = [CORNERS[i] for i in face]
        positions += corners
        normals += 3 * [unit([sum(axis) for axis in zip(*corners)])]
    return positions, normals


def write(path):
    file = writer.File(scene=0)
    positions, normals = faces()
    count = len(positions)
    plain = {"POSITION": file.floats("VEC3", positions),
             "NORMAL": file.floats("VEC3", normals)}
    skinned = {"POSITION": file.floats("VEC3", len(SHAPES) * positions),
               "NORMAL": file.floats("VEC3", len(SHAPES) * normals),
               "JOINTS_0": file.accessor("VEC4", writer.U8, [
                   [joint, 0, 0, 0] for joint in range(len(SHAPES))
                   for _ in range(count)]),
               "WEIGHTS_0": file.floats(
                   "VEC4", [[1, 0, 0, 0]] * (count * len(SHAPES)))}
    mesh = file.mesh({"attributes": plain})
    file.mesh({"attributes": skinned})
    for shape in SHAPES:
        file.node(mesh=mesh, **shape)
    top = file.node(scale=[2, 1, 1], children=list(range(len(SHAPES))), **TURN)
    skin = file.add("skins", joints=list(range(len(SHAPES))))
    body = file.node(mesh=mesh + 1, skin=skin)
    file.add("scenes", nodes=[top, body])
    file.clip([(0, "scale", file.floats("SCALAR", [0, 1]),
                file.floats("VEC3", [[1, 3, 0.5], [3, 1, 1]]))])
    file.write(os.path.abspath(path))


def check(path):
    with open(path) as lines:
        words = [line.split() for line in lines]
    positions, normals = ([[float(word) for word in line[1:]] for line in words
                           if line[0] == kind] for kind in ("v", "vn"))
    assert len(positions) == len(normals) == 12 * 2 * len(SHAPES)
    for first in range(0, len(positions), 12):
        points = positions[first:first + 12]
        middle = [sum(axis) / 12 for axis in zip(*points)]
        for at in range(0, 12, 3):
            a, b, c = points[at:at + 3]
            wanted = unit(cross(sub(b, a), sub(c, a)))
            if dot(wanted, sub(a, middle)) < 0:
                wanted = [-x for x in wanted]
            for normal in normals[first + at:first + at + 3]:
                assert dot(unit(normal), wanted) > 0.9999, (first + at, normal, wanted)


if sys.argv[1] == "--check":
    check(sys.argv[2])
else:
    write(sys.argv[1])
