"""Neck, skull, ears and hair."""

import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree

from .mesh import Piece, curve, gauss, ring_points, smoothstep, unit

X, Y, Z = np.eye(3)
MIDDLE = np.array([0, 0.004, 1.602])  # of the skull
COLUMNS = 28

SKULL = [  # z in front, z behind, half width, front, behind, power
    (1.4880, 1.512, 0.044, 0.046, 0.050, 2.0),
    (1.4755, 1.512, 0.0470, 0.0690, 0.0580, 1.80),
    (1.4785, 1.518, 0.0520, 0.0815, 0.0640, 1.80),
    (1.4890, 1.527, 0.0570, 0.0880, 0.0710, 1.85),
    (1.5030, 1.539, 0.0618, 0.0905, 0.0785, 1.90),
    (1.5170, 1.551, 0.0660, 0.0915, 0.0850, 1.97),
    (1.5300, 1.562, 0.0694, 0.0920, 0.0895, 2.05),
    (1.5390, 1.570, 0.0714, 0.0922, 0.0925, 2.08),
    (1.5490, 1.579, 0.0733, 0.0925, 0.0950, 2.10),
    (1.5610, 1.589, 0.0750, 0.0928, 0.0970, 2.10),
    (1.5750, 1.600, 0.0764, 0.0932, 0.0985, 2.10),
    (1.5900, 1.612, 0.0775, 0.0940, 0.0995, 2.10),
    (1.6060, 1.624, 0.0784, 0.0955, 0.1000, 2.15),
    (1.6240, 1.638, 0.0786, 0.0966, 0.0990, 2.15),
    (1.6460, 1.655, 0.0772, 0.0952, 0.0960, 2.15),
    (1.6680, 1.673, 0.0730, 0.0895, 0.0900, 2.10),
    (1.6900, 1.692, 0.0645, 0.0785, 0.0800, 2.05),
    (1.7090, 1.709, 0.0510, 0.0610, 0.0640, 2.00),
    (1.7220, 1.721, 0.0310, 0.0360, 0.0390, 2.00),
]
EYE = np.array([0.0325, 0, 1.5815])


def shape_face(p):
    """Nose, eye sockets, lips, chin and cheeks on the front of the skull."""
    x, y, z = p
    if y > 0:
        return p
    front = float(smoothstep(0.0, 0.05, -y))
    ax = abs(x)
    wide = 0.0072 + 0.0030 * float(gauss(z, 1.549, 0.010))
    nose = float(curve([(1.530, 0.0), (1.539, 0.007), (1.549, 0.0175),
                        (1.561, 0.0125), (1.575, 0.0085), (1.592, 0.0035),
                        (1.612, 0.0)], z)[0]) * float(gauss(x, 0, wide))
    nose += 0.003 * float(gauss(ax, 0.012, 0.006) * gauss(z, 1.546, 0.008))
    socket = 0.0055 * float(gauss(ax, EYE[0], 0.017)
                            * gauss(z, EYE[2] + 0.001, 0.015))
    lips = 0.0035 * float(gauss(x, 0, 0.017) * gauss(z, 1.511, 0.010))
    chin = 0.0045 * float(gauss(x, 0, 0.016) * gauss(z, 1.484, 0.011))
    cheek = 0.0030 * float(gauss(ax, 0.044, 0.018) * gauss(z, 1.547, 0.018))
    brow = 0.0020 * float(gauss(ax, 0.030, 0.022) * gauss(z, 1.610, 0.010))
    out = nose + lips + chin + cheek + brow - socket
    return np.array([x * (1 + 0.02 * cheek / 0.003), y - out * front, z])


def skull_row(row):
    """A row of SKULL; fractions interpolate."""
    return curve([(i, *r) for i, r in enumerate(SKULL)], row)


def skull_point(row, column):
    """The skin at a row of SKULL and a column; 0 is in front, then left."""
    zf, zb, w, front, back, power = skull_row(row)
    a = 2 * np.pi * column / COLUMNS
    a = a - 0.48 * np.sin(a)  # more columns in front
    s, c = np.sin(a), np.cos(a)
    x = np.sign(s) * abs(s) ** (2 / power) * w
    y = abs(c) ** (2 / power) * (-front if c > 0 else back)
    z = zf + (zb - zf) * (1 - c) / 2
    return shape_face(np.array([x, y, z]))


def make_skull(finer=1):
    """The closed head, including the part under the hair."""
    piece = Piece()
    rows = np.arange(finer * (len(SKULL) - 1) + 1) / finer
    columns = np.arange(finer * COLUMNS) / finer
    rings = [piece.vertices([skull_point(r, c) for c in columns])
             for r in rows]
    for a, b in zip(rings, rings[1:]):
        piece.bridge(a, b, "skin")
    piece.fan(rings[-1], piece.vertex((0, -0.001, 1.7265)), "skin")
    piece.face(rings[0][::-1], "skin")
    return piece


