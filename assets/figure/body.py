"""Shirt, trousers, belt, arms with hands, socks and shoes."""

import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree

from . import rig
from .mesh import Piece, curve, ring_points, rounding, smoothstep, unit

X, Y, Z = np.eye(3)

# --- shirt ------------------------------------------------------------------

TORSO = [  # z, half width, depth in front, depth behind, y of the centre
    (0.980, 0.118, 0.086, 0.086, 0.004),
    (1.035, 0.123, 0.091, 0.087, 0.004),
    (1.100, 0.126, 0.096, 0.086, 0.004),
    (1.175, 0.140, 0.109, 0.096, 0.008),
    (1.250, 0.153, 0.120, 0.104, 0.013),
    # the three rings of the arm holes
    (1.312, 0.156, 0.114, 0.106, 0.016),
    (1.352, 0.156, 0.103, 0.106, 0.018),
    (1.386, 0.142, 0.088, 0.098, 0.020),
]
HOLE = 5  # first of those rings
# metres that these three rings rise, [ring][column]: column 0 is at the
# shoulder, 3 in the middle of the front or back
HOLE_RISE = [(-0.022, -0.006, 0, 0), (0, 0, 0, 0),
             (0.016, 0.006, -0.004, -0.006)]
COLLAR = [  # as above, then the extra height behind
    (1.420, 0.104, 0.070, 0.074, 0.022, 0.10),
    (1.436, 0.076, 0.064, 0.062, 0.020, 0.25),
    (1.450, 0.064, 0.057, 0.053, 0.019, 0.34),
    (1.436, 0.056, 0.049, 0.046, 0.019, 0.34),
]
SLEEVE = [  # along the arm, half depth, half height
    (0.022, 0.064, 0.062),
    (0.084, 0.061, 0.060),
    (0.148, 0.061, 0.060),
    (0.174, 0.065, 0.064),
    (0.160, 0.051, 0.050),
]
TILE = 0.22  # metres of shirt that the texture covers
TRIM = (0.836, 0.836)  # the plain part of the texture, for collar and hems


def torso_ring(z, w, front, back, y, n=12, power=2.25):
    f = rounding(n)
    return ring_points((0, y, z), X, Y, (w * f, front * f, back * f), n,
                       power=power)


def shirt_rings():
    """All rings from the waist up to inside the collar."""
    rings = [torso_ring(*row) for row in TORSO]
    for ring, rise in zip(rings[HOLE:], HOLE_RISE):
        for k in range(12):
            ring[k] = ring[k] + Z * rise[min(k % 6, 6 - k % 6)]
    for k in (0, 6):
        rings[HOLE][k] = rings[HOLE][k] * (0.93, 1, 1)
        rings[HOLE + 2][k] = rings[HOLE + 2][k] * (0.95, 1, 1)
    for z, w, front, back, y, tilt in COLLAR:
        ring = torso_ring(z, w, front, back, y, power=2)
        rings.append([p + Z * tilt * (p[1] - y) for p in ring])
    return rings


def add_sleeve(piece, hole, seam, side):
    """The sleeve from the arm hole's eight vertices, with a folded hem.

    seam is the torso's v at these vertices: its stripes go on in the sleeve.
    """
    f = rounding(8)
    before, v = hole, np.array(seam)
    for i, (s, depth, height) in enumerate(SLEEVE):
        points = ring_points(rig.SHOULDER + rig.ARM_DIR * s, Y, rig.ARM_UP,
                             (depth * f, height * f, height * f), 8)
        ring = piece.vertices([p * (side, 1, 1) for p in points])
        after = np.mean(seam) - (s - SLEEVE[0][0]) / TILE
        order = slice(None, None, side)
        piece.bridge(before[order], ring[order], "shirt", u=(0, 2),
                     v=((v[order] if i == 0 else v), after)
                     if i < 3 else TRIM)
        piece.mark("sleeve", ring, 0.86 if i == 0 else 1)
        before, v = ring, after


def make_shirt():
    piece = Piece()
    rings = shirt_rings()
    height = [np.mean([p[2] for p in r]) for r in rings]
    v = [(z - 0.97) / TILE for z in height]
    rings = [piece.vertices(r) for r in rings]
    for i in range(len(rings) - 1):
        hole = i in (HOLE, HOLE + 1)
        piece.bridge(rings[i], rings[i + 1], "shirt", u=(0, 4),
                     v=v[i:i + 2] if i < len(rings) - 3 else TRIM,
                     skip=(11, 0, 5, 6) if hole else ())
    a, b, c = rings[HOLE : HOLE + 3]
    va, vb, vc = v[HOLE : HOLE + 3]
    seam = [vb, vc, vc, vc, vb, va, va, va]
    add_sleeve(piece, [b[1], c[1], c[0], c[11], b[11], a[11], a[0], a[1]],
               seam, 1)
    add_sleeve(piece, [b[5], c[5], c[6], c[7], b[7], a[7], a[6], a[5]],
               seam, -1)
    mark_shoulders(piece, rings)
    return piece.compact().subdivided()


