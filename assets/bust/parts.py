"""All parts but the skin: eyes, brows, ears, teeth, tongue, hair, shirt.

A part is a list of faces, an sRGB colour for each vertex, and a function from
an expression to its vertices.
"""

import numpy as np

from . import motion, skin, surface


def rgb(text):
    return np.array([int(text[i : i + 2], 16) / 255 for i in (1, 3, 5)])


COLORS = {name: rgb(text) for name, text in {
    "skin": "#f2ba94", "blush": "#ea8f78", "lip": "#d57c6f",
    "lipdark": "#ac5047", "gum": "#7d2630", "throat": "#3d0f16",
    "lash": "#2b1812", "lidpink": "#dd9280", "shade": "#cf8b6c",
    "white": "#fbf7f2", "limbus": "#1f4a3f", "iris": "#3f8a72",
    "irislight": "#7cc4a0", "pupil": "#120d0c", "glint": "#ffffff",
    "brow": "#5a2e1c", "hair": "#9c4e26", "hairdark": "#6c3216",
    "hairlight": "#cb7a48", "tooth": "#fdf8ec", "tongue": "#d9646a",
    "shirt": "#1d8a8a", "collar": "#f6ead0", "shirtdark": "#14696b",
}.items()}


class Part:
    def __init__(self, name, face, color, points):
        self.name, self.face = name, [list(f) for f in face]
        self.color, self.points = np.array(color), points


def still(name, points, face, color):
    points = np.array(points)
    return Part(name, face, color, lambda what: points)


def mirrored(points, face):
    return points * (-1, 1, 1), [f[::-1] for f in face]


def strip(rows, count, closed=True):
    """Faces between rows of count vertices each, numbered row by row."""
    face = []
    for r in range(rows - 1):
        for k in range(count if closed else count - 1):
            n = (k + 1) % count
            face.append([r * count + k, (r + 1) * count + k,
                         (r + 1) * count + n, r * count + n])
    return face


# --- skin colours -----------------------------------------------------------


def skin_colors(body):
    p = body.point
    x, y, z = np.abs(p[:, 0]), p[:, 1], p[:, 2]
    c = np.tile(COLORS["skin"], (len(p), 1))

    def tint(name, amount):
        nonlocal c
        amount = np.clip(amount, 0, 1)[:, None]
        c = c + (COLORS[name] - c) * amount

    front = z > 0.2
    blob = np.exp(-((x - 0.44) / 0.15) ** 2 - ((y + 0.37) / 0.11) ** 2)
    tint("blush", 0.55 * blob * front)
    tip = np.exp(-(x / 0.11) ** 2 - ((y + 0.31) / 0.08) ** 2)
    tint("blush", 0.40 * tip * (z > 0.85))
    nostril = np.exp(-((x - 0.055) / 0.03) ** 2 - ((y + 0.385) / 0.025) ** 2)
    tint("lipdark", 0.4 * nostril * front)
    shades = {"back": ("throat", 1), "deep": ("throat", 1),
              "inside": ("gum", 1), "wet": ("lipdark", 1),
              "part": ("lipdark", 0.75), "crest": ("lip", 0.85),
              "border": ("lip", 0.7), "outside": ("lip", 0.04)}
    for name, ring in zip(skin.LIPS, body.lip_rings):
        color, amount = shades[name]
        c[ring] += (COLORS[color] - c[ring]) * amount
    c[body.back] = COLORS["throat"]
    angle = 2 * np.pi * np.arange(32) / 32
    upper = np.clip(np.sin(angle) * 3 + 0.45, 0, 1)[:, None]
    for rings in body.eye_rings.values():
        for k, ring in enumerate(rings[:4]):
            dark, pink = ((1, 0.6), (1, 0.35), (1, 0.12), (0.25, 0.03))[k]
            low = c[ring] + (COLORS["lidpink"] - c[ring]) * pink
            c[ring] = low + (COLORS["lash"] - low) * dark * upper
        for k, amount in ((4, 0.30), (5, 0.22)):
            ring = rings[k]
            c[ring] += (COLORS["shade"] - c[ring]) * amount * upper
    return c


