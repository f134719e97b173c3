"""The face: skin with loops for lids and lips, eyes, brows and teeth.

The skin is the skull's grid with an opening in front, which is filled with
rings around the eye and the mouth, and with triangles between these and the
grid. One half is built and mirrored; twin[i] mirrors vertex i.
"""

import numpy as np
from mathutils import Vector
from mathutils.geometry import delaunay_2d_cdt

from . import features
from .head import COLUMNS, EYE, SKULL, skull_point
from .mesh import Piece, ring_points

X, Y, Z = np.eye(3)
HALF = COLUMNS // 2
WINDOW_ROWS, WINDOW_COLUMNS = (2, 13), 6
NOSE = ((0.0, 1.5360), (0.0065, 1.5400), (0.0, 1.5440), (0.0070, 1.5465),
        (0.0130, 1.5440), (0.0165, 1.5500), (0.0, 1.5520), (0.0060, 1.5560),
        (0.0115, 1.5590))
CLEAR = 0.0052  # the smallest distance of grid points from rings and nose


def within(polygon, point):
    """Whether a point is inside a closed polygon."""
    a, b = polygon, np.roll(polygon, -1, axis=0)
    span = (a[:, 1] > point[1]) != (b[:, 1] > point[1])
    height = np.where(a[:, 1] == b[:, 1], 1, b[:, 1] - a[:, 1])
    at = a[:, 0] + (point[1] - a[:, 1]) / height * (b[:, 0] - a[:, 0])
    return bool(np.count_nonzero(span & (point[0] < at)) % 2)


