"""The hair: a cap with a thick edge, and locks on the cap."""

import numpy as np

from . import surface
from .parts import COLORS, still, strip

def cap(rows=11):
    half = np.concatenate([np.linspace(0, 55, 8), np.linspace(62, 122, 12),
                           np.linspace(130, 180, 7)])
    heading = np.radians(np.concatenate([-half[:0:-1], half]))[1:]
    count = len(heading)
    low = surface.hairline(heading)
    points, color = [[0, 0, 0]], [COLORS["hair"]]
    sweep = [(r / (rows - 1)) for r in range(1, rows)]
    for r, v in enumerate(sweep + [1.0, 1.03]):
        elevation = np.pi / 2 + (low - np.pi / 2) * v
        d = surface.direction(heading, elevation)
        ground = surface.from_around(d)
        thick = 0.085 + 0.05 * np.sin(np.pi * min(v, 1))
        # The nape is cut short.
        behind = np.clip((np.abs(heading) - 1.9) / 1.0, 0, 1)
        thick = thick - (0.035 + 0.03 * behind) * v**3
        wave = 0.012 * np.sin(np.degrees(heading) / 7 + 2.2 * v)
        lift = thick + wave * min(1, 3 * v)
        if r == len(sweep):
            lift = 0.02 + 0 * wave
        if r > len(sweep):
            lift = -0.06 + 0 * wave
        points += list(ground + d * np.broadcast_to(
            lift, (count,))[:, None])
        dark = 0.25 + 0.5 * (wave < -0.004) if r < len(sweep) else 0.9
        dark = np.broadcast_to(dark, (count,))[:, None]
        color += list(COLORS["hair"]
                      + (COLORS["hairdark"] - COLORS["hair"]) * dark)
    top = surface.from_around(np.array([[0, 1.0, 0]]))[0]
    points[0] = top + (0, 0.10, 0)
    n = len(sweep) + 2
    face = [[0, 1 + k, 1 + (k + 1) % count] for k in range(count)]
    face += [[v + 1 for v in f] for f in strip(n, count)]
    return still("hair", np.array(points), face, color)


def spline(keys, t):
    """A smooth curve (Catmull-Rom) through rows of keys, at t in 0..1."""
    keys = np.asarray(keys, dtype=float)
    keys = np.concatenate([[2 * keys[0] - keys[1]], keys,
                           [2 * keys[-1] - keys[-2]]])
    s = np.clip(t, 0, 1) * (len(keys) - 3)
    i = np.minimum(s.astype(int), len(keys) - 4)
    f = (s - i)[:, None]
    a, b, c, d = (keys[i + k] for k in range(4))
    return 0.5 * (2 * b + (c - a) * f + (2 * a - 5 * b + 4 * c - d) * f**2
                  + (3 * b - a - 3 * c + d) * f**3)


def lock(keys, width, thickness=0.5, tip=0.05, steps=9, sides=7, shade=0.0):
    """A tapering strand along keys of (heading, elevation, lift)."""
    t = np.linspace(0, 1, steps)
    path = spline(keys, t)
    d = surface.direction(np.radians(path[:, 0]), np.radians(path[:, 1]))
    centre = surface.from_around(d) + d * path[:, 2:]
    along = np.gradient(centre, axis=0)
    along /= np.linalg.norm(along, axis=1)[:, None]
    across = np.cross(along, d)
    across /= np.linalg.norm(across, axis=1)[:, None]
    up = np.cross(across, along)
    size = width * (np.sin(np.pi * np.clip(0.16 + 0.84 * t, 0, 1)) ** 0.7
                    + tip * t)
    size[-1] = width * 0.03
    points, color = [], []
    for i in range(steps):
        for k in range(sides):
            a = 2 * np.pi * k / sides + np.pi / 2
            points.append(centre[i] + size[i] * (
                np.cos(a) * across[i] + thickness * np.sin(a) * up[i]))
            base = COLORS["hair"] + (COLORS["hairdark"]
                                     - COLORS["hair"]) * shade
            light = max(0, np.sin(a)) * np.sin(np.pi * t[i]) * 0.7
            color.append(base + (COLORS["hairlight"] - base) * light)
    face = [f[::-1] for f in strip(steps, sides)]
    face.append(list(range(sides)))
    face.append([(steps - 1) * sides + k for k in range(sides)][::-1])
    return still("lock", points, face, color)


# Locks: keys of (heading and elevation in degrees, lift above the skull), then
# the half-width.
FRINGE = (
    # combed from a parting on the right to the left
    (((-30, 66, 0.10), (-8, 56, 0.17), (14, 42, 0.13), (30, 32, 0.07)), 0.17),
    (((-32, 62, 0.09), (-18, 50, 0.16), (-2, 40, 0.12), (10, 32, 0.07)), 0.15),
    (((-22, 70, 0.10), (14, 62, 0.17), (36, 46, 0.13), (48, 29, 0.07)), 0.17),
    (((-10, 74, 0.10), (35, 66, 0.16), (54, 44, 0.12), (62, 20, 0.06)), 0.17),
    (((-34, 58, 0.08), (-30, 46, 0.13), (-22, 38, 0.11), (-12, 31, 0.06)),
     0.12),
    # the other side of the parting
    (((-36, 62, 0.09), (-48, 50, 0.14), (-54, 36, 0.11), (-54, 22, 0.06)),
     0.14),
    (((-40, 66, 0.10), (-64, 52, 0.15), (-72, 30, 0.11), (-73, 4, 0.03)),
     0.16),
)
SIDES = (
    (((20, 76, 0.10), (64, 62, 0.15), (73, 36, 0.11), (74, 4, 0.03)), 0.17),
    (((70, 74, 0.09), (94, 56, 0.14), (98, 34, 0.11), (90, 8, 0.05)), 0.17),
    (((-60, 70, 0.09), (-92, 54, 0.14), (-97, 34, 0.11), (-90, 8, 0.05)),
     0.17),
    (((120, 72, 0.08), (124, 46, 0.14), (124, 12, 0.10), (116, -20, 0.03)),
     0.19),
    (((-120, 72, 0.08), (-124, 46, 0.14), (-124, 12, 0.10), (-116, -20, 0.03)),
     0.19),
    (((150, 70, 0.08), (154, 40, 0.14), (152, 4, 0.10), (144, -38, 0.02)),
     0.21),
    (((-150, 70, 0.08), (-154, 40, 0.14), (-152, 4, 0.10), (-144, -38, 0.02)),
     0.21),
    (((180, 72, 0.08), (183, 42, 0.14), (181, 2, 0.10), (174, -42, 0.02)),
     0.21),
)
CROWN = (
    (((-150, 84, 0.06), (120, 86, 0.17), (70, 82, 0.27), (50, 76, 0.30)),
     0.055),
    (((150, 82, 0.06), (110, 80, 0.15), (86, 74, 0.22), (80, 68, 0.23)),
     0.05),
)


def hair():
    out = [cap()]
    out += [lock(keys, width) for keys, width in FRINGE]
    out += [lock(keys, width, 0.36, steps=7, sides=6)
            for keys, width in SIDES]
    out += [lock(keys, width, 0.7, steps=7, sides=6) for keys, width in CROWN]
    return out
