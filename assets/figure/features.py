"""The positions of eyelids, lips and brows in an expression.

Metres in the head's own space (see rig.place_head), the figure's left side.
Rings of points run from the outer corner upwards (eye) and from the middle of
the upper lip over the corner to the middle of the lower lip (mouth).
"""

from dataclasses import dataclass

import numpy as np

from .head import EYE, Surface, make_skull
from .mesh import gauss, smoothstep, unit

EYE_WIDTH, EYE_TOP, EYE_BOTTOM = 0.0182, 0.0132, 0.0140
LID_COLUMNS = 14
UPPER = range(1, LID_COLUMNS // 2)  # columns of the upper lid
LASH = (0.0, 0.6, 1.1, 1.25, 1.2, 1.05, 0.75, 0.0)  # thickness, inner last
MOUTH_Z = 1.5090
LIP_COLUMNS = (0.0, 0.30, 0.58, 0.82, 1.0)
JAW = np.array([0, 0.006, 1.545])  # the hinge of the jaw
FRONT = Surface(make_skull(4))


@dataclass(frozen=True)
class Eye:
    upper: float = 1.0  # upper lid: 0 closed, 1 at rest, above 1 wide open
    lower: float = 0.0  # how far the middle of the lower lid is raised, in metres
    shut: float = 0.0   # fraction of the distance to the closed line
    tilt: float = 0.0   # how far the inner side of the upper lid is lowered, in metres


@dataclass(frozen=True)
class Brow:
    inner: float = 0.0  # metres up
    middle: float = 0.0
    outer: float = 0.0
    together: float = 0.0  # inner ends move towards each other


@dataclass(frozen=True)
class Mouth:
    width: float = 0.0250  # half of it
    corner: float = 0.0080  # above the middle of the line
    upper: float = 0.0  # the middle of the upper lip's edge up
    lower: float = 0.0
    thick: float = 1.0
    forward: float = 0.0
    jaw: float = 0.0  # degrees


def front(x, z):
    """The y of the skin at rest, without openings for eyes and mouth."""
    return np.array([FRONT.front(float(a), float(b)) for a, b in zip(x, z)])


# --- eyes -------------------------------------------------------------------

BALL_RADIUS = 0.040
BALL_AXIS = unit((0.38, -1, 0.0))
BALL_FRONT = np.array([EYE[0], front([EYE[0]], [EYE[2]])[0] - 0.0058, EYE[2]])
BALL = BALL_FRONT - BALL_AXIS * BALL_RADIUS


def dome(x, z, lift):
    """The y of a point lift metres in front of the eyeball."""
    r = BALL_RADIUS + lift
    flat = (np.asarray(x) - BALL[0]) ** 2 + (np.asarray(z) - BALL[2]) ** 2
    return BALL[1] - np.sqrt(r * r - flat)


def lid_columns():
    """Outer 1 .. inner -1, the fraction of the height, and its sign."""
    a = 2 * np.pi * np.arange(LID_COLUMNS) / LID_COLUMNS
    return np.cos(a), np.abs(np.sin(a)), np.sign(np.round(np.sin(a), 9))


def lid_edge(eye=Eye()):
    """The opening of the eye as x and z."""
    u, bow, sign = lid_columns()
    level = EYE[2] + 0.0012 * u
    closed = level - 0.0062 * (1 - u * u)
    top = level + EYE_TOP * bow - eye.tilt * bow * smoothstep(0.9, -0.7, u)
    bottom = level - EYE_BOTTOM * bow
    bottom += (closed - bottom) * eye.shut + eye.lower * bow
    z = np.where(sign > 0, closed + (top - closed) * eye.upper, bottom)
    return np.stack([EYE[0] + EYE_WIDTH * u, np.where(sign == 0, level, z)])


def lid_rings(eye=Eye()):
    """Rings of one eye by name, each [column][3].

    edge lies on the eyeball; ridge carries the lashes (upper lid); rim is
    where lashes or lid end; fold (upper lid) unfolds when the eye closes;
    crease lies on the skin and hardly moves. The lids slide in front of the
    eyeball, so that linear blends of two expressions stay outside it.
    """
    u, bow, sign = lid_columns()
    x, z = lid_edge(eye)
    up = sign > 0
    rest = lid_edge()
    out = np.stack([rest[0] - EYE[0], rest[1] - EYE[2]])
    out /= np.linalg.norm(out, axis=0)
    open_ = np.clip(eye.upper, 0, 1)
    ahead = np.where(up, out * open_ + np.array([[0], [1]]) * (1 - open_), out)
    ahead /= np.linalg.norm(ahead, axis=0)
    lash = np.zeros(LID_COLUMNS)
    lash[:len(LASH)] = LASH
    lash *= 0.0026 * (0.75 + 0.25 * open_)

    crease = rest + out * np.where(up, 0.0078, 0.0062)
    crease[1] += np.where(up, 0.0028 * (eye.upper - 1) * bow,
                          bow * (0.6 * eye.lower + 0.0020 * eye.shut))
    rim = np.stack([x, z]) + ahead * np.where(up, 0.0012 + lash, 0.0016)
    rim[:, 0] += (0.0044, 0.0016)  # the tip of the lashes
    rim[:, len(LASH) - 1] -= 0.0006 * out[:, len(LASH) - 1]
    fold = rim + (crease - rim) * 0.45
    ridge = np.stack([x, z]) + ahead * 0.0010
    edge = np.stack([x, z]) - ahead * np.where(up, 0.0012, 0.0)
    behind = np.where(up, 0, 0.0012) * eye.shut  # the upper lid
    rings = {"edge": (edge, np.where(up, 0.0013, 0.0009) - behind),
             "ridge": (ridge, 0.0032), "rim": (rim, 0.0019 - behind),
             "fold": (fold, 0.0017), "crease": (crease, None)}
    return {n: on_eye(*ring) for n, ring in rings.items()}


def on_eye(xz, lift):
    """Puts x and z on the skin, or on the eyeball where that protrudes."""
    y = front(*xz)
    if lift is not None:
        y = np.minimum(y - 0.0004, dome(*xz, lift))
    return np.stack([xz[0], y, xz[1]], axis=1)


# --- mouth ------------------------------------------------------------------


def open_jaw(points, degrees, share=1.0):
    """Rotates points down about the jaw's hinge."""
    a = np.radians(degrees) * np.asarray(share, dtype=float)
    q = np.asarray(points) - JAW
    y = q[:, 1] * np.cos(a) - q[:, 2] * np.sin(a)
    z = q[:, 1] * np.sin(a) + q[:, 2] * np.cos(a)
    return np.stack([q[:, 0], y, z], axis=1) + JAW


def lip_columns():
    """The position along the lip, 0 .. 1 (corner); 1 above, 0 at it, -1 below."""
    s = np.array(LIP_COLUMNS)
    sign = np.ones(len(s))
    sign[-1] = 0
    return (np.concatenate([s, s[-2::-1]]),
            np.concatenate([sign, -sign[-2::-1]]))


def lip_rings(mouth=Mouth()):
    """Rings of half a mouth by name, each [column][3].

    outside lies on the skin around the lips; border, crest and part (where
    the lips meet) make the lips; inside and back line the mouth.
    """
    s, sign = lip_columns()
    above = sign > 0
    full = np.maximum(1 - s ** 2.2, 0) ** 0.8
    curve = 1 - s * s
    x = mouth.width * s
    z = MOUTH_Z + mouth.corner * s * s
    z = z + np.where(above, mouth.upper, mouth.lower) * curve ** 0.8

    bow = 0.0014 * gauss(x, 0, 0.0045)
    height = np.where(above, 0.0050 * full - bow, 0.0066 * full) * mouth.thick
    height = sign * (height + 0.0006)
    wide = 0.0016 * s ** 3
    # metres across, up and behind the skin; the share of that depth which
    # tapers off towards the corners
    rows = {
        "outside": (2.6 * wide + 0.0006 * s, sign * (0.0052 - 0.0022 * s) + height,
                    0.0, 0.0),
        "border": (wide, height, -0.0002, 0.0),
        "crest": (0.5 * wide, 0.5 * height, np.where(above, -.0022, -.0034),
                  1.0),
        "part": (0, sign * -0.0002, np.where(above, -0.0006, 0.0004), 0.0),
        "inside": (-0.0010 * s, sign * 0.0012, 0.0052, 0.0),
        "back": (-0.30 * x, sign * 0.0070 * (1 - 0.5 * s), 0.0200, 0.0),
    }
    share = np.where(above, 0.0, 0.42 + 0.58 * curve ** 0.65)
    out = {}
    for name, (across, rise, depth, fullness) in rows.items():
        px, pz = x + across, z + rise
        y = front(px, np.clip(pz, 1.490, 1.526))
        y = y + depth * (1 - fullness + fullness * full)
        y = y - mouth.forward * (0.5 + 0.5 * full)
        ring = np.stack([px, y, pz], axis=1)
        out[name] = open_jaw(ring, mouth.jaw,
                             share * (0.6 if name == "back" else 1.0))
    return out


# --- brows ------------------------------------------------------------------


def brow_line(t):
    """The left brow as x and z; t runs from 0 (inner end) to 1."""
    x = 0.0125 + 0.0390 * t
    z = 1.6135 + 0.0085 * np.sin(np.pi * (0.12 + 0.68 * t)) - 0.002 * t
    return x, z


def brow_shift(brow, t):
    """How far an expression moves the brow in x and z."""
    inner = np.clip(1 - 2 * t, 0, 1) ** 1.2
    outer = np.clip(2 * t - 1, 0, 1) ** 1.2
    up = brow.inner * inner + brow.outer * outer
    up = up + brow.middle * (1 - inner - outer)
    return -brow.together * np.clip(1 - t, 0, 1), up
