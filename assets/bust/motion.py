"""The skin's vertices in an expression.

The expression gives the positions of lids and lips. The rest of the skin gets
the smoothest displacement (least squares of the graph Laplacian) that agrees
with lips, brows, cheeks and chin, and with the vertices that do not move.
"""

import numpy as np

from linear import inverse, product

from . import expression, skin, surface

CHEEK = np.array([0.43, -0.34])
CHIN = np.array([0, -0.86])


def brow_curve(t):
    """The left brow as x and y; t runs from 0 (inner end) to 1."""
    x = 0.135 + 0.45 * t
    y = 0.235 + 0.115 * np.sin(np.pi * (0.16 + 0.74 * t)) - 0.03 * t
    return np.stack([x, y], axis=-1)


def brow_shift(brow, t):
    """How far an expression moves the brow, as [t][2]."""
    inner = np.clip(1 - 2 * t, 0, 1) ** 1.2
    outer = np.clip(2 * t - 1, 0, 1) ** 1.2
    up = brow.inner * inner + brow.outer * outer
    up += brow.middle * (1 - inner - outer)
    return np.stack([-brow.together * np.clip(1 - t, 0, 1), up], axis=-1)


class Motion:
    def __init__(self, body):
        self.body = body
        self.loops = np.concatenate(body.lip_rings[:body.lip_count])
        self.rest_lips = skin.lip_loops(expression.REST)
        self.rest_lids = {}
        for side, rings in body.eye_rings.items():
            self.rest_lids[side] = self.lids(expression.REST, side)
        self.weight, self.handles = self.find_handles()
        self.inverse = self.factor()

    def lids(self, what, side):
        border = self.body.point[self.body.eye_rings[side][-1]]
        return skin.lid_rings(what, side, border)

    def find_handles(self):
        """The weight of each vertex's constraint, and the handle that sets it."""
        p = self.body.point
        x, y, z = np.abs(p[:, 0]), p[:, 1], p[:, 2]
        weight = np.zeros(len(p))
        handles = {}
        weight[(z < 0.12) | (y < -1.12) | (y > 0.47)] = 10
        weight[(x < 0.07) & (y > -0.14) & (y < 0.06)] = 3
        handles["nose"] = (x < 0.15) & (y > -0.39) & (y < -0.2) & (z > 0.8)
        handles["chin"] = np.hypot(x, y - CHIN[1]) < 0.13
        handles["cheek"] = np.hypot(x - CHEEK[0], y - CHEEK[1]) < 0.09
        along = np.clip((x - 0.135) / 0.45, 0, 1)
        near = np.linalg.norm(
            np.stack([x, y], 1) - brow_curve(along), axis=1) < 0.05
        handles["brow"] = near & (z > 0.3)
        self.along = along
        for name, firm in (("nose", 2), ("chin", 1), ("cheek", 0.6),
                           ("brow", 1)):
            handles[name] &= weight == 0
            weight[handles[name]] = firm
        for rings in self.body.eye_rings.values():
            weight[np.concatenate(rings[:4])] = 10
        weight[self.loops] = 30
        weight[self.body.back] = 30
        return weight, handles

    def factor(self):
        n = len(self.body.point)
        a, b = self.body.edges().T
        laplace = np.zeros((n, n))
        laplace[a, b] = laplace[b, a] = -1
        laplace /= -laplace.sum(axis=1)[:, None]
        laplace[np.arange(n), np.arange(n)] = 1
        return inverse(
            product(laplace.T, laplace) + np.diag(self.weight**2))

    def wishes(self, what):
        """The displacements that the handles prescribe."""
        p = self.body.point
        d = np.zeros_like(p)
        side = np.sign(p[:, 0])
        at = self.handles["nose"]
        d[at] = np.array([0, 1, -0.2]) * what.nose
        at = self.handles["chin"]
        d[at] = skin.open_jaw(p[at], what.mouth.jaw, 1.0) - p[at]
        at = self.handles["cheek"]
        up = np.where(side > 0, what.cheek[0], what.cheek[1])[at]
        d[at] = np.stack([side[at] * (0.25 * up + 0.5 * what.puff), up,
                          0.45 * up + 0.6 * what.puff], axis=1)
        at = self.handles["brow"]
        for s in skin.EYE_SIDES:
            one = at & (side == s)
            shift = brow_shift(what.brow(s), self.along[one])
            d[one, 0], d[one, 1] = s * shift[:, 0], shift[:, 1]
        loops = skin.lip_loops(what)
        for ring, loop, rest in zip(self.body.lip_rings, loops,
                                    self.rest_lips):
            d[ring] = loop - rest
        d[self.body.back] = d[self.body.lip_rings[0]].mean(axis=0)
        return d

    def points(self, what):
        """The skin's vertices in an expression."""
        d = product(
            self.inverse, self.wishes(what) * (self.weight**2)[:, None])
        out = self.body.point + d
        for side, rings in self.body.eye_rings.items():
            moved = self.lids(what, side)
            for ring, new, old in zip(rings, moved, self.rest_lids[side]):
                out[ring] += new - old
        return out