# --- eyes -------------------------------------------------------------------

IRIS = 0.125  # radii on the eyeball's front, as seen from the front
PUPIL = 0.062
WHITE = np.array([0.245, 0.205])  # how far the eyeball's front goes
GAZE = np.array([0.345, -0.055])


def eye_rings():
    """(radius, colour) from the pupil outwards; equal radii make a sharp edge.

    The last three are fractions of WHITE.
    """
    return [(0, "pupil"), (PUPIL, "pupil"), (PUPIL, "limbus"),
            (PUPIL + 0.012, "iris"), (IRIS - 0.025, "iris"),
            (IRIS - 0.012, "limbus"), (IRIS, "limbus"),
            (IRIS + 0.005, "white"), (0.75, "white"), (0.88, "white"), (1, "white")]


def eyeball(side, sides=24):
    rings = eye_rings()
    color = [COLORS["pupil"]]
    for _, name in rings[1:]:
        color += [COLORS[name]] * sides
    color = np.array(color)
    # The lens lets light onto the lower half of the iris, which is brighter.
    angle = 2 * np.pi * (np.arange(sides) + 0.5) / sides
    for k, (radius, name) in enumerate(rings):
        if name == "iris":
            low = np.clip(-np.sin(angle), 0, 1)[:, None] * 0.85
            at = slice(1 + (k - 1) * sides, 1 + k * sides)
            color[at] += (COLORS["irislight"] - color[at]) * low
    face = [[0, 1 + k, 1 + (k + 1) % sides] for k in range(sides)]
    for r in range(len(rings) - 2):
        if rings[r + 1][0] == rings[r + 2][0]:
            continue
        for k in range(sides):
            a, b = 1 + r * sides + k, 1 + r * sides + (k + 1) % sides
            face.append([a, a + sides, b + sides, b])

    def points(what):
        eye = what.eye(side)
        middle = surface.EYE * (side, 1, 1)
        out = []
        for radius, name in rings:
            r, share = np.array([radius, radius]) * eye.iris, 1.0
            if radius > IRIS + 0.006:
                r, share = radius * WHITE, 1 - radius
            at = skin.EYE_MIDDLE + (GAZE - skin.EYE_MIDDLE) * share
            at = at * (side, 1) + np.array(eye.look) * share
            ring = at + r * np.stack([np.cos(angle), np.sin(angle)], 1)
            if radius == 0:
                ring = at[None]
            flat = ring - middle[:2]
            z = np.sqrt(np.maximum(
                surface.EYE_RADIUS**2 - (flat**2).sum(axis=1), 1e-4))
            out.append(np.concatenate([ring, middle[2] + z[:, None]], axis=1))
        return np.concatenate(out)

    return Part("eye", face, color, points)


def glint(side, sides=10):
    """The highlight in an eye, on the same side in both eyes."""
    spots = ((0.042, 0.048, 0.030), (-0.045, -0.045, 0.013))
    face, color = [], []
    for k in range(len(spots)):
        start = k * (sides + 1)
        face += [[start, start + 1 + i, start + 1 + (i + 1) % sides]
                 for i in range(sides)]
        color += [COLORS["glint"]] * (sides + 1)

    def points(what):
        eye = what.eye(side)
        middle = surface.EYE * (side, 1, 1)
        angle = 2 * np.pi * np.arange(sides) / sides
        out = []
        for dx, dy, radius in spots:
            at = GAZE * (side, 1) + np.array(eye.look) + (dx, dy)
            ring = at + radius * np.stack([np.cos(angle), np.sin(angle)], 1)
            ring = np.concatenate([at[None], ring])
            flat = ring - middle[:2]
            z = middle[2] + np.sqrt(
                (surface.EYE_RADIUS + 0.006) ** 2 - (flat**2).sum(axis=1))
            out.append(np.concatenate([ring, z[:, None]], axis=1))
        return np.concatenate(out)

    return Part("glint", face, color, points)