class Skin:
    """The skin at rest as a Piece, and its loops.

    lids  {name: vertices} of the left eye, lips likewise of the left half
    base  the left half of the lowest ring, inside the neck
    twin  the mirrored vertex of each
    """

    def __init__(self):
        self.half = Piece()
        self.make_grid()
        self.lids = {n: self.half.vertices(r)
                     for n, r in features.lid_rings().items()}
        self.lips = {n: self.half.vertices(r)
                     for n, r in features.lip_rings().items()}
        self.fill_window()
        self.make_lids()
        self.make_lips()
        self.drop_unused()
        self.mirror()
        part = self.lips["part"]
        self.piece.mark("dark", [*part, *self.twin[part]])

    def make_grid(self):
        rows = range(len(SKULL))
        self.grid = np.array([self.half.vertices(
            [skull_point(r, c) for c in range(HALF + 1)]) for r in rows])
        for v in self.grid[:, [0, HALF]].ravel():
            self.half.co[v][0] = 0
        for r in rows[:-1]:
            for c in range(HALF):
                face = [self.grid[r, c], self.grid[r, c + 1],
                        self.grid[r + 1, c + 1], self.grid[r + 1, c]]
                if not (WINDOW_ROWS[0] <= r < WINDOW_ROWS[1]
                        and c < WINDOW_COLUMNS):
                    self.half.face(face, "skin")
        self.half.face(self.grid[0][::-1], "skin")

    def fill_window(self):
        """Triangles between the grid and the outermost rings."""
        low, high = WINDOW_ROWS
        side = WINDOW_COLUMNS
        border = [*self.grid[low, :side], *self.grid[low:high, side],
                  *self.grid[high, side::-1]]
        holes = [self.lids["crease"], self.lips["outside"]]
        nose = self.half.vertices(
            [(x, features.front([x], [z])[0], z) for x, z in NOSE])
        fixed = border + holes[0] + holes[1] + nose
        flat = self.half.points()[:, [0, 2]]
        shapes = [flat[h] for h in holes]
        inner = [v for v in self.grid[low + 1:high, :side].ravel()
                 if not any(within(s, flat[v]) for s in shapes)
                 and np.linalg.norm(flat[fixed] - flat[v],
                                    axis=1).min() > CLEAR]
        middle = [v for v in fixed + inner if flat[v, 0] == 0]
        middle.sort(key=lambda v: flat[v, 1])
        used = list(dict.fromkeys(fixed + inner))
        place = {v: i for i, v in enumerate(used)}
        edges = [*zip(border, border[1:]), *zip(middle, middle[1:]),
                 *zip(holes[0], holes[0][1:] + holes[0][:1]),
                 *zip(holes[1], holes[1][1:])]
        edges = [(place[a], place[b]) for a, b in edges]
        out, _, faces, origin, *_ = delaunay_2d_cdt(
            [Vector(flat[v]) for v in used], edges, [], 0, 1e-7)
        if len(out) != len(used):
            raise ValueError("rings of the face cross each other")
        outline = flat[border]
        for face in faces:
            face = [used[origin[i][0]] for i in face]
            center = flat[face].mean(axis=0)
            if within(outline, center) and not any(
                    within(s, center) for s in shapes):
                self.half.face(face, "skin")

    def ring(self, inner, outer, region, columns, closed):
        """Quads between rings, in the given columns."""
        n = len(inner)
        for k in columns:
            m = (k + 1) % n if closed else k + 1
            self.half.face((inner[k], outer[k], outer[m], inner[m]), region)

    def make_lids(self):
        edge, ridge, rim, fold, crease = (
            self.lids[n] for n in ("edge", "ridge", "rim", "fold", "crease"))
        last = features.UPPER[-1]
        upper = features.UPPER[:-1]
        lower = range(last + 1, features.LID_COLUMNS)
        for a, b, region in ((edge, ridge, "lash"), (ridge, rim, "lash"),
                             (rim, fold, "skin"), (fold, crease, "skin")):
            self.ring(a, b, region, upper, True)
        for k, m, turn in ((0, 1, 1), (last + 1, last, -1)):
            for face, region in (
                    ((edge[k], ridge[m], edge[m]), "lash"),
                    ((edge[k], rim[k], rim[m], ridge[m]), "lash"),
                    ((rim[k], fold[m], rim[m]), "skin"),
                    ((rim[k], crease[k], crease[m], fold[m]), "skin")):
                self.half.face(face[::turn], region)
        self.ring(edge, rim, "rim", lower[:-1], True)
        self.half.face((edge[-1], rim[-1], edge[0]), "rim")
        self.half.face((rim[-1], rim[0], edge[0]), "skin")
        self.ring(rim, crease, "skin", lower, True)

    def make_lips(self):
        rings = [self.lips[n] for n in ("outside", "border", "crest", "part",
                                        "inside", "back")]
        n = len(features.LIP_COLUMNS) - 1
        for i, (outer, inner) in enumerate(zip(rings, rings[1:])):
            for columns, lip in ((range(n), "upperlip"),
                                 (range(n, 2 * n), "lip")):
                region = ("skin", lip, lip, "mouth", "mouth")[i]
                # lip rings run clockwise seen from the front, so ring() gets
                # the outer one first
                self.ring(outer, inner, region, columns, False)
        self.half.face(rings[-1][::-1], "mouth")

    def drop_unused(self):
        used = sorted({v for f in self.half.faces for v in f})
        number = {v: i for i, v in enumerate(used)}
        self.base = [number[v] for v in self.grid[0]]
        self.lids = {n: [number[v] for v in ring if v in number]
                     for n, ring in self.lids.items()}
        self.lips = {n: [number[v] for v in ring]
                     for n, ring in self.lips.items()}
        self.half = self.half.compact()

    def mirror(self):
        """The whole skin, mirrored from its left half."""
        n = len(self.half.co)
        center = {i for i, co in enumerate(self.half.co) if co[0] == 0}
        self.piece = Piece().add(self.half)
        twin = []
        for i, co in enumerate(self.half.co):
            twin.append(i if i in center
                        else self.piece.vertex(co * (-1, 1, 1)))
        for face, region in zip(self.half.faces, self.half.region):
            self.piece.face([twin[v] for v in reversed(face)], region)
        self.twin = np.array(twin + [0] * (len(self.piece.co) - n))
        for i in range(n):
            self.twin[twin[i]] = i
        self.left = n

    def edges(self):
        """Pairs of neighbouring vertices, each pair once, [edge][2]."""
        pairs = {(min(a, b), max(a, b)) for f in self.piece.faces
                 for a, b in zip(f, f[1:] + f[:1])}
        return np.array(sorted(pairs))


