"""The parameters of an expression, and the key frames.

Distances are in the head's unit, angles in degrees. The defaults are the face
at rest.
"""

from dataclasses import dataclass, replace


@dataclass(frozen=True)
class Eye:
    upper: float = 1.0  # 0 closed, 1 at rest, above 1 wide open
    lower: float = 0.0  # lower lid up
    tilt: float = 0.0   # upper lid's outer side up, inner side down
    outer: float = 0.0  # outer corner up
    bow: float = -0.085  # the closed eye's line: below or above the corners
    iris: float = 1.0   # its size
    look: tuple = (0.0, 0.0)


@dataclass(frozen=True)
class Brow:
    inner: float = 0.0  # up
    middle: float = 0.0
    outer: float = 0.0
    together: float = 0.0  # inner ends move towards each other


@dataclass(frozen=True)
class Mouth:
    width: float = 0.205
    corner_y: float = 0.034
    corner_z: float = 0.0
    upper: float = 0.0   # the middle of the upper lip's edge, up
    lower: float = 0.0   # the lower lip's edge, before the jaw turns
    upper_power: float = 2.2  # how far the height of the middle extends sideways
    lower_power: float = 2.2
    thick: float = 0.9
    forward: float = 0.0
    jaw: float = 0.0


@dataclass(frozen=True)
class Expression:
    left: Eye = Eye()
    right: Eye = Eye()
    left_brow: Brow = Brow()
    right_brow: Brow = Brow()
    mouth: Mouth = Mouth()
    cheek: tuple = (0.0, 0.0)  # left and right, up
    puff: float = 0.0  # cheeks outwards
    nose: float = 0.0  # wrinkled up

    def eye(self, side):
        return self.left if side > 0 else self.right

    def brow(self, side):
        return self.left_brow if side > 0 else self.right_brow


def both(eye=None, brow=None, **rest):
    """An expression that is the same on both sides."""
    eye, brow = eye or Eye(), brow or Brow()
    return Expression(left=eye, right=eye, left_brow=brow, right_brow=brow,
                      **rest)


REST = Expression()

_WIDE = both(
    eye=Eye(upper=0.88, lower=0.045), brow=Brow(0.02, 0.03, 0.02),
    mouth=Mouth(width=0.285, corner_y=0.095, corner_z=-0.01, upper=0.0,
                lower=0.0, upper_power=1.9, lower_power=1.9, thick=0.85),
    cheek=(0.055, 0.055))

_WINK = Eye(upper=0.0, lower=0.045, bow=-0.03)

KEY_FRAMES = {
    "smile": _WIDE,
    "frown": both(
        eye=Eye(upper=0.80, lower=0.01, tilt=-0.035, outer=-0.01),
        brow=Brow(0.085, 0.01, -0.04, together=0.02),
        mouth=Mouth(width=0.20, corner_y=-0.075, corner_z=-0.01, upper=0.018,
                    lower=0.022, upper_power=2.0, lower_power=2.0,
                    thick=0.9)),
    "surprise": both(
        eye=Eye(upper=1.30, lower=-0.025, iris=0.88),
        brow=Brow(0.075, 0.10, 0.075),
        mouth=Mouth(width=0.125, corner_y=-0.015, corner_z=0.03, upper=0.035,
                    lower=-0.045, upper_power=2.3, lower_power=2.3,
                    thick=0.85, forward=0.035, jaw=13)),
    "angry": both(
        eye=Eye(upper=0.84, lower=0.035, tilt=0.055),
        brow=Brow(-0.085, -0.035, 0.05, together=0.035),
        mouth=Mouth(width=0.205, corner_y=-0.045, upper=0.012, lower=0.012,
                    upper_power=2.2, lower_power=2.2, thick=0.75,
                    forward=0.012),
        nose=0.02),
    "wink": replace(
        _WIDE, left=_WINK, left_brow=Brow(-0.01, -0.03, -0.01),
        right=Eye(upper=0.98, lower=0.02), right_brow=Brow(0.04, 0.06, 0.03),
        cheek=(0.085, 0.04)),
    "kiss": both(
        eye=Eye(upper=0.66, lower=0.02), brow=Brow(0.03, 0.045, 0.02),
        mouth=Mouth(width=0.095, corner_y=-0.005, corner_z=0.035, upper=0.0,
                    lower=-0.002, upper_power=2.0, lower_power=2.0,
                    thick=1.3, forward=0.085)),
    "laugh": both(
        eye=Eye(upper=0.0, lower=0.055, bow=0.03),
        brow=Brow(0.05, 0.07, 0.045),
        mouth=Mouth(width=0.305, corner_y=0.105, corner_z=-0.02, upper=0.02,
                    lower=-0.02, upper_power=2.6, lower_power=2.3, thick=0.75,
                    jaw=14),
        cheek=(0.075, 0.075), nose=0.012),
    "sleep": both(
        eye=Eye(upper=0.0), brow=Brow(0.0, -0.015, -0.015),
        mouth=Mouth(width=0.185, corner_y=0.012, upper=0.0, lower=0.0,
                    thick=0.95)),
}
