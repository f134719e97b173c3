"""Poses as rotations about the figure's axes, and the solver of the legs.

A pose gives each bone a rotation in armature axes (X to the figure's left, Y
backwards, Z up), in addition to its parent's. Angles are in degrees.
Positive angles: x leans forward, y tilts towards the left, z turns the figure
to its left.
"""

import numpy as np

from . import rig
from .mesh import unit

AXES = dict(zip("xyz", np.eye(3)))


def turn(axis, degrees):
    """A rotation matrix about a unit axis or about 'x', 'y' or 'z'."""
    x, y, z = AXES[axis] if isinstance(axis, str) else unit(axis)
    a = np.radians(degrees)
    c, s = np.cos(a), np.sin(a)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + s * k + (1 - c) * (k @ k)


def towards(a, b, degrees):
    """The rotation that turns direction a into direction b."""
    return turn(np.cross(a, b), degrees)


def frame(along, hinge):
    """Orthonormal axes of a bone's direction and its hinge axis."""
    z = unit(along)
    y = unit(np.cross(z, hinge))
    return np.array([np.cross(y, z), y, z]).T


FORWARD = np.array([0, -1.0, 0])
REST = {n: (h, t) for n, _, h, t in rig.bone_table()}
HIPS = REST["hips"][0]

# points of the left sole at rest that can touch the floor: those that move
# with the foot, those that move with the toes
SOLE_FOOT = np.array([(0.103, 0.080, 0.001), (0.103, 0.050, 0.0),
                      (0.103, -0.100, 0.0), (0.103, -0.120, 0.0008)])
SOLE_TOE = np.array([(0.103, -0.140, 0.002), (0.103, -0.165, 0.006),
                     (0.103, -0.190, 0.0105), (0.103, -0.203, 0.0125)])