# --- brows ------------------------------------------------------------------


def brow(side, steps=11, sides=6):
    t = np.linspace(0, 1, steps)
    half = 0.034 * (1 - t) ** 0.35 * (1 - 0.35 * t) + 0.004
    half[0] *= 0.72
    angle = 2 * np.pi * np.arange(sides) / sides
    face = strip(steps, sides)
    face.append(list(range(sides)))
    face.append([(steps - 1) * sides + k for k in range(sides)][::-1])
    color = np.tile(COLORS["brow"], (steps * sides, 1))

    def points(what):
        path = motion.brow_curve(t) + motion.brow_shift(what.brow(side), t)
        rest = surface.from_front(motion.brow_curve(t))
        ground = surface.from_front(path)
        # Where the skin falls back, a moved brow falls back half as far, as if
        # it took the bulge along.
        z = np.maximum(ground[:, 2], 0.5 * (ground[:, 2] + rest[:, 2]))
        z = z + 0.012
        along = np.gradient(path, axis=0)
        along /= np.linalg.norm(along, axis=1)[:, None]
        across = np.stack([-along[:, 1], along[:, 0]], axis=1)
        out = np.zeros((steps, sides, 3))
        for k, a in enumerate(angle):
            out[:, k, :2] = path + across * (half * np.cos(a))[:, None]
            out[:, k, 2] = z + 0.75 * half * np.sin(a)
        return out.reshape(-1, 3) * (side, 1, 1)

    if side > 0:
        face = [f[::-1] for f in face]
    return Part("brow", face, color, points)


# --- teeth and tongue -------------------------------------------------------


def upper_teeth(count=15):
    x = np.linspace(-0.25, 0.25, count)
    ground = surface.from_front(
        np.stack([x, np.full(count, -0.57)], axis=1))[:, 2]
    arch = ground - 0.085 - 0.5 * np.clip(np.abs(x) - 0.17, 0, 1) ** 1.5
    round_off = 0.012 * (np.abs(x) / 0.25) ** 2
    rows = [(-0.46, -0.02), (-0.54, 0.0), (-0.605, -0.006),
            (-0.622, -0.022), (-0.62, -0.05), (-0.54, -0.08)]
    points = [np.stack([x * (1 + 1.2 * dz), y + round_off * (y < -0.58),
                        arch + dz], axis=1) for y, dz in rows]
    face = strip(len(rows), count, closed=False)
    color = np.tile(COLORS["tooth"], (count * len(rows), 1))
    return still("teeth", np.concatenate(points), face, color)


def tongue(around=18, rings=7):
    middle, size = np.array([0, -0.70, 0.46]), np.array([0.17, 0.075, 0.26])
    angle = 2 * np.pi * np.arange(around) / around
    out = [[[0, 0, 1.0]]]
    for r in range(1, rings):
        a = np.pi * 0.62 * r / (rings - 1)
        out.append(np.stack([np.sin(a) * np.cos(angle),
                             np.sin(a) * np.sin(angle),
                             np.full(around, np.cos(a))], axis=1))
    unit = np.concatenate(out)
    groove = np.exp(-((unit[:, 0] / 0.3) ** 2))
    unit[:, 1] -= 0.1 * groove * np.clip(2 * unit[:, 1], 0, 1)
    rest = middle + unit * size
    face = [[0, 1 + k, 1 + (k + 1) % around] for k in range(around)]
    for r in range(rings - 2):
        for k in range(around):
            a, b = 1 + r * around + k, 1 + r * around + (k + 1) % around
            face.append([a, a + around, b + around, b])
    color = np.tile(COLORS["tongue"], (len(rest), 1))
    return Part("tongue", face, color,
                lambda what: skin.open_jaw(rest, what.mouth.jaw, 0.9)
                + np.array([0, 0, 0.3 * what.mouth.forward]))