def mark_shoulders(piece, rings):
    """Marks how much the cloth around the arm holes follows the arms."""
    a, b, c = rings[HOLE : HOLE + 3]
    for k, ring, value in ((1, a, 0.26), (0, a, 0.30), (1, b, 0.34),
                           (1, c, 0.40), (0, c, 0.46), (2, a, 0.04),
                           (2, b, 0.07), (2, c, 0.08)):
        columns = {k, -k % 12, 6 - k, 6 + k}
        piece.mark("sleeve", [ring[i] for i in columns], value)
    piece.mark("sleeve", [rings[HOLE - 1][i] for i in (11, 0, 1, 5, 6, 7)],
               0.05)
    piece.mark("sleeve", [rings[HOLE + 3][i] for i in (11, 0, 1, 5, 6, 7)],
               0.06)


# --- trousers and socks -----------------------------------------------------

PELVIS = [  # z, half width, front, behind, y of the centre
    (1.014, 0.126, 0.094, 0.092, 0.004),
    (0.935, 0.152, 0.099, 0.119, 0.006),
    (0.880, 0.164, 0.099, 0.127, 0.004),
]
LEG = [  # z, half width, front, behind, x and y of the centre
    (0.765, 0.082, 0.088, 0.091, 0.093, 0.004),
    (0.660, 0.073, 0.080, 0.077, 0.094, 0.001),
    (0.555, 0.063, 0.068, 0.061, 0.095, -0.004),
    (0.496, 0.059, 0.064, 0.056, 0.095, -0.004),
    (0.437, 0.057, 0.058, 0.062, 0.096, 0.003),
    (0.350, 0.056, 0.053, 0.068, 0.097, 0.010),
    (0.184, 0.049, 0.049, 0.054, 0.098, 0.014),
]
CUFF = [
    (0.176, 0.055, 0.056, 0.060, 0.098, 0.014),
    (0.126, 0.057, 0.058, 0.062, 0.098, 0.014),
    (0.146, 0.043, 0.044, 0.047, 0.098, 0.014),
]


def leg_ring(piece, row, side):
    z, w, front, back, x, y = row
    f = rounding(8)
    return piece.vertices(ring_points((side * x, y, z), X, Y,
                                      (w * f, front * f, back * f), 8))


def make_trousers():
    piece = Piece()
    rings = [piece.vertices(torso_ring(*row, power=2.3)) for row in PELVIS]
    for above, below in zip(rings, rings[1:]):
        piece.bridge(below, above, "trousers")
    low = rings[-1]
    for k, lift, pull in ((3, -0.022, 0.86), (9, -0.012, 0.90),
                          (2, -0.010, 1.0), (4, -0.010, 1.0)):
        piece.co[low[k]] = piece.co[low[k]] * (1, pull, 1) + Z * lift
    crotch = piece.vertex((0, 0.008, 0.806))
    for side in (1, -1):
        order = ([0, 1, 2, 3, None, 9, 10, 11] if side > 0
                 else [None, 3, 4, 5, 6, 7, 8, 9])
        ring = [crotch if k is None else low[k] for k in order]
        for i, row in enumerate(LEG + CUFF):
            below = leg_ring(piece, row, side)
            piece.bridge(below, ring,
                         "cuff" if i > len(LEG) else "trousers")
            ring = below
    return piece.subdivided()


def make_sock():
    """The left sock, a plain tube between cuff and shoe."""
    piece = Piece()
    before = None
    for z, r in ((0.162, 0.039), (0.074, 0.031)):
        ring = piece.vertices(ring_points((0.098, 0.015, z), X, Y,
                                          (r, r, r * 1.1), 10))
        if before:
            piece.bridge(ring, before, "sock")
        before = ring
    return piece


# --- belt -------------------------------------------------------------------

BELT_Z = 1.004


def outline(pieces, z, angle):
    """The distance of the outermost piece from the axis."""
    ray = np.array([np.cos(angle), np.sin(angle), 0.0])
    far = Vector(ray * 0.5 + Z * z)
    best = 0.0
    for tree in pieces:
        hit = tree.ray_cast(far, Vector(-ray))[0]
        if hit is not None:
            best = max(best, float(np.hypot(hit.x, hit.y)))
    return best


