"""The head as a signed distance function, and its intersection with rays.

Axes are glTF's (Y up, the face looks along +Z, its left is +X). The unit is
half the height of a head; face.py scales it to metres. The shape is symmetric
about x = 0.
"""

import numpy as np

ORIGIN = np.array([0, -0.15, -0.05])  # the origin of the rays that find the skin
EYE = np.array([0.28, -0.06, 0.315])  # the middle of the left eye's sphere
EYE_RADIUS = 0.47
LID_RADIUS = 0.505


def ellipsoid(p, centre, radii):
    q = (p - centre) / radii
    a = np.linalg.norm(q, axis=-1)
    b = np.linalg.norm(q / radii, axis=-1)
    return a * (a - 1) / np.maximum(b, 1e-9)


def ball(p, centre, radius):
    return np.linalg.norm(p - centre, axis=-1) - radius


def capsule(p, a, b, ra, rb):
    """An approximate distance to a round cone."""
    a, b = np.asarray(a, dtype=float), np.asarray(b, dtype=float)
    d = b - a
    t = np.clip(((p - a) * d).sum(axis=-1) / (d * d).sum(), 0, 1)
    return np.linalg.norm(p - a - t[..., None] * d, axis=-1) - ra - t * (rb - ra)


def join(a, b, k):
    """Union with a fillet of about k."""
    h = np.maximum(k - np.abs(a - b), 0) / k
    return np.minimum(a, b) - h * h * k / 4


def carve(a, b, k):
    """a without b, with a fillet of about k."""
    return -join(-a, b, k)


def skull(p):
    """Head and neck without nose and eyelids."""
    p = np.concatenate([np.abs(p[..., :1]), p[..., 1:]], axis=-1)
    d = ellipsoid(p, (0, 0.17, -0.10), (0.86, 0.86, 0.95))
    d = join(d, ellipsoid(p, (0, -0.28, 0.10), (0.76, 0.62, 0.73)), 0.25)
    d = join(d, ellipsoid(p, (0, -0.78, 0.47), (0.25, 0.19, 0.26)), 0.25)
    d = join(d, ball(p, (0.40, -0.38, 0.45), 0.29), 0.2)
    d = join(d, ellipsoid(p, (0, -0.58, 0.54), (0.32, 0.22, 0.27)), 0.2)
    neck = capsule(p, (0, -0.55, -0.16), (0, -1.7, -0.24), 0.34, 0.37)
    return join(d, neck, 0.22)


def lid(q):
    """The dome of the closed lids over the left eye."""
    around = ellipsoid(q * (1, 1, 0), (0.36, -0.05, 0), (0.29, 0.25, 1))
    return carve(ball(q, EYE, LID_RADIUS), -around, 0.12)


def head(p):
    """The whole skin, with domes over the eyes."""
    q = np.concatenate([np.abs(p[..., :1]), p[..., 1:]], axis=-1)
    d = skull(p)
    d = carve(d, ellipsoid(q, (0.37, -0.04, 1.00), (0.32, 0.29, 0.20)), 0.14)
    d = join(d, capsule(q, (0, 0.02, 0.76), (0, -0.26, 0.90), 0.06, 0.09),
             0.13)
    d = join(d, ball(q, (0, -0.305, 0.925), 0.105), 0.08)
    d = join(d, ball(q, (0.085, -0.335, 0.87), 0.066), 0.06)
    return join(d, lid(q), 0.05)


def march(shape, start, step, far=3.0):
    """The points start + t * step, t in 0..far, where rays meet a shape.

    A ray that misses gives its point at far.
    """
    t = np.zeros(len(start))
    step = np.broadcast_to(step, start.shape)
    going = np.arange(len(start))
    for _ in range(200):
        d = shape(start[going] + t[going, None] * step[going])
        t[going] = np.minimum(t[going] + 0.7 * d, far)
        going = going[(np.abs(d) > 1e-6) & (t[going] < far)]
        if not len(going):
            break
    return start + t[:, None] * step


def from_front(xy, shape=head):
    """The points of the front with these x and y."""
    xy = np.asarray(xy, dtype=float)
    start = np.concatenate([xy, np.full((len(xy), 1), 2.0)], axis=1)
    return march(shape, start, np.array([0, 0, -1.0]))


def from_around(direction, shape=skull, origin=ORIGIN):
    """The points in these directions, seen from the origin."""
    direction = direction / np.linalg.norm(direction, axis=1)[:, None]
    return march(shape, origin + 3.0 * direction, -direction)


def direction(heading, elevation):
    """Unit vectors; heading 0 is +Z, positive headings turn towards +X."""
    c = np.cos(elevation)
    return np.stack([np.sin(heading) * c, np.sin(elevation),
                     np.cos(heading) * c], axis=-1)


# The edge of the hair: heading and elevation in degrees, seen from ORIGIN.
HAIRLINE = ((0, 41), (25, 40), (45, 36), (56, 30), (64, 20), (72, 7),
            (78, 1), (84, 5), (92, 12), (100, 13), (107, 6), (114, -8),
            (124, -24), (138, -34), (160, -38), (180, -39))


def hairline(heading):
    """The edge's elevation in radians; heading in radians, either side."""
    h, e = np.array(HAIRLINE, dtype=float).T
    return np.radians(np.interp(np.abs(np.degrees(heading)), h, e))
