"""The skin: a grid around the head with rings for eyes and mouth.

The grid has columns (heading) and rows (elevation). Blocks of it are replaced
by rings with as many vertices as the border of the block. Lids and lips are
thus loops that an expression can move.
"""

import numpy as np

from . import surface

# Columns from the middle to the back: first by x at eye height, then by
# heading in degrees.
FRONT_X = (0, 0.038, 0.078, 0.125, 0.19, 0.255, 0.315, 0.375, 0.435, 0.495,
           0.56, 0.63)
SIDE_DEG = (54, 63, 73, 84, 98, 116, 137, 158, 180)
COLUMNS = len(FRONT_X) + len(SIDE_DEG) - 1  # on each side of the middle
# Rows from the forehead to the chin, by their y in front.
FRONT_Y = (0.56, 0.48, 0.40, 0.32, 0.25, 0.175, 0.10, 0.03, -0.04, -0.105,
           -0.165, -0.22, -0.275, -0.325, -0.37, -0.41, -0.45, -0.50, -0.55,
           -0.60, -0.655, -0.71, -0.77, -0.83, -0.90)
# Rows below them: y and z where the rays start; their elevation in degrees in
# front and at the back.
BELOW = ((-0.15, -0.05, -50, -44), (-0.22, -0.05, -56, -43),
         (-0.40, -0.08, -57, -38), (-0.60, -0.12, -50, -29),
         (-0.78, -0.15, -39, -18), (-0.92, -0.17, -27, -11),
         (-1.06, -0.18, -14, -4), (-1.20, -0.20, -3, 0), (-1.34, -0.21, 0, 0))
EYE_ROWS, EYE_COLUMNS = (4, 12), (3, 11)
MOUTH_ROWS, MOUTH_COLUMNS = (16, 22), (-7, 7)
EYE_FILL = (0.0, 0.04, 0.07, 0.25, 0.5, 0.75)  # edge ... towards the block
MOUTH_FILL = (0.3, 0.6, 0.82)
EYE_SIDES = (1, -1)


def block_loop(rows, columns, mirrored=False):
    """The grid points around a block.

    Starts in the middle of the outer side (+X, or -X when mirrored) and goes
    up first.
    """
    (top, bottom), (near, far) = rows, columns
    middle = (top + bottom) // 2
    loop = [(r, far) for r in range(middle, top, -1)]
    loop += [(top, c) for c in range(far, near, -1)]
    loop += [(r, near) for r in range(top, bottom)]
    loop += [(bottom, c) for c in range(near, far)]
    loop += [(r, far) for r in range(bottom, middle, -1)]
    return [(r, -c) for r, c in loop] if mirrored else loop