class Surface:
    """Finds points on the skull."""

    def __init__(self, piece):
        self.tree = BVHTree.FromPolygons([tuple(c) for c in piece.co],
                                         piece.faces)

    def front(self, x, z):
        """The y of the face at (x, z)."""
        hit = self.tree.ray_cast(Vector((x, -1, z)), Vector((0, 1, 0)))[0]
        return hit.y

    def radius(self, direction):
        """Distance from the middle of the skull in a direction."""
        far = Vector(MIDDLE + direction * 0.5)
        hit = self.tree.ray_cast(far, Vector(-direction))[0]
        return (hit - Vector(MIDDLE)).length

    def at(self, azimuth, z):
        """The unit direction to the surface at height z; 0 degrees is in front."""
        a = np.radians(azimuth)
        level = np.array([np.sin(a), -np.cos(a), 0])
        far = Vector(level * 0.5 + MIDDLE * (0, 1, 0) + Z * z)
        hit = self.tree.ray_cast(far, Vector(-level))[0]
        return unit(np.array(hit) - MIDDLE)


# --- ear and neck -----------------------------------------------------------


def make_ear():
    """The left ear: a tilted shell with a hollow."""
    piece = Piece()
    normal = unit(np.array([1, 0.42, 0.05]))
    up = unit(np.array([0.10, 0.16, 1]))
    ahead = unit(np.cross(up, normal))
    root = np.array([0.0735, 0.014, 1.569])
    n, before = 10, None
    for f, out in ((0.90, -0.006), (1.0, 0.008), (0.86, 0.0135),
                   (0.60, 0.0085)):
        ring = []
        for k in range(n):
            a = 2 * np.pi * k / n
            c, s = np.cos(a), np.sin(a)
            lobe = 1 - 0.30 * smoothstep(0.1, -1.0, s)
            ring.append(root + ahead * c * 0.0185 * f * lobe
                        + up * s * 0.0300 * f
                        + normal * (out + 0.006 * c * (f > 0.8)))
        ring = piece.vertices(ring)
        if before:
            piece.bridge(before, ring, "skin")
        before = ring
    piece.fan(before, piece.vertex(root + normal * 0.006), "skin")
    return piece


def make_neck():
    piece = Piece()
    before = None
    for z, w, front, back, y in ((1.408, 0.0530, 0.048, 0.049, 0.022),
                                 (1.450, 0.0470, 0.046, 0.047, 0.017),
                                 (1.510, 0.0500, 0.048, 0.060, 0.010)):
        ring = piece.vertices(ring_points(
            (0, y, z), X, Y, (w, front, back), 12))
        if before:
            piece.bridge(before, ring, "skin")
        before = ring
    return piece


# --- hair -------------------------------------------------------------------

HAIRLINE = [  # degrees from the front, height
    (0, 1.6810), (18, 1.6830), (36, 1.6740), (52, 1.6540), (64, 1.6280),
    (73, 1.6000), (80, 1.5740), (88, 1.5800), (97, 1.5960), (108, 1.5820),
    (120, 1.5560), (140, 1.5340), (180, 1.5220)]
TAIL = [np.array(p) for p in ([0, 0.106, 1.655], [0, 0.168, 1.640],
                              [0, 0.208, 1.565], [0, 0.216, 1.480],
                              [0, 0.200, 1.390])]
TIE = TAIL[0]


def turn_towards(a, b, t):
    """Interpolates two unit vectors along their great circle."""
    angle = np.arccos(np.clip(a @ b, -1, 1))
    return (np.sin((1 - t) * angle) * a + np.sin(t * angle) * b) / np.sin(
        angle)