def tree_of(piece):
    return BVHTree.FromPolygons([tuple(c) for c in piece.co], piece.faces)


def make_belt(shirt, trousers, columns=24):
    """A strap around the waist, with texture coordinates along it."""
    trees = [tree_of(shirt), tree_of(trousers)]
    piece = Piece()
    rows = [(-0.0190, -0.004, 0.0), (-0.0205, 0.0060, 0.06),
            (0, 0.0090, 0.5), (0.0205, 0.0060, 0.94), (0.0190, -0.004, 1.0)]
    rings = []
    for dz, out, _ in rows:
        ring = []
        for k in range(columns):
            # turned by half a step, so that a quad has its middle in front
            a = 2 * np.pi * (k + 0.5) / columns + np.pi / 2
            r = outline(trees, BELT_Z + dz * 0.95, a) + out
            ring.append((r * np.cos(a), r * np.sin(a), BELT_Z + dz))
        rings.append(piece.vertices(ring))
    for i in range(len(rows) - 1):
        piece.bridge(rings[i], rings[i + 1], "belt", u=(0, 6),
                     v=(rows[i][2], rows[i + 1][2]))
    return piece


def make_buckle(belt):
    """A rounded frame with a prong, on the front of the belt."""
    front = min(c[1] for c in belt.co)
    piece = Piece()
    n, rings = 12, []
    for dx, dz, dy in ((0.0290, 0.0265, 0.0), (0.0250, 0.0225, -0.0050),
                       (0.0195, 0.0170, -0.0050), (0.0165, 0.0140, 0.0)):
        points = ring_points((0, front - 0.001 + dy, BELT_Z), X, Z,
                             (dx, dz, dz), n, turn=15, power=5)
        rings.append(piece.vertices(points))
    for a, b in zip(rings, rings[1:]):
        piece.bridge(a, b, "brass")
    y = front - 0.0065
    prong = piece.vertices([(-0.022, y, BELT_Z - 0.0030),
                            (0.020, y, BELT_Z - 0.0030),
                            (0.020, y, BELT_Z + 0.0030),
                            (-0.022, y, BELT_Z + 0.0030)])
    piece.face(prong, "brass")
    return piece


# --- arm and hand -----------------------------------------------------------

ARM = [  # along the arm from the shoulder, half depth, half height
    (0.150, 0.043, 0.043),
    (0.228, 0.039, 0.038),
    (0.262, 0.037, 0.036),
    (0.298, 0.039, 0.037),
    (0.365, 0.037, 0.034),
    (0.474, 0.0270, 0.0230),
]
PALM = [  # along the hand, half width, half thickness
    (0.020, 0.0290, 0.0175),
    (0.054, 0.0385, 0.0165),
    (0.088, 0.0400, 0.0135),
]
FINGER = [  # length, knuckle forward, spread in degrees; the little finger first
    (0.055, -0.007, 6.0),
    (0.068, 0.000, 2.0),
    (0.074, 0.003, -2.0),
    (0.066, 0.001, -5.5),
]


def arm_frame(s):
    """Centre and direction at s metres from the shoulder."""
    t = float(smoothstep(rig.UPPER_ARM - 0.04, rig.UPPER_ARM + 0.04, s))
    direction = unit(rig.ARM_DIR * (1 - t) + rig.FORE_DIR * t)
    if s < rig.UPPER_ARM:
        return rig.SHOULDER + rig.ARM_DIR * s, direction
    return rig.ELBOW + rig.FORE_DIR * (s - rig.UPPER_ARM), direction


def palm_ring(s, w, h):
    """Five points along the back of the hand, five along the palm."""
    center = rig.WRIST + rig.FORE_DIR * s
    out = []
    for sign, order in ((1, range(5)), (-1, range(4, -1, -1))):
        for i in order:
            side = 1 - i / 2
            arch = h * (1.0 - 0.22 * side * side)
            lean = 0.004 * (1 - side * side) * (s > 0.08)
            out.append(center + rig.FORE_SIDE * side * w * 1.06
                       + rig.ARM_UP * sign * arch * 1.12
                       + rig.FORE_DIR * lean)
    return out


def square(center, a, b, ra, rb):
    """Four corners, at 45, 135, 225 and 315 degrees from a to b."""
    return [center + a * ra * x + b * rb * y
            for x, y in ((1, 1), (-1, 1), (-1, -1), (1, -1))]