class Skin:
    """The skin at rest and its loops.

    point     [vertex][3]
    face      lists of vertices, facing outwards
    eye_rings {side: [ring][32]}, from the rim on the eyeball outwards; the
              last ring lies on the grid; each starts at the outer corner
    lip_rings [ring][40], from the back of the mouth outwards, likewise from
              the left corner over the upper lip
    """

    def __init__(self, rest):
        self.points, self.face = [], []
        self.grid = {}
        self.make_grid()
        self.eye_rings = {}
        for side in EYE_SIDES:
            self.cut_eye(side, rest)
        self.cut_mouth(rest)
        self.point = np.array(self.points)
        self.drop_hidden()
        self.drop_unused()
        self.relax()

    def add(self, points):
        start = len(self.points)
        self.points += [np.array(p) for p in points]
        return list(range(start, len(self.points)))

    def make_grid(self):
        x = np.array(FRONT_X)
        z = surface.from_front(
            np.stack([x, np.full_like(x, -0.06)], 1), surface.skull)[:, 2]
        heading = np.concatenate([
            np.arctan2(x, z - surface.ORIGIN[2]), np.radians(SIDE_DEG)])
        elevation = np.arctan2(np.array(FRONT_Y) - surface.ORIGIN[1], 0.87)
        rows = [(surface.ORIGIN, e, e) for e in elevation]
        rows += [(np.array((0, y, z)), np.radians(front), np.radians(back))
                 for y, z, front, back in BELOW]
        self.row_count = len(rows)
        signed = range(-COLUMNS + 1, COLUMNS + 1)
        h = np.array([np.sign(c) * heading[abs(c)] for c in signed])
        behind = (1 - np.cos(h)) / 2
        for r, (origin, front, back) in enumerate(rows):
            e = front + behind * (back - front)
            hit = surface.from_around(
                surface.direction(h, e), surface.head, origin)
            for c, number in zip(signed, self.add(hit)):
                self.grid[r, c] = number
            self.grid[r, -COLUMNS] = self.grid[r, COLUMNS]
        for c in (0, COLUMNS):
            for r in range(self.row_count):
                self.points[self.grid[r, c]][0] = 0
        for r in range(self.row_count - 1):
            for c in range(-COLUMNS, COLUMNS):
                if not self.in_block(r, c):
                    self.face.append([
                        self.grid[r, c], self.grid[r + 1, c],
                        self.grid[r + 1, c + 1], self.grid[r, c + 1]])

    def in_block(self, r, c):
        def within(rows, columns, c):
            return (rows[0] <= r < rows[1]) and columns[0] <= c < columns[1]

        return (within(EYE_ROWS, EYE_COLUMNS, c)
                or within(EYE_ROWS, EYE_COLUMNS, -c - 1)
                or within(MOUTH_ROWS, MOUTH_COLUMNS, c))

    def bridge(self, inner, outer, flip):
        n = len(inner)
        for k in range(n):
            quad = [inner[k], outer[k], outer[(k + 1) % n],
                    inner[(k + 1) % n]]
            self.face.append(quad[::-1] if flip else quad)

    def cut_eye(self, side, rest):
        loop = [self.grid[p] for p in
                block_loop(EYE_ROWS, EYE_COLUMNS, side < 0)]
        border = np.array([self.points[v] for v in loop])
        rings = [self.add(ring) for ring in lid_rings(rest, side, border)]
        rings.append(loop)
        for inner, outer in zip(rings, rings[1:]):
            self.bridge(inner, outer, side < 0)
        self.eye_rings[side] = rings

    def cut_mouth(self, rest):
        loop = [self.grid[p] for p in block_loop(MOUTH_ROWS, MOUTH_COLUMNS)]
        border = np.array([self.points[v] for v in loop])
        lips = lip_loops(rest)
        edge = lips[-1]
        fill = []
        for f in MOUTH_FILL:
            xy = (1 - f) * edge[:, :2] + f * border[:, :2]
            fill.append(surface.from_front(xy))
        rings = [self.add(ring) for ring in lips + fill] + [loop]
        for inner, outer in zip(rings, rings[1:]):
            self.bridge(inner, outer, False)
        back = self.add([np.mean(lips[0], axis=0)])[0]
        n = len(loop)
        for k in range(n):
            self.face.append([back, rings[0][k], rings[0][(k + 1) % n]])
        self.lip_rings, self.lip_count, self.back = rings, len(lips), back

    def drop_hidden(self, margin_deg=14):
        """Removes the scalp that is well under the hair."""
        d = self.point - surface.ORIGIN
        heading = np.arctan2(d[:, 0], d[:, 2])
        elevation = np.arctan2(d[:, 1], np.hypot(d[:, 0], d[:, 2]))
        limit = surface.hairline(heading) + np.radians(margin_deg)
        hidden = elevation > limit
        self.face = [f for f in self.face if not all(hidden[v] for v in f)]

    def drop_unused(self):
        used = sorted({v for f in self.face for v in f})
        number = {v: k for k, v in enumerate(used)}
        self.point = self.point[used]
        self.face = [[number[v] for v in f] for f in self.face]
        self.eye_rings = {s: [[number[v] for v in ring] for ring in rings]
                          for s, rings in self.eye_rings.items()}
        self.lip_rings = [[number[v] for v in ring] for ring in self.lip_rings]
        self.back = number[self.back]
        self.grid = {p: number[v] for p, v in self.grid.items() if v in number}

    def edges(self):
        """Pairs of neighbouring vertices, each pair once, [edge][2]."""
        pairs = {(min(a, b), max(a, b)) for f in self.face
                 for a, b in zip(f, f[1:] + f[:1])}
        return np.array(sorted(pairs))

    def relax(self, rounds=8):
        """Smooths the mesh of the front, except lids and lips."""
        p = self.point
        free = (p[:, 2] > 0.3) & (np.abs(p[:, 0]) < 0.7) & (p[:, 1] < 0.5)
        free &= p[:, 1] > -0.85
        for rings in self.eye_rings.values():
            free[np.concatenate(rings[:5])] = False
        free[np.concatenate(self.lip_rings[:self.lip_count])] = False
        free[self.back] = False
        a, b = self.edges().T
        n = len(p)
        degree = np.bincount(a, minlength=n) + np.bincount(b, minlength=n)
        for _ in range(rounds):
            for k in (0, 1):
                near = (np.bincount(a, p[b, k], n)
                        + np.bincount(b, p[a, k], n)) / degree
                p[free, k] = 0.5 * p[free, k] + 0.5 * near[free]
            p[np.abs(p[:, 0]) < 1e-6, 0] = 0
        p[free] = surface.from_front(p[free, :2])


# --- eyes -------------------------------------------------------------------

EYE_MIDDLE = np.array([0.355, -0.06])
EYE_HALF_WIDTH = 0.205


def lid_edge(eye, side, count=32):
    """The opening of an eye as [count][2], from the outer corner upwards."""
    angle = 2 * np.pi * np.arange(count) / count
    s = np.cos(angle)  # 1 at the outer corner, -1 at the inner one
    upper = np.sin(angle) > 1e-9
    bow = np.maximum(1 - np.abs(s) ** 2.3, 0) ** 0.75
    level = 0.012 * s + eye.outer * np.clip(s, 0, 1) ** 2
    top = 0.138 * bow * (1 + 0.08 * s) + eye.tilt * s * bow
    bottom = -0.118 * bow * (1 + 0.12 * s) + eye.lower * bow
    shut = eye.bow * bow
    y = np.where(upper, shut + (top - shut) * eye.upper,
                 np.where(eye.upper < 0.5,
                          shut + (bottom - shut) * 2 * eye.upper, bottom))
    xy = np.stack([EYE_MIDDLE[0] + EYE_HALF_WIDTH * s,
                   EYE_MIDDLE[1] + level + y], axis=1)
    return xy * (side, 1)