def make_cap(skin):
    """Hair, combed back in ridges from the hairline to the tie."""
    piece = Piece()
    columns = 32
    tie = unit(TIE - MIDDLE)
    rows = [(0.0, -0.004), (0.015, 0.0050), (0.10, 0.0100), (0.28, 0.0155),
            (0.46, 0.0175), (0.64, 0.0170), (0.82, 0.0130), (0.965, 0.0050)]
    rings = [[] for _ in rows]
    for k in range(columns):
        # seen from the tie, rings run counter-clockwise, as bridge() needs
        azimuth = 360 * k / columns
        side = azimuth if azimuth <= 180 else azimuth - 360
        z = float(curve(HAIRLINE, abs(side))[0])
        start = skin.at(side, z)
        for ring, (t, lift) in zip(rings, rows):
            d = turn_towards(start, tie, t)
            ridge = 0.0020 * smoothstep(0.10, 0.45, t) * (-1) ** k
            crown = 0.006 * float(gauss(d[2], 0.9, 0.5)) * (t > 0.05)
            thick = 0.65 + 0.35 * smoothstep(-0.5, 0.3, d[2])
            r = skin.radius(d) + lift * thick + ridge + crown
            ring.append(MIDDLE + d * r)
    rings = [piece.vertices(r) for r in rings]
    for i, ring in enumerate(rings):
        piece.mark("light", ring[::2], 1.0 if i > 1 else 0.5)
    for a, b in zip(rings, rings[1:]):
        piece.bridge(a, b, "hair")
    return piece


LOCKS = [  # width, thickness, then (degrees, height) along the forehead
    (0.020, 0.0085, [(-14, 1.704), (6, 1.692), (26, 1.672), (45, 1.646),
                     (60, 1.616), (69, 1.588)]),
    (0.017, 0.0080, [(-10, 1.709), (16, 1.702), (40, 1.678), (58, 1.648),
                     (71, 1.612), (78, 1.566)]),
    (0.018, 0.0085, [(-12, 1.705), (-28, 1.690), (-44, 1.664), (-58, 1.634),
                     (-68, 1.600), (-73, 1.562)]),
    (0.015, 0.0080, [(-16, 1.710), (-38, 1.696), (-56, 1.664), (-69, 1.628),
                     (-77, 1.588), (-81, 1.540)]),
]


def make_lock(skin, width, thick, way):
    """A flat strand on the forehead that ends in a point."""
    piece = Piece()
    path = []
    for t in np.linspace(0, 1, 7):
        key = [(i / (len(way) - 1), *w) for i, w in enumerate(way)]
        azimuth, z = curve(key, t)
        d = skin.at(float(azimuth), float(z))
        path.append((MIDDLE + d * (skin.radius(d) + 0.011 - 0.004 * t), d))
    before = None
    for i, (p, d) in enumerate(path[:-1]):
        t = i / (len(path) - 1)
        ahead = unit(path[i + 1][0] - path[max(i - 1, 0)][0])
        side = unit(np.cross(ahead, d))
        size = 0.55 + 0.45 * np.sin(np.pi * min(1.0, 0.25 + t))
        size = size * (1 - t ** 3)
        ring = piece.vertices(ring_points(
            p, d, side, (thick * (0.5 + 0.5 * size), width * size,
                         width * size), 6, power=1.8))
        piece.mark("light", [ring[0]], 1.0)
        if before:
            piece.bridge(before, ring, "hair")
        before = ring
    piece.fan(before, piece.vertex(path[-1][0]), "hair")
    return piece


TAIL_SIZE = [(0, 0.014), (0.07, 0.017), (0.20, 0.033), (0.42, 0.038),
             (0.66, 0.030), (0.86, 0.0145), (1, 0.002)]


def make_tail():
    """The ponytail, along its bones, with the tie around its root."""
    piece = Piece()
    key = [(i / 4, *p) for i, p in enumerate(TAIL)]
    n, steps, before = 10, 11, None
    for i in range(steps):
        t = i / (steps - 0.5)
        p = curve(key, t)
        ahead = unit(curve(key, min(1, t + 0.03))
                     - curve(key, max(0, t - 0.03)))
        size = float(curve(TAIL_SIZE, t)[0])
        # X x side = ahead, so rings run counter-clockwise seen from the tip
        side = unit(np.cross(ahead, X))
        points = ring_points(p, X, side, (size, size * 0.9, size * 0.9), n)
        for k in range(0, n, 2):
            points[k] = p + (points[k] - p) * 0.90
        ring = piece.vertices(points)
        piece.mark("along", ring, t)
        piece.mark("light", ring[1::2], 0.9)
        if before:
            piece.bridge(before, ring, "hair")
        before = ring
    tip = piece.vertex(TAIL[4])
    piece.mark("along", [tip], 1)
    piece.fan(before, tip, "hair")
    return piece


def make_tie():
    piece = Piece()
    ahead = unit(TAIL[1] - TAIL[0])
    side = unit(np.cross(ahead, X))
    before = None
    for s, r in ((-0.004, 0.014), (0.002, 0.0215), (0.012, 0.0225),
                 (0.019, 0.016)):
        ring = piece.vertices(ring_points(TIE + ahead * s, X, side,
                                          (r, r, r), 10))
        piece.mark("along", ring, 0.06)
        if before:
            piece.bridge(before, ring, "tie")
        before = ring
    return piece