def add_finger(piece, base, root, length, spread):
    direction = unit(rig.FORE_DIR * np.cos(spread)
                     + rig.FORE_SIDE * np.sin(spread))
    side = unit(np.cross(rig.ARM_UP, direction))
    up = np.cross(direction, side)
    center, before, step = root, base, 0.0
    for f, radius, curl in ((0.16, 0.0094, 6), (0.56, 0.0088, 14),
                            (1.0, 0.0072, 22)):
        c, s = np.cos(np.radians(curl)), np.sin(np.radians(curl))
        ahead = direction * c - up * s
        center = center + ahead * length * (f - step)
        step = f
        ring = piece.vertices(square(center, side, up * c + direction * s,
                                     radius, radius * 1.05))
        piece.bridge(before, ring, "skin")
        piece.mark("fingers", ring, 0.75 if f < 0.2 else 1)
        before = ring
    piece.face(before, "skin")


def add_thumb(piece, base):
    across = unit(np.cross(rig.ARM_UP, rig.THUMB_DIR))
    before = base
    for f, radius in ((0.30, 0.0135), (0.66, 0.0110), (1.0, 0.0085)):
        center = rig.THUMB_ROOT + rig.THUMB_DIR * 0.062 * f
        # corners: above and below on the wrist's side, then below and above
        # on the palm's
        ring = piece.vertices([
            center + across * radius * x + rig.ARM_UP * radius * y
            for x, y in ((-1, 1), (-1, -1), (1, -1), (1, 1))])
        piece.bridge(before, ring, "skin")
        piece.mark("thumb", ring, 0.6 if f < 0.5 else 1)
        before = ring
    piece.face(before, "skin")


def make_arm():
    """The left arm from inside the sleeve, with the hand."""
    piece = Piece()
    f = rounding(8)
    before = None
    for s, depth, height in ARM:
        center, direction = arm_frame(s)
        ring = piece.vertices(ring_points(
            center, np.cross(rig.ARM_UP, direction), rig.ARM_UP,
            (depth * f, height * f, height * f), 8, turn=22.5))
        if before:
            piece.bridge(before, ring, "skin")
        before = ring
    w, p = before, piece.vertices(palm_ring(*PALM[0]))
    for face in ((w[0], w[1], p[1], p[0]), (w[1], w[2], p[3], p[2], p[1]),
                 (w[2], w[3], p[4], p[3]), (w[3], w[4], p[5], p[4]),
                 (w[4], w[5], p[6], p[5]), (w[5], w[6], p[8], p[7], p[6]),
                 (w[6], w[7], p[9], p[8]), (w[7], w[0], p[0], p[9])):
        piece.face(face, "skin")
    for i, row in enumerate(PALM[1:]):
        q = piece.vertices(palm_ring(*row))
        piece.bridge(p, q, "skin", skip=() if i else (4,))
        if i == 0:
            add_thumb(piece, [p[4], p[5], q[5], q[4]])
        p = q
    for i, (length, forward, spread) in enumerate(FINGER):
        base = [p[i], p[i + 1], p[8 - i], p[9 - i]]
        root = np.mean([piece.co[v] for v in base], axis=0)
        root = root + rig.FORE_DIR * forward
        add_finger(piece, base, root, length, np.radians(spread))
    piece.mark("fingers", p, 0.3)
    return piece.subdivided()


# --- shoe -------------------------------------------------------------------

SHOE_WIDTH = [(0, 0.036), (0.25, 0.0355), (0.5, 0.0385), (0.72, 0.0475),
              (0.9, 0.045), (1, 0.040)]
HEEL_Y, TIP_Y = 0.082, -0.204
COLUMNS = 16


def sole_point(k, inset):
    """A point of the sole's outline (x, y) and its position, heel 0 .. tip 1."""
    a = 2 * np.pi * (k + 0.5) / COLUMNS
    c, s = np.cos(a), np.sin(a)
    along = np.sign(c) * abs(c) ** 0.86
    t = (1 + along) / 2
    half = float(curve(SHOE_WIDTH, t)[0]) - inset
    x = np.sign(s) * abs(s) ** 0.72 * half
    length = (HEEL_Y - TIP_Y) / 2 - inset
    y = (HEEL_Y + TIP_Y) / 2 - along * length
    toes = smoothstep(0.45, 1.0, t)
    return np.array([0.103 + x - 0.007 * toes + 0.004 * np.sin(t * np.pi), y,
                     0.0]), t