def lid_rings(expression, side, border):
    """The rings of one eye but the last, which is the border.

    The lids slide over the dome that surface.head() puts over the eyeball, so
    they never touch the eyeball.
    """
    eye = expression.eye(side)
    n = len(border)
    edge = lid_edge(eye, side, n)
    angle = 2 * np.pi * np.arange(n) / n
    lash = np.clip(np.sin(angle) * 1.6 + 0.25, 0.12, 1)[:, None]
    rings = []
    for f in EYE_FILL:
        share = f if f > 0.1 else f * lash * 2.0
        ring = surface.from_front(edge + share * (border[:, :2] - edge))
        # Dark lashes stand out a little, most over the upper lid.
        if f <= 0.05:
            ring[:, 2] += 0.012 * lash[:, 0]
        rings.append(ring)
    rim = np.concatenate([edge, np.zeros((n, 1))], axis=1)
    middle = surface.EYE * (side, 1, 1)
    flat = rim[:, :2] - middle[:2]
    deep = (surface.EYE_RADIUS - 0.02) ** 2 - (flat**2).sum(axis=1)
    rim[:, 2] = middle[2] + np.sqrt(np.maximum(deep, 0.01))
    return [rim] + rings


# --- mouth ------------------------------------------------------------------

MOUTH_Y = -0.575
JAW = np.array([0, -0.30, -0.05])  # the hinge of the jaw
LIPS = ("back", "deep", "inside", "wet", "part", "crest", "border", "outside")


def open_jaw(points, degrees, weight):
    """Turns points about the jaw's hinge; positive opens."""
    a = np.radians(degrees) * weight
    q = points - JAW
    y = q[:, 1] * np.cos(a) - q[:, 2] * np.sin(a)
    z = q[:, 1] * np.sin(a) + q[:, 2] * np.cos(a)
    return np.stack([points[:, 0], y + JAW[1], z + JAW[2]], axis=1)


def lip_loops(expression, count=40):
    """The loops of LIPS, each [count][3], from the left corner upwards."""
    m = expression.mouth
    angle = 2 * np.pi * np.arange(count) / count
    t = np.sin(angle)
    # s runs from 1 (left corner) to -1; its steps are the mean of equal steps
    # along the lip and of equal angles.
    even = 1 - 2 * np.arccos(np.cos(angle)) / np.pi
    s = 0.5 * (np.cos(angle) + even)
    upper = t > -1e-9
    sign = np.where(np.abs(t) < 1e-9, 0.0, np.sign(t))
    full = np.maximum(1 - np.abs(s) ** 2.4, 0) ** 0.7

    # The line where the lips meet while the jaw is closed.
    middle = np.where(upper, m.upper, m.lower)
    power = np.where(upper, m.upper_power, m.lower_power)
    curve = np.maximum(1 - np.abs(s) ** power, 0)
    y = MOUTH_Y + m.corner_y + (middle - m.corner_y) * curve
    part = np.stack([m.width * s, y], axis=1)

    bow = 0.014 * np.exp(-((s * m.width / 0.035) ** 2)) * upper
    thick = np.where(upper, 0.045, 0.06) * m.thick * full + 0.012 - bow
    out = np.stack([0.016 * s * (1 - full), sign * thick], axis=1)
    far = np.stack([0.03 * s * (1 - full), sign * 0.02], axis=1)
    depth = {"back": -0.50, "deep": -0.34, "inside": -0.15, "wet": -0.06,
             "part": -0.012, "crest": 0.022 + 0.018 * (~upper), "border": 0.008,
             "outside": 0.0}
    rise = {"back": 0.05, "deep": 0.13, "inside": 0.10, "wet": 0.018}
    weight = np.where(upper, 0.42 * (1 - full), 1 - 0.58 * (1 - full))
    loops = []
    for name in LIPS:
        xy = part.copy()
        if name in rise:
            xy[:, 1] += sign * rise[name] * full
            xy[:, 0] *= {"back": 0.6, "deep": 0.9}.get(name, 1.0)
        xy += {"crest": 0.5, "border": 1.0, "outside": 1.0}.get(name, 0) * out
        if name == "outside":
            xy += far
        # The vertices slide on the surface of the face at rest.
        ground = surface.from_front(
            np.stack([xy[:, 0], np.clip(xy[:, 1], -0.72, -0.46)], axis=1))
        loop = np.concatenate([xy, ground[:, 2:]], axis=1)
        amount = full if name == "border" else 1.0
        if name == "crest":
            amount = 0.2 + 0.8 * full
        loop[:, 2] += depth[name] * amount
        loop[:, 2] += m.forward * (0.55 + 0.45 * full) + m.corner_z * s * s
        loops.append(open_jaw(loop, m.jaw, weight))
    return loops
