"""Mesh pieces as plain arrays, which become Blender meshes at the end.

A Piece collects vertices and faces, ring by ring. Each face has a region (a
colour name), each face corner a texture coordinate, each vertex any number of
named marks (0..1) from which rig.py computes bone weights. Named shapes hold the
positions of all vertices in morph targets.
"""

import bpy
import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree


def smoothstep(low, high, x):
    """A smooth step from 0 at low to 1 at high; low may exceed high."""
    t = np.clip((np.asarray(x, dtype=float) - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def gauss(x, center, width):
    return np.exp(-(((np.asarray(x, dtype=float) - center) / width) ** 2))


def unit(v):
    v = np.asarray(v, dtype=float)
    return v / np.linalg.norm(v)


def curve(keys, x):
    """A monotone cubic Hermite curve through (x, value...) rows."""
    keys = np.asarray(keys, dtype=float)
    at, values = keys[:, 0], keys[:, 1:]
    step = np.diff(at)[:, None]
    slope = np.diff(values, axis=0) / step
    tangent = np.zeros_like(values)
    same = slope[:-1] * slope[1:] > 0
    w1, w2 = 2 * step[1:] + step[:-1], step[1:] + 2 * step[:-1]
    safe = np.where(same, slope[:-1], 1), np.where(same, slope[1:], 1)
    mean = (w1 + w2) / (w1 / safe[0] + w2 / safe[1])
    tangent[1:-1] = np.where(same, mean, 0)
    tangent[0], tangent[-1] = slope[0], slope[-1]
    x = np.clip(np.asarray(x, dtype=float), at[0], at[-1])
    i = np.clip(np.searchsorted(at, x, side="right") - 1, 0, len(at) - 2)
    h = step[i]
    t = ((x - at[i]) / (at[i + 1] - at[i]))[..., None]
    return ((2 * t**3 - 3 * t**2 + 1) * values[i]
            + (t**3 - 2 * t**2 + t) * h * tangent[i]
            + (3 * t**2 - 2 * t**3) * values[i + 1]
            + (t**3 - t**2) * h * tangent[i + 1])


class Piece:
    def __init__(self):
        self.co = []
        self.faces = []
        self.region = []
        self.uv = []
        self.marks = {}
        self.shapes = {}

    # --- building ---

    def vertex(self, co):
        self.co.append(np.asarray(co, dtype=float))
        return len(self.co) - 1

    def vertices(self, cos):
        return [self.vertex(co) for co in cos]

    def mark(self, name, vertices, value=1.0):
        for v in vertices:
            self.marks.setdefault(name, {})[v] = value

    def face(self, corners, region, uv=None):
        self.faces.append(tuple(int(v) for v in corners))
        self.region.append(region)
        self.uv.append(uv or [(0.0, 0.0)] * len(corners))

    def bridge(self, a, b, region, closed=True, u=(0, 1), v=(0, 1), skip=()):
        """Quads between two rings of equal length, b above a.

        Seen from outside, rings run counter-clockwise from above. u spans
        the ring, v runs from a to b; either end of v may be a list with a
        number for each vertex. skip holds segments to leave open.
        """
        n = len(a)
        last = n if closed else n - 1
        below, above = (np.broadcast_to(end, n) for end in v)
        for k in range(last):
            if k in skip:
                continue
            m = (k + 1) % n
            u0 = u[0] + (u[1] - u[0]) * k / last
            u1 = u[0] + (u[1] - u[0]) * (k + 1) / last
            self.face((a[k], a[m], b[m], b[k]), region,
                      [(u0, below[k]), (u1, below[m]),
                       (u1, above[m]), (u0, above[k])])

    def fan(self, ring, tip, region):
        """Closes a ring with triangles to one vertex above it."""
        n = len(ring)
        for k in range(n):
            self.face((ring[k], ring[(k + 1) % n], tip), region)

    # --- whole pieces ---

    def points(self):
        return np.array(self.co)

    def move(self, function):
        """Replaces every vertex co by function(co)."""
        def moved(points):
            return [np.asarray(function(co), dtype=float) for co in points]

        self.co = moved(self.co)
        self.shapes = {n: moved(s) for n, s in self.shapes.items()}
        return self

    def mirrored(self):
        """Mirrors: negates x, reverses faces, keeps u."""
        out = Piece()
        out.co = [co * (-1, 1, 1) for co in self.co]
        out.faces = [tuple(reversed(f)) for f in self.faces]
        out.uv = [list(reversed(uv)) for uv in self.uv]
        out.region = list(self.region)
        out.marks = {n: dict(m) for n, m in self.marks.items()}
        out.shapes = {n: [co * (-1, 1, 1) for co in s]
                      for n, s in self.shapes.items()}
        return out

    def add(self, other):
        """Adds another piece without welding vertices."""
        base = len(self.co)
        for name in {**self.shapes, **other.shapes}:
            mine = self.shapes.setdefault(name, list(self.co))
            mine += other.shapes.get(name, other.co)
        self.co += other.co
        self.faces += [tuple(v + base for v in f) for f in other.faces]
        self.region += other.region
        self.uv += other.uv
        for name, values in other.marks.items():
            mine = self.marks.setdefault(name, {})
            mine.update({v + base: w for v, w in values.items()})
        return self

    def without_faces(self, drop):
        """A copy without the faces for which drop(points) is true."""
        out = Piece()
        co = self.points()
        keep = [i for i, f in enumerate(self.faces) if not drop(co[list(f)])]
        used = sorted({v for i in keep for v in self.faces[i]})
        new = {v: i for i, v in enumerate(used)}
        out.co = [self.co[v] for v in used]
        for i in keep:
            out.face([new[v] for v in self.faces[i]], self.region[i],
                     self.uv[i])
        for name, values in self.marks.items():
            out.marks[name] = {new[v]: w for v, w in values.items()
                               if v in new}
        out.shapes = {n: [s[v] for v in used] for n, s in self.shapes.items()}
        return out

    def compact(self):
        """A copy without the vertices that no face uses."""
        return self.without_faces(lambda points: False)

    def drop_uv(self, unneeded):
        """Sets texture coordinates to 0 where unneeded(region): fewer seams."""
        self.uv = [[(0.0, 0.0)] * len(uv) if unneeded(region) else uv
                   for uv, region in zip(self.uv, self.region)]

    def triangulated(self):
        """A copy in triangles; quads are split along the shorter diagonal."""
        out = Piece()
        out.co, out.marks, out.shapes = self.co, self.marks, self.shapes
        for face, region, uv in zip(self.faces, self.region, self.uv):
            turn = 0
            if len(face) == 4:
                p = [self.co[v] for v in face]
                turn = int(np.linalg.norm(p[0] - p[2])
                           > np.linalg.norm(p[1] - p[3]) + 1e-6)
            face, uv = face[turn:] + face[:turn], uv[turn:] + uv[:turn]
            for i in range(1, len(face) - 1):
                out.face((face[0], face[i], face[i + 1]), region,
                         [uv[0], uv[i], uv[i + 1]])
        return out

    def to_mesh(self, name):
        """A Blender mesh with one material slot for each region."""
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata([tuple(c) for c in self.co], [], self.faces)
        layer = mesh.uv_layers.new(name="UVMap")
        flat = [x for uv in self.uv for pair in uv for x in pair]
        layer.data.foreach_set("uv", flat)
        names = sorted(set(self.region))
        index = [names.index(r) for r in self.region]
        mesh.polygons.foreach_set("material_index", index)
        return mesh, names

    def subdivided(self):
        """One step of Catmull-Clark subdivision; keeps regions, uv and marks."""
        mesh, names = self.to_mesh("cage")
        obj = bpy.data.objects.new("cage", mesh)
        bpy.context.scene.collection.objects.link(obj)
        for _ in names:
            mesh.materials.append(None)
        for name in sorted(self.marks):
            group = obj.vertex_groups.new(name=name)
            for v, w in self.marks[name].items():
                group.add([v], w, "REPLACE")
        modifier = obj.modifiers.new("subdivide", "SUBSURF")
        modifier.levels = 1
        modifier.uv_smooth = "NONE"
        modifier.boundary_smooth = "ALL"
        graph = bpy.context.evaluated_depsgraph_get()
        fine = bpy.data.meshes.new_from_object(obj.evaluated_get(graph))
        out = from_mesh(fine, names, sorted(self.marks))
        bpy.data.objects.remove(obj)
        bpy.data.meshes.remove(mesh)
        bpy.data.meshes.remove(fine)
        return out


def from_mesh(mesh, regions, marks):
    """Converts a Blender mesh with region slots and groups to a Piece."""
    out = Piece()
    out.co = [np.array(v.co, dtype=float) for v in mesh.vertices]
    uv = mesh.uv_layers[0].data
    for poly in mesh.polygons:
        corners = [tuple(uv[i].uv) for i in poly.loop_indices]
        out.face(tuple(poly.vertices), regions[poly.material_index], corners)
    for v in mesh.vertices:
        for g in v.groups:
            if g.weight > 0:
                name = marks[g.group]
                out.marks.setdefault(name, {})[v.index] = g.weight
    return out


def directions(n):
    """n unit vectors, evenly distributed on the sphere."""
    z = 1 - 2 * (np.arange(n) + 0.5) / n
    a = np.pi * (1 + 5**0.5) * np.arange(n)
    r = np.sqrt(1 - z * z)
    return np.stack([r * np.cos(a), r * np.sin(a), z], axis=1)


def hidden_behind(pieces, rays=200):
    """A function: whether the points of a face are hidden from all sides."""
    whole = Piece()
    for piece in pieces:
        whole.add(piece.triangulated())
    tree = BVHTree.FromPolygons([tuple(c) for c in whole.co], whole.faces)
    ways = directions(rays)

    def hidden(points):
        center = points.mean(axis=0)
        normal = np.cross(points[1] - points[0], points[-1] - points[0])
        normal /= max(np.linalg.norm(normal), 1e-12)
        for p in (center, *(center + (points - center) * 0.93)):
            start = Vector(p + normal * 1e-4)
            for way in ways[ways @ normal > 0.02]:
                if tree.ray_cast(start, Vector(way))[0] is None:
                    return False
        return True

    return hidden


def rounding(n):
    """The factor by which one subdivision shrinks a ring of n."""
    return 1 / np.cos(np.pi / n)


def ring_points(center, across, ahead, size, n, turn=0.0, power=2.0):
    """n points of a (super-)ellipse, counter-clockwise about across x ahead.

    size is (half width, half depth towards -ahead, towards +ahead); turn is
    the first point's angle in degrees from across.
    """
    center, across, ahead = (np.asarray(v, dtype=float)
                             for v in (center, across, ahead))
    out = []
    for k in range(n):
        a = np.radians(turn + 360 * k / n)
        c, s = np.cos(a), np.sin(a)
        depth = size[2] if s > 0 else size[1]
        x = np.sign(c) * abs(c) ** (2 / power) * size[0]
        y = np.sign(s) * abs(s) ** (2 / power) * depth
        out.append(center + across * x + ahead * y)
    return out
