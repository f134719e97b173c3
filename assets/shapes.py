"""Shapes of a rigid machine: pairs of vertices and outward faces.

Lengths are metres in glTF's axes.
"""

import math

from mathutils import Vector
from mathutils.bvhtree import BVHTree
import numpy as np


def turn(axis, degrees):
    """A rotation matrix about 'x', 'y' or 'z'."""
    a = math.radians(degrees)
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    m = np.eye(3)
    m[i, i] = m[j, j] = math.cos(a)
    m[i, j], m[j, i] = -math.sin(a), math.sin(a)
    return m


def place(shape, rotation=None, offset=(0, 0, 0)):
    """A copy of a shape, rotated, then moved."""
    points, faces = shape
    if rotation is not None:
        points = points @ rotation.T
    return points + np.asarray(offset, dtype=float), faces


def mirror(shape):
    """A copy of a shape, mirrored at x = 0."""
    points, faces = shape
    return points * (-1, 1, 1), faces


def lathe(profile, sides, axis="y"):
    """Revolves a profile of (radius, height) about an axis; closes both ends."""
    points, faces, rings = [], [], []
    for radius, height in profile:
        if radius < 1e-6:
            rings.append([len(points)] * sides)
            points.append((0, height, 0))
            continue
        rings.append(range(len(points), len(points) + sides))
        for k in range(sides):
            a = 2 * math.pi * (k + 0.5) / sides
            points.append((radius * math.sin(a), height, radius * math.cos(a)))
    for low, high in zip(rings, rings[1:]):
        for k in range(sides):
            n = (k + 1) % sides
            quad = [low[k], low[n], high[n], high[k]]
            faces.append(list(dict.fromkeys(quad)))
    if profile[0][0] >= 1e-6:
        faces.append(list(rings[0])[::-1])
    if profile[-1][0] >= 1e-6:
        faces.append(list(rings[-1]))
    shape = np.array(points, dtype=float), faces
    if axis == "x":
        shape = place(shape, turn("z", -90))
    if axis == "z":
        shape = place(shape, turn("x", 90))
    return shape


def outward(shape):
    """The closed shape with its faces turned outwards."""
    points, faces = shape
    volume = 0.0
    for face in faces:
        a = points[face[0]]
        for i, j in zip(face[1:], face[2:]):
            volume += np.dot(a, np.cross(points[i], points[j]))
    return (points, faces) if volume > 0 else (points, [f[::-1] for f in faces])


def drum(radius, low, high, bevel, sides=20, axis="y"):
    """A cylinder with bevelled rims."""
    b = bevel
    return lathe(
        [(radius - b, low), (radius, low + b), (radius, high - b),
         (radius - b, high)], sides, axis)


def knob(radius, low, high, bevel, sides):
    """A disc that stands on a surface which faces +X."""
    return lathe([(radius, low), (radius, high - bevel),
                  (radius - bevel, high)], sides, "x")


def ball(radius, sides=20, rings=10, axis="x"):
    angles = [math.pi * k / rings for k in range(rings + 1)]
    return lathe(
        [(radius * math.sin(a), -radius * math.cos(a)) for a in angles],
        sides, axis)


def inset(outline, distance):
    """A counter-clockwise outline, moved inwards by a distance."""
    p = np.asarray(outline, dtype=float)
    before = p - np.roll(p, 1, axis=0)
    after = np.roll(p, -1, axis=0) - p
    normals = []
    for edge in (before, after):
        n = np.stack([-edge[:, 1], edge[:, 0]], axis=1)
        normals.append(n / np.linalg.norm(n, axis=1)[:, None])
    middle = normals[0] + normals[1]
    scale = 2 / np.maximum((middle**2).sum(axis=1), 1.0)
    return p + middle * (scale * distance)[:, None]


def plate(outline, low, high, bevel, axis="x"):
    """Extrudes an outline along an axis, with bevelled edges.

    The outline's coordinates are (y, z) for axis x, (z, x) for axis y and
    (x, y) for axis z. It may run in either direction.
    """
    n = len(outline)
    u, v = np.array(outline, dtype=float).T
    if (u * np.roll(v, -1) - v * np.roll(u, -1)).sum() < 0:
        outline = outline[::-1]
    inner = inset(outline, bevel)
    levels = [(inner, low), (outline, low + bevel), (outline, high - bevel),
              (inner, high)]
    points, faces = [], []
    for ring, height in levels:
        for u, v in ring:
            points.append({"x": (height, u, v), "y": (v, height, u),
                           "z": (u, v, height)}[axis])
    for level in range(3):
        for k in range(n):
            a, b = level * n + k, level * n + (k + 1) % n
            faces.append([a, b, b + n, a + n])
    faces.append(list(range(n))[::-1])
    faces.append(list(range(3 * n, 4 * n)))
    return np.array(points, dtype=float), faces