def shoe_ring(f, inset):
    """A ring of the shoe; f is 0 at the sole, 1 at the opening."""
    out = []
    for k in range(COLUMNS):
        low, t = sole_point(k, inset)
        a = 2 * np.pi * (k + 0.5) / COLUMNS
        top = np.array([0.099 + 0.0425 * np.sin(a), 0.018 - 0.050 * np.cos(a),
                        0.0])
        g = f ** (1.0 + 0.35 * smoothstep(0.75, 1.0, t))
        p = low * (1 - g) + top * g
        rise = f ** (1.0 - 0.28 * smoothstep(0.55, 1.0, t))
        base = 0.030 + 0.006 * smoothstep(0.4, 0, t)
        high = 0.104 + 0.012 * smoothstep(0.35, 0.0, t) + 0.010 * smoothstep(
            0.6, 1.0, t)
        bulge = 0.006 * np.sin(np.pi * f) * smoothstep(0.95, 0.6, t)
        p[0] += np.sign(np.sin(a)) * bulge
        p[2] = base + (high - base) * rise
        out.append(p)
    return out


def make_shoe():
    """The left shoe: a pale sole, a coloured upper, a toe cap, laces."""
    piece = Piece()

    def sole_ring(z, inset):
        out = []
        for k in range(COLUMNS):
            p, t = sole_point(k, inset)
            spring = 0.012 * smoothstep(0.74, 1.0, t)
            heel = 0.006 * smoothstep(0.4, 0, t)
            out.append(p + Z * (z * (1 + heel / 0.03) + spring))
        return piece.vertices(out)

    def toe_lift(points):
        out = []
        for k, p in enumerate(points):
            t = sole_point(k, 0)[1]
            lift = 0.012 * smoothstep(0.74, 1.0, t)
            out.append(p + Z * lift * smoothstep(-0.10, -0.19, p[1]))
        return out

    sole = [sole_ring(0.0, 0.006), sole_ring(0.006, 0.0005),
            sole_ring(0.030, 0.0)]
    sole.append(sole_ring(0.032, 0.006))
    piece.face(sole[0][::-1], "sole")
    for a, b in zip(sole, sole[1:]):
        piece.bridge(a, b, "sole")
    steps = (0.0, 0.20, 0.44, 0.72, 1.0)
    rings = [piece.vertices(toe_lift(shoe_ring(f, 0.004))) for f in steps]
    middle = np.array([0.099, 0.018, 0.0])
    lining = []
    for v in rings[-1]:
        p = piece.co[v]
        lining.append(p * (0.7, 0.7, 1) + middle * 0.3 - Z * 0.020)
    lining = piece.vertices(lining)
    for i, (a, b) in enumerate(zip(rings, rings[1:])):
        for k in range(COLUMNS):
            m = (k + 1) % COLUMNS
            off = min(k + 1, COLUMNS - 1 - k)  # columns away from the front
            region = "upper"
            if i < 2 and off <= 2:
                region = "toecap"
            elif i >= 2 and k == COLUMNS - 1:
                region = "tongue"
            elif 6 <= k <= 8 and i >= 2:
                region = "heel"
            piece.face((a[k], a[m], b[m], b[k]), region)
    piece.bridge(rings[-1], lining, "lining")
    add_laces(piece, rings)
    return piece


def add_laces(piece, rings):
    """Three bars across the tongue."""
    last = COLUMNS - 1
    low, high = rings[2], rings[4]
    left = np.array([piece.co[low[0]], piece.co[high[0]]])
    right = np.array([piece.co[low[last]], piece.co[high[last]]])
    mid = rings[3]
    for f in (0.12, 0.40, 0.68):
        ends = []
        for col, pair in ((0, left), (last, right)):
            m = piece.co[mid[col]]
            line = (pair[0] * (1 - 2 * f) + m * 2 * f if f < 0.5
                    else m * (2 - 2 * f) + pair[1] * (2 * f - 1))
            ends.append(line)
        across = unit(ends[0] - ends[1])
        along = unit(np.array([0, 1, 0.55]))
        up = unit(np.cross(across, along))
        up = up * np.sign(up[2])
        a, b = ends[1] - across * 0.006, ends[0] + across * 0.006
        middle = (a + b) / 2 + up * 0.0055
        rows = []
        for p in (a, middle, b):
            rows.append(piece.vertices([p - along * 0.0065 - up * 0.003,
                                        p + up * 0.0045,
                                        p + along * 0.0065 - up * 0.003]))
        for r, q in zip(rows, rows[1:]):
            for i in range(2):
                piece.face((r[i], q[i], q[i + 1], r[i + 1]), "lace")
