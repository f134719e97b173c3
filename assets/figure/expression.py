"""The face's morph targets.

An expression gives the positions of lids, lips and brows. The rest of the skin
gets the smoothest displacement (least squares of the graph Laplacian) that
agrees with them and does not move ears, neck and hairline.
"""

from dataclasses import dataclass

import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree

from linear import inverse, product

from . import face, features
from .features import Brow, Eye, Mouth
from .head import EYE, HAIRLINE
from .mesh import curve, smoothstep


@dataclass(frozen=True)
class Expression:
    eye: Eye = Eye()
    brow: Brow = Brow()
    mouth: Mouth = Mouth()
    cheek: float = 0.0  # metres up
    chin: float = 0.0


REST = Expression()

TARGETS = {
    "smile": Expression(
        eye=Eye(upper=0.95, lower=0.0030),
        brow=Brow(0.0015, 0.0020, 0.0010),
        mouth=Mouth(width=0.0315, corner=0.0165, upper=0.0012, lower=-0.0030,
                    thick=0.92),
        cheek=0.0045),
    "surprise": Expression(
        eye=Eye(upper=1.16, lower=-0.0012),
        brow=Brow(0.0070, 0.0085, 0.0065),
        mouth=Mouth(width=0.0165, corner=-0.0010, upper=0.0036, lower=-0.0010,
                    forward=0.0025, jaw=8.0, thick=0.95)),
    "frown": Expression(
        eye=Eye(upper=0.86, lower=0.0014, tilt=0.0022),
        brow=Brow(-0.0062, -0.0032, 0.0022, together=0.0038),
        mouth=Mouth(width=0.0222, corner=-0.0058, upper=0.0030, lower=0.0030,
                    thick=0.92),
        chin=0.0015),
    "blink": Expression(
        eye=Eye(upper=0.0, shut=1.0), brow=Brow(-0.0008, -0.0012, -0.0008)),
    "talk": Expression(
        brow=Brow(0.0010, 0.0014, 0.0008),
        mouth=Mouth(width=0.0215, corner=0.0008, upper=0.0026, lower=0.0,
                    jaw=8.5)),
}

BACK = {"blink": 0.0040}  # how far the eyeball retreats behind the lids
CHEEK = np.array([0.041, 1.541])


class Follow:
    """The displacements of the skin's vertices."""

    def __init__(self, skin):
        self.skin = skin
        self.rest = skin.piece.points()
        self.lids = features.lid_rings()
        self.lips = features.lip_rings()
        self.find_handles()
        a, b = skin.edges().T
        n = len(self.rest)
        laplace = np.zeros((n, n))
        laplace[a, b] = laplace[b, a] = -1
        laplace /= -laplace.sum(axis=1)[:, None]
        laplace[np.arange(n), np.arange(n)] = 1
        square = product(laplace.T, laplace) + np.diag(self.firm**2)
        self.inverse = inverse(square)

    def find_handles(self):
        """The weight of each vertex's constraint; fixed vertices never move."""
        skin, p = self.skin, self.rest
        x, y, z = np.abs(p[:, 0]), p[:, 1], p[:, 2]
        azimuth = np.degrees(np.arctan2(x, -y))
        hair = curve(HAIRLINE, azimuth)[:, 0]
        self.still = (y > -0.030) | (z > hair - 0.020)
        self.still |= (z < 1.500) & (y > -0.040)
        self.still[[*skin.base, *skin.twin[skin.base]]] = True
        self.firm = np.zeros(len(p))
        self.firm[self.still] = 10
        free = ~self.still
        nose = free & (x < 0.018) & (z > 1.534) & (z < 1.59)
        self.firm[nose] = 2
        self.chin = free & (z < 1.494)
        self.jaw = smoothstep(-0.020, -0.078, y)
        self.cheek = free & (np.hypot(x - CHEEK[0], z - CHEEK[1]) < 0.011)
        bx, bz = features.brow_line(face.BROW_STEPS)
        near = np.hypot(x[:, None] - bx, z[:, None] - bz).min(axis=1)
        self.brow = free & (near < 0.009)
        for at, firm in ((self.chin, 1), (self.cheek, 0.7), (self.brow, 1)):
            self.firm[at] = firm
        for name, ring in (*skin.lids.items(), *skin.lips.items()):
            both = np.concatenate([ring, skin.twin[ring]])
            self.firm[both] = 2 if name == "outside" else 30
            self.firm[both] = 1.5 if name == "crease" else self.firm[both]

    def wishes(self, what):
        skin, p = self.skin, self.rest
        d = np.zeros_like(p)
        side = np.sign(p[:, 0])
        chin = features.open_jaw(p, what.mouth.jaw, self.jaw) - p
        chin[:, 2] += what.chin * self.jaw
        d[self.chin] = chin[self.chin]
        d[self.cheek] = (what.cheek * np.stack(
            [0.3 * side, np.full(len(p), -0.7), np.ones(len(p))], axis=1)
        )[self.cheek]
        along = np.clip((np.abs(p[:, 0]) - 0.0125) / 0.0390, 0, 1)
        dx, dz = features.brow_shift(what.brow, along)
        d[self.brow] = np.stack([side * dx, 0 * dx, dz], axis=1)[self.brow]
        for now, then, rings in (
                (features.lid_rings(what.eye), self.lids, skin.lids),
                (features.lip_rings(what.mouth), self.lips, skin.lips)):
            for name, ring in rings.items():
                move = now[name] - then[name]
                if name in ("ridge", "fold"):
                    move = move[list(features.UPPER)]
                d[ring] = move
                d[skin.twin[ring]] = move * (-1, 1, 1)
        return d

    def points(self, what):
        wishes = self.wishes(what)
        d = product(self.inverse, wishes * (self.firm**2)[:, None])
        d[self.still] = 0
        d[self.skin.twin == np.arange(len(d)), 0] = 0
        for ring in [r for n, r in (*self.skin.lids.items(),
                                    *self.skin.lips.items())
                     if n not in ("outside", "crease")]:
            both = np.concatenate([ring, self.skin.twin[ring]])
            d[both] = wishes[both]
        return self.rest + d


def lay_on(piece, points):
    """A function that finds the y of the skin at x and z."""
    tree = BVHTree.FromPolygons([tuple(c) for c in points], piece.faces)

    def lay(x, z):
        return np.array([tree.ray_cast(Vector((a, -1, b)), Vector((0, 1, 0))
                                       )[0].y for a, b in zip(x, z)])

    return lay


def make_face():
    """The pieces of the face with their shapes."""
    skin = face.Skin()
    follow = Follow(skin)
    lay = lay_on(skin.piece, follow.rest)
    eye, brow, teeth = face.make_eye(), face.make_brow(lay), face.make_teeth()
    glints = [face.make_glint(side) for side in (1, -1)]
    for name, what in TARGETS.items():
        moved = follow.points(what)
        skin.piece.shapes[name] = list(moved)
        brow.shapes[name] = list(face.brow_points(
            lay_on(skin.piece, moved), what.brow))
        back = features.BALL_AXIS * BACK.get(name, 0)
        eye.shapes[name] = [co - back for co in eye.co]
        for side, glint in zip((1, -1), glints):
            glint.shapes[name] = [co - back * (side, 1, 1) for co in glint.co]
    return [skin.piece, eye, eye.mirrored(), *glints, brow, brow.mirrored(),
            teeth]