# --- parts on the skin or behind it -------------------------------------------


EYE_COLUMNS = 12


def make_eye():
    """The left eye: white, iris and pupil on the eyeball.

    The white reaches behind the lids, so far that these also cover its edge
    while the eye looks aside.
    """
    piece = Piece()
    a = 2 * np.pi * np.arange(EYE_COLUMNS) / EYE_COLUMNS
    c, s = np.cos(a), np.sin(a)
    white = (np.where(c > 0, 1.20, 1.36) * features.EYE_WIDTH,
             np.where(s > 0, 1.44 * features.EYE_TOP,
                      1.36 * features.EYE_BOTTOM))
    rings = []
    for (width, height), aside, back in ((white, 0.0, 0.0016),
                                         ((0.0122, 0.0122), 0.0006, 0.0),
                                         ((0.0062, 0.0062), 0.0006, 0.0)):
        px = EYE[0] + aside + width * c
        pz = EYE[2] + height * s
        py = features.dome(px, pz, 0.0) + back
        rings.append(piece.vertices(np.stack([px, py, pz], axis=1)))
    piece.bridge(rings[0], rings[1], "eyewhite")
    piece.bridge(rings[1], rings[2], "iris")
    x, z = EYE[0] + 0.0006, EYE[2]
    piece.fan(rings[2], piece.vertex((x, features.dome(x, z, 0.0), z)),
              "pupil")
    return piece


def make_glint(side):
    """The highlight in an eye, on the same side in both eyes."""
    piece = Piece()
    points = ring_points((side * EYE[0] + 0.0046, 0, EYE[2] + 0.0052), X, Z,
                         (0.0030, 0.0034, 0.0034), 6)
    for p in points:
        p[1] = features.dome(side * p[0], p[2], 0.0007)
    piece.face(piece.vertices(points), "glint")
    return piece


BROW_STEPS = np.linspace(0, 1, 5)


def brow_points(lay, brow=features.Brow()):
    """Three points across at each of BROW_STEPS; lay(x, z) gives the skin."""
    x, z = features.brow_line(BROW_STEPS)
    dx, dz = features.brow_shift(brow, BROW_STEPS)
    x, z = x + dx, z + dz
    half = 0.0056 * (1 - 0.40 * BROW_STEPS ** 1.6)
    rows = [np.stack([x, lay(x, z + s * half) + out, z + s * half], axis=1)
            for s, out in ((-1, 0.0010), (0, -0.0034), (1, 0.0010))]
    return np.stack(rows, axis=1).reshape(-1, 3)


def make_brow(lay):
    piece = Piece()
    rows = np.array(piece.vertices(brow_points(lay))).reshape(-1, 3)
    for a, b in zip(rows, rows[1:]):
        for i in range(2):
            piece.face((a[i], b[i], b[i + 1], a[i + 1]), "brow")
    piece.face(rows[0], "brow")
    return piece


def make_teeth():
    """The upper row, behind the lips."""
    piece = Piece()
    rows = []
    for s in np.linspace(-1, 1, 7):
        x = 0.0235 * s
        y = features.front([0], [features.MOUTH_Z])[0] + 0.0065
        y += 0.0150 * abs(s) ** 2.4
        low = features.MOUTH_Z - 0.0012 + 0.0050 * s * s
        rows.append(piece.vertices([(x, y, low), (x, y + 0.0006, 0.0085 + low)]))
    for a, b in zip(rows, rows[1:]):
        piece.face((a[0], b[0], b[1], a[1]), "teeth")
    return piece