# --- ears -------------------------------------------------------------------


def ear(side, count=18):
    angle = 2 * np.pi * np.arange(count) / count  # 0 towards the back
    outline = np.stack([
        0.14 * np.cos(angle) * (1 + 0.25 * np.sin(angle)),
        0.215 * np.sin(angle) * (1 - 0.06 * np.cos(angle))], axis=1)
    rings = [(0.30, 0.018, "shade"), (0.52, 0.03, "shade"),
             (0.70, 0.062, "blush"), (0.86, 0.078, "skin"),
             (1.00, 0.060, "skin"), (0.98, 0.020, "skin"),
             (0.62, -0.08, "skin")]
    flat = [np.array([[0, 0, 0.012]])]
    color = [COLORS["shade"]]
    for size, height, name in rings:
        flat.append(np.concatenate(
            [outline * size, np.full((count, 1), height)], axis=1))
        mix = 0.5 if name == "blush" else 1.0
        color += [COLORS["skin"] + (COLORS[name] - COLORS["skin"]) * mix
                  * 0.75] * count
    flat = np.concatenate(flat)
    # Converts ear space (back, up, out) to the head's; the ear tilts out and back.
    lean, open_ = np.radians(-12), np.radians(38)
    b = flat[:, 0] * np.cos(lean) - flat[:, 1] * np.sin(lean)
    up = flat[:, 0] * np.sin(lean) + flat[:, 1] * np.cos(lean)
    out = flat[:, 2] * np.cos(open_) + (b + 0.06) * np.sin(open_)
    back = b * np.cos(open_) - flat[:, 2] * np.sin(open_)
    points = np.stack([0.775 + out, -0.14 + up, -0.06 - back], axis=1)
    face = [[0, 1 + (k + 1) % count, 1 + k] for k in range(count)]
    face += [[v + 1 for v in f[::-1]] for f in strip(len(rings), count)]
    if side < 0:
        points, face = mirrored(points, face)
    return still("ear", points, [f[::-1] for f in face], color)


# --- shirt ------------------------------------------------------------------


def shirt(count=30):
    angle = 2 * np.pi * np.arange(count) / count
    # y, half-width, half-depth, z of the middle, exponent of the superellipse
    # (2: an ellipse, more: squarer), colour
    rows = [(-1.25, 0.32, 0.32, -0.20, 2.0, "shirtdark"),
            (-1.185, 0.385, 0.39, -0.19, 2.0, "collar"),
            (-1.145, 0.41, 0.415, -0.18, 2.0, "collar"),
            (-1.145, 0.45, 0.445, -0.18, 2.0, "collar"),
            (-1.20, 0.49, 0.475, -0.17, 2.0, "collar"),
            (-1.235, 0.485, 0.465, -0.17, 2.0, "shirtdark"),
            (-1.24, 0.53, 0.49, -0.17, 2.0, "shirt"),
            (-1.30, 0.70, 0.515, -0.17, 2.1, "shirt"),
            (-1.37, 0.88, 0.53, -0.17, 2.3, "shirt"),
            (-1.48, 1.04, 0.53, -0.17, 2.5, "shirt"),
            (-1.64, 1.13, 0.54, -0.17, 2.6, "shirt"),
            (-2.00, 1.15, 0.55, -0.17, 2.6, "shirt"),
            (-2.05, 1.10, 0.51, -0.17, 2.6, "shirtdark")]
    points, color = [], []
    for y, width, depth, z, square, name in rows:
        c, s = np.cos(angle), np.sin(angle)
        x = width * np.sign(s) * np.abs(s) ** (2 / square)
        front = depth * np.sign(c) * np.abs(c) ** (2 / square)
        dip = -0.06 * np.clip(c, 0, 1) ** 2 * (y > -1.3)
        points.append(np.stack([x, y + dip, z + front], axis=1))
        color += [COLORS[name]] * count
    return still("shirt", np.concatenate(points), strip(len(rows), count),
                 color)