def box(low, high, bevel):
    """A block with bevelled edges, between two corners."""
    low, high = np.array(low, dtype=float), np.array(high, dtype=float)
    points, number = [], {}
    for corner in np.ndindex(2, 2, 2):
        for axis in range(3):
            p = np.where(corner, high - bevel, low + bevel)
            p[axis] = (low, high)[corner[axis]][axis]
            number[corner, axis] = len(points)
            points.append(p)
    faces = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, 1):
            ring = []
            for cu, cv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                c = [0, 0, 0]
                c[axis], c[u], c[v] = side, cu, cv
                ring.append(number[tuple(c), axis])
            faces.append(ring if side else ring[::-1])
        for su, sv in np.ndindex(2, 2):
            a, b = [0, 0, 0], [0, 0, 0]
            a[u] = b[u] = su
            a[v] = b[v] = sv
            b[axis] = 1
            a, b = tuple(a), tuple(b)
            quad = [number[a, u], number[b, u], number[b, v], number[a, v]]
            faces.append(quad[::-1] if su == sv else quad)
    for c in np.ndindex(2, 2, 2):
        tri = [number[c, 0], number[c, 1], number[c, 2]]
        faces.append(tri if sum(c) % 2 else tri[::-1])
    return np.array(points), faces


def tube(path, radius, sides=7):
    """A round tube along a smooth path of points that lie in one plane."""
    p = np.asarray(path, dtype=float)
    along = np.gradient(p, axis=0)
    along /= np.linalg.norm(along, axis=1)[:, None]
    across = np.array([1.0, 0, 0])
    points, faces = [], []
    for centre, t in zip(p, along):
        up = np.cross(t, across)
        for k in range(sides):
            a = 2 * math.pi * k / sides
            points.append(
                centre + radius * (math.cos(a) * across + math.sin(a) * up))
    for i in range(len(p) - 1):
        for k in range(sides):
            a, b = i * sides + k, i * sides + (k + 1) % sides
            faces.append([a, b, b + sides, a + sides])
    last = (len(p) - 1) * sides
    faces.append(list(range(sides))[::-1])
    faces.append(list(range(last, last + sides)))
    return np.array(points), faces


def arc(centre, radius, start, end, steps):
    """Points on a circle, from one angle to another, in degrees."""
    return [(centre[0] + radius * math.cos(math.radians(a)),
             centre[1] + radius * math.sin(math.radians(a)))
            for a in np.linspace(start, end, steps)]


def link_outline(length, r0, r1, steps=9):
    """Joins two circles, at 0 and at length along the first axis."""
    lean = math.degrees(math.asin((r0 - r1) / length))
    side = 90 - lean
    return (arc((0, 0), r0, side, 360 - side, steps)
            + arc((length, 0), r1, -side, side, steps))


def inside(tree, point):
    """Whether a point is inside the closed shape of a BVH tree."""
    ray, start, hits = Vector((0.2357, 0.9312, 0.2781)), Vector(point), 0
    while True:
        hit = tree.ray_cast(start, ray)[0]
        if hit is None:
            return hits % 2 == 1
        hits += 1
        start = hit + ray * 1e-5


def without_buried(shapes):
    """The shapes without the faces that are inside another shape."""
    trees = [BVHTree.FromPolygons(p.tolist(), f) for p, f in shapes]
    out = []
    for i, (points, faces) in enumerate(shapes):
        kept = faces
        for j, tree in enumerate(trees):
            low, high = shapes[j][0].min(axis=0), shapes[j][0].max(axis=0)
            near = ((points > low) & (points < high)).all(axis=1)
            if i == j or not near.any():
                continue
            buried = [n and inside(tree, p) for n, p in zip(near, points)]
            kept = [f for f in kept if not all(buried[v] for v in f)]
        used = sorted({v for f in kept for v in f})
        number = {v: k for k, v in enumerate(used)}
        out.append((points[used], [[number[v] for v in f] for f in kept]))
    return out