class Pose:
    """Rotations by bone, and the displacement of the hips."""

    def __init__(self):
        self.rotation = {}
        self.offset = np.zeros(3)

    def rotate(self, bone, *turns):
        """Adds rotations; the first is the outermost."""
        matrix = self.rotation.get(bone, np.eye(3))
        for m in reversed(turns):
            matrix = m @ matrix
        self.rotation[bone] = matrix

    def bend(self, bone, x=0.0, y=0.0, z=0.0):
        self.rotate(bone, turn("z", z), turn("y", y), turn("x", x))

    def hips(self):
        return self.rotation.get("hips", np.eye(3))

    # --- arms ---

    def arm(self, side, hang=36.0, swing=0.0, out=0.0, twist=0.0, elbow=14.0,
            curl=14.0, lift=0.0):
        """Upper arm and elbow.

        hang lowers the arm from its rest, swing moves it backwards, twist
        turns it about its own axis (positive: a bent forearm moves out, or up
        when the arm is raised), lift raises the collar bone, out is added
        after the swing.
        """
        s = 1 if side == ".L" else -1
        m = np.diag([s, 1, 1])

        def flip(r):
            return m @ r @ m

        direction = turn("y", hang) @ rig.ARM_DIR
        # the collar bone takes a third of the twist, so that the skin twists
        # over a longer stretch
        self.rotate("shoulder" + side, flip(turn("y", -lift)),
                    flip(turn(direction, -twist / 3)))
        self.rotate("upper_arm" + side, flip(turn("y", -out)),
                    turn("x", swing), flip(turn(direction, -twist * 2 / 3)),
                    flip(turn("y", hang)))
        self.rotate("forearm" + side,
                    flip(towards(rig.FORE_DIR, FORWARD, elbow)))
        self.fingers(side, curl)

    def forget_arm(self, side):
        """Resets an arm to rest."""
        for bone in ("shoulder", "upper_arm", "forearm", "hand", "fingers",
                     "thumb"):
            self.rotation.pop(bone + side, None)

    def fingers(self, side, curl, thumb=None):
        m = np.diag([1 if side == ".L" else -1, 1, 1])
        down = -rig.ARM_UP
        bend = towards(rig.FORE_DIR, down, curl)
        self.rotate("fingers" + side, m @ bend @ m)
        bend = towards(rig.THUMB_DIR, down,
                       curl * 0.35 if thumb is None else thumb)
        self.rotate("thumb" + side, m @ bend @ m)

    def wrist(self, side, up=0.0, aside=0.0, twist=0.0):
        """up raises the back of the hand, aside moves it to the thumb."""
        m = np.diag([1 if side == ".L" else -1, 1, 1])
        r = (towards(rig.FORE_DIR, rig.ARM_UP, up)
             @ towards(rig.FORE_DIR, -rig.FORE_SIDE, aside)
             @ turn(rig.FORE_DIR, twist))
        self.rotate("hand" + side, m @ r @ m)

    # --- legs ---

    def leg(self, side, foot, pitch=0.0, toe=0.0, clear=0.0, yaw=0.0,
            spread=0.0, knee_out=0.0, at_least=0.0):
        """Places a foot, and bends thigh and shin accordingly.

        foot is (x, y), its displacement from rest. pitch
        raises the toes (positive) or the heel; the foot rolls over its heel
        or ball. toe bends the toes up. The lowest point of the sole is clear
        metres above the floor, the ankle not below at_least. yaw turns the
        toes outwards.
        """
        s = 1 if side == ".L" else -1
        m = np.diag([s, 1, 1])
        tilt = turn("x", -pitch)
        toes = turn("x", -toe)
        pivot = (np.array([0.103, 0.070, 0]) if pitch > 0
                 else np.array([0.103, rig.BALL[1], 0]))
        points = np.concatenate([
            SOLE_FOOT, (SOLE_TOE - rig.BALL) @ toes.T + rig.BALL])
        low = ((points - pivot) @ tilt.T)[:, 2].min()
        ankle = tilt @ (rig.ANKLE - pivot) + pivot
        heading = turn("z", yaw)
        center = np.array([0.103, -0.02, 0])
        ankle = heading @ (ankle - center) + center
        ankle[2] = max(ankle[2] + clear - low, at_least)
        ankle = m @ ankle + np.array([foot[0] + s * spread, foot[1], 0])
        self.reach(side, ankle, m @ (heading @ tilt) @ m,
                   yaw * 0.6 + knee_out, m @ toes @ m)

    def reach(self, side, ankle, foot, knee_out, toes):
        """Rotates thigh and shin to put the ankle there; keeps the foot's angle."""
        s = 1 if side == ".L" else -1
        m = np.diag([s, 1, 1])
        hip, knee, rest = m @ rig.HIP, m @ rig.KNEE, m @ rig.ANKLE
        hips = self.hips()
        at = HIPS + self.offset + hips @ (hip - HIPS)
        upper, lower = np.linalg.norm(knee - hip), np.linalg.norm(rest - knee)
        away = ankle - at
        distance = min(np.linalg.norm(away), (upper + lower) * 0.9992)
        away = unit(away) * distance
        ahead = turn("z", s * knee_out) @ (hips @ FORWARD)
        ahead[2] = 0
        hinge = unit(np.cross(away, ahead))
        ahead = unit(np.cross(hinge, away))
        cosine = (upper**2 + distance**2 - lower**2) / (2 * upper * distance)
        a = np.arccos(np.clip(cosine, -1, 1))
        thigh = unit(away) * np.cos(a) + ahead * np.sin(a)
        shin = unit(away - thigh * upper)
        x = np.array([-1.0, 0, 0])
        thigh_turn = frame(thigh, hinge) @ frame(knee - hip, x).T
        shin_turn = frame(shin, hinge) @ frame(rest - knee, x).T
        self.rotation["thigh" + side] = hips.T @ thigh_turn
        self.rotation["shin" + side] = thigh_turn.T @ shin_turn
        self.rotation["foot" + side] = shin_turn.T @ foot
        self.rotation["toe" + side] = toes
