"""All parts of the bust as one mesh."""

import numpy as np

from . import expression, hair, motion, parts, skin


class Bust:
    """face: lists of vertices, facing outwards; color [vertex][3], sRGB."""

    def __init__(self):
        body = skin.Skin(expression.REST)
        move = motion.Motion(body)
        self.parts = [parts.Part("skin", body.face, parts.skin_colors(body),
                                 move.points)]
        for side in skin.EYE_SIDES:
            self.parts += [parts.eyeball(side), parts.glint(side),
                           parts.brow(side), parts.ear(side)]
        self.parts += [parts.upper_teeth(), parts.tongue(), parts.shirt()]
        self.parts += hair.hair()
        self.face, start = [], 0
        for part in self.parts:
            self.face += [[v + start for v in f] for f in part.face]
            start += len(part.color)
        self.color = np.concatenate([p.color for p in self.parts])

    def points(self, what):
        """The vertices in an expression, [vertex][3]."""
        return np.concatenate([p.points(what) for p in self.parts])
