"""The walker's five clips: poses and face weights as functions of time."""

import bpy
import numpy as np
from mathutils import Matrix

from .mesh import curve, smoothstep
from .pose import Pose

FPS = 30
TAU = 2 * np.pi


def wave_at(phase, shift=0.0):
    return float(np.sin(TAU * (phase - shift)))


def loop(keys, phase):
    """A smooth periodic curve through (phase, value) keys, period 1."""
    keys = sorted((k % 1.0, v) for k, v in keys)
    at = np.array([k for k, _ in keys])
    value = np.array([v for _, v in keys], dtype=float)
    n = len(at)
    wide = np.concatenate([at - 1, at, at + 1])
    value = np.concatenate([value] * 3)
    x = phase % 1.0
    i = int(np.searchsorted(wide, x, side="right") - 1)
    i = min(max(i, 1), 3 * n - 3)
    h = wide[i + 1] - wide[i]
    t = (x - wide[i]) / h
    m0 = (value[i + 1] - value[i - 1]) / (wide[i + 1] - wide[i - 1])
    m1 = (value[i + 2] - value[i]) / (wide[i + 2] - wide[i])
    return float((2 * t**3 - 3 * t**2 + 1) * value[i]
                 + (t**3 - 2 * t**2 + t) * h * m0
                 + (3 * t**2 - 2 * t**3) * value[i + 1]
                 + (t**3 - t**2) * h * m1)


def keyed(keys, t):
    """A smooth curve through (time, value) keys, constant outside them."""
    return float(curve(keys, t)[0])


def tail(pose, back=0.0, aside=0.0, curl=0.0):
    """The ponytail: back swings it away from the neck, aside to the left."""
    for i, share in enumerate((0.35, 0.75, 1.0, 1.1)):
        pose.bend(f"ponytail.{i + 1}", x=(back + curl * i) * share,
                  y=-aside * share)


# --- idle -------------------------------------------------------------------

IDLE = 3.2


def stand(weight, breath):
    """The stance of idle, wave and jump.

    weight shifts the hips to the left, breath is -1..1.
    """
    pose = Pose()
    pose.offset = np.array([0.012 + weight * 0.028, 0.004,
                            -0.0065 - 0.002 * abs(weight)])
    tilt = 1.6 + 2.6 * weight
    pose.bend("hips", x=1.0, y=-tilt, z=3.0 + weight)
    pose.bend("spine", x=-1.5 - 0.4 * breath, y=tilt * 0.7, z=-1.5)
    pose.bend("chest", x=-1.0 - 1.3 * breath, y=tilt * 0.6, z=-2.0)
    pose.bend("neck", x=2.0 + 0.6 * breath, y=-tilt * 0.2)
    pose.bend("head", x=1.0 + 0.6 * breath, y=-tilt * 0.4, z=2.0)
    for side, s in ((".L", 1), (".R", -1)):
        pose.arm(side, hang=39.0 - s * 0.5 - 0.9 * breath,
                 swing=1.0 + 1.5 * s, elbow=8.0 + 2 * s + 1.2 * breath,
                 curl=20.0 + 3 * breath, lift=1.3 * breath)
        pose.wrist(side, up=-4)
    pose.leg(".L", (0.006, 0.012), yaw=7)
    pose.leg(".R", (-0.004, -0.030), yaw=11)
    return pose


def idle(t):
    phase = t / IDLE
    weight = wave_at(phase, 0.05)
    breath = wave_at(2 * phase, 0.1)
    pose = stand(weight, breath)
    pose.bend("head", x=1.2 * wave_at(phase, 0.3), z=5.0 * wave_at(phase, 0.2))
    pose.bend("neck", z=2.5 * wave_at(phase, 0.2))
    tail(pose, back=1.5 * wave_at(2 * phase, 0.25),
         aside=-3.5 * wave_at(phase, 0.18))
    return pose


# --- walk -------------------------------------------------------------------

WALK = 1.1
STANCE, FRONT, BACK = 0.62, -0.330, 0.375  # fraction of the cycle, metres
WALK_PITCH = [(0.0, 21), (0.045, 12), (0.10, 0), (0.20, 0), (0.34, 0),
              (0.42, -6), (0.50, -17), (0.56, -33), (0.62, -52), (0.69, -59),
              (0.80, -24),
              (0.90, 12), (0.96, 22)]


def walk_leg(pose, side, phase):
    p = phase % 1.0
    speed = (BACK - FRONT) / STANCE
    if p < STANCE:
        y = FRONT + speed * p
        clear = 0.0
    else:
        u = (p - STANCE) / (1 - STANCE)
        h = (1 - STANCE) * speed  # the swing starts and ends at floor speed
        y = ((2 * u**3 - 3 * u**2 + 1) * BACK + (u**3 - 2 * u**2 + u) * h
             + (3 * u**2 - 2 * u**3) * FRONT + (u**3 - u**2) * h)
        clear = 0.034 * np.sin(np.pi * u) ** 2 * (1 - 0.35 * u)
    pitch = loop(WALK_PITCH, p)
    if 0.10 <= p <= 0.34:
        pitch = 0.0
    toe = max(0.0, -pitch) * (1 - smoothstep(0.60, 0.80, p))
    if pitch > 0:
        toe = 0.35 * pitch * smoothstep(0.8, 0.95, p)
    pose.leg(side, (0, y), pitch=pitch, toe=toe, clear=clear, yaw=4,
             spread=-0.022)


def walk(t):
    p = t / WALK  # 0: the left heel strikes
    pose = Pose()
    rise = 0.0130 * np.cos(2 * TAU * (p - 0.33))
    sway = wave_at(p, 0.06)
    pose.offset = np.array([0.025 * sway, 0.004 * wave_at(2 * p, 0.1),
                            -0.0225 + rise])
    yaw = -np.cos(TAU * p)
    pose.bend("hips", x=2.5, y=-4.2 * wave_at(p, 0.02), z=7.5 * yaw)
    pose.bend("spine", x=0.5, y=2.4 * wave_at(p, 0.02), z=-5.0 * yaw)
    pose.bend("chest", x=0.8 + 0.8 * wave_at(2 * p, 0.2),
              y=2.2 * wave_at(p, 0.02), z=-8.0 * yaw)
    pose.bend("neck", x=-1.5, z=3.0 * yaw, y=-0.6 * sway)
    pose.bend("head", x=-1.5 - 1.2 * wave_at(2 * p, 0.15), z=3.0 * yaw)
    for side, q in ((".L", p), (".R", p + 0.5)):
        swing = np.cos(TAU * (q - 0.02))
        ahead = 0.5 - 0.5 * np.cos(TAU * (q - 0.05))
        pose.arm(side, hang=33.5 + 2.5 * ahead, swing=-1 + 21 * swing,
                 elbow=8 + 17 * ahead ** 1.3, curl=24, out=-2.5 * ahead,
                 lift=0.8 * wave_at(2 * q))
        pose.wrist(side, up=-6 + 6 * np.cos(TAU * (q - 0.14)))
        walk_leg(pose, side, q)
    tail(pose, back=6 + 5.0 * wave_at(2 * p, 0.12),
         aside=-8.0 * wave_at(p, 0.16), curl=1.2 * wave_at(2 * p, 0.3))
    return pose


# --- run --------------------------------------------------------------------

RUN = 0.7
RUN_STANCE, RUN_FRONT, RUN_BACK = 0.34, -0.235, 0.385
RUN_Y = [(0.42, 0.555), (0.52, 0.475), (0.62, 0.210), (0.72, -0.095),
         (0.82, -0.305), (0.91, -0.345)]
RUN_CLEAR = [(0.0, 0.0), (0.34, 0.0), (0.42, 0.130), (0.52, 0.315),
             (0.62, 0.330), (0.72, 0.250), (0.82, 0.165), (0.91, 0.085)]
RUN_PITCH = [(0.0, 6), (0.06, 0), (0.16, 0), (0.24, -18), (0.34, -56),
             (0.42, -82), (0.52, -92), (0.62, -66), (0.72, -32),
             (0.82, -4), (0.91, 10)]


def run_leg(pose, side, phase):
    p = phase % 1.0
    speed = (RUN_BACK - RUN_FRONT) / RUN_STANCE
    ends = [(x, RUN_FRONT + speed * x) for x in (0.0, 0.08, 0.17, 0.26, 0.34)]
    y = RUN_FRONT + speed * p if p < RUN_STANCE else loop(ends + RUN_Y, p)
    clear = 0.0 if p < RUN_STANCE else max(0.0, loop(RUN_CLEAR, p))
    pitch = loop(RUN_PITCH, p)
    if 0.06 <= p <= 0.16:
        pitch = 0.0
    toe = max(0.0, -pitch) * (1 - smoothstep(0.32, 0.44, p))
    pose.leg(side, (0, y), pitch=pitch, toe=toe, clear=clear, yaw=2,
             spread=-0.040)


def run(t):
    p = t / RUN  # 0: the left foot lands
    pose = Pose()
    rise = 0.034 * np.cos(2 * TAU * (p - 0.42))
    sway = wave_at(p, 0.0)
    pose.offset = np.array([0.012 * sway, -0.01, -0.040 + rise])
    yaw = -np.cos(TAU * (p - 0.02))
    pose.bend("hips", x=7.0, y=-3.5 * wave_at(p, 0.0), z=9.0 * yaw)
    pose.bend("spine", x=5.0, y=2.0 * wave_at(p, 0.0), z=-8.0 * yaw)
    pose.bend("chest", x=4.0 + 1.5 * wave_at(2 * p, 0.1),
              y=2.5 * wave_at(p, 0.0), z=-12.0 * yaw)
    pose.bend("neck", x=-6.0, z=6.0 * yaw)
    pose.bend("head", x=-7.0 - 1.5 * wave_at(2 * p, 0.05), z=5.0 * yaw)
    for side, q in ((".L", p), (".R", p + 0.5)):
        swing = np.cos(TAU * (q - 0.03))
        ahead = 0.5 - 0.5 * swing
        pose.arm(side, hang=25 + 8 * ahead, swing=8 + 40 * swing,
                 elbow=84 + 14 * ahead, curl=50, out=-7 * ahead,
                 twist=16 - 30 * ahead, lift=2.0 * wave_at(2 * q, 0.3))
        pose.wrist(side, up=-5)
        run_leg(pose, side, q)
    tail(pose, back=30 + 13.0 * wave_at(2 * p, 0.34),
         aside=-9.0 * wave_at(p, 0.12), curl=3 * wave_at(2 * p, 0.5))
    return pose


# --- wave -------------------------------------------------------------------

WAVE = 2.4


def wave(t):
    up = keyed([(0, 0), (0.08, 0), (0.48, 1), (0.9, 1), (1.72, 1),
                (2.24, 0), (WAVE, 0)], t)
    shake = wave_at((t - 0.50) / 0.44) * keyed(
        [(0, 0), (0.42, 0), (0.62, 1), (1.55, 1), (1.85, 0), (WAVE, 0)], t)
    pose = stand(wave_at(0, 0.05) * (1 - up) + 0.55 * up,
                 wave_at(0, 0.1) * (1 - up) + 0.4 * up)
    pose.forget_arm(".R")
    low = dict(hang=39.5, swing=-0.5, twist=0.0, elbow=6.0, curl=19.0,
               lift=-0.8)
    high = dict(hang=-32.0, swing=-10.0, twist=66.0, elbow=84.0 + 21 * shake,
                curl=-6.0, lift=17.0)
    mix = {k: low[k] * (1 - up) + high[k] * up for k in low}
    # the hand passes in front of the hip, not through it
    mix["elbow"] += 42 * np.sin(np.pi * up)
    pose.arm(".R", **mix)
    pose.wrist(".R", up=-4 + 8 * up, aside=-12 * shake, twist=0)
    pose.bend("chest", y=2.5 * up + 0.7 * shake, z=-2 * up)
    pose.bend("head", y=6.0 * up + 1.2 * shake, z=-4.0 * up, x=-2.0 * up)
    tail(pose, aside=-6 * np.sin(np.pi * up) + 2.0 * shake)
    return pose


# --- jump -------------------------------------------------------------------

JUMP = 1.5
LEAVE, LAND = 0.50, 0.96
GRAVITY = 9.81
LANDING = 0.019  # the hips' height on landing, above standing


def jump(t):
    air = 0.0
    if LEAVE < t < LAND:
        air = 0.5 * GRAVITY * (t - LEAVE) * (LAND - t)
    crouch = keyed([(0, 0), (0.06, 0.02), (0.30, 1.0), (0.36, 1.0),
                    (LEAVE, 0), (0.56, -0.5), (0.90, -0.5), (LAND, 0),
                    (1.07, 0.80), (1.12, 0.82), (1.38, 0.05), (JUMP, 0)], t)
    crouch = max(0.0, crouch)  # below 0, so that the motion is fast at both ends
    lean = keyed([(0, 0), (0.30, 1.0), (0.36, 1.0), (0.52, -0.22), (0.73, 0.0),
                  (0.92, 0.12), (1.08, 0.72), (1.38, 0.05), (JUMP, 0)], t)
    raised = keyed([(0, 0), (0.10, -0.1), (0.32, -1.0), (0.37, -1.0),
                    (0.54, 1.6), (0.70, 2.0), (0.90, 1.35), (1.08, 0.15),
                    (1.20, -0.2), (1.40, 0.0), (JUMP, 0)], t)
    tip = keyed([(0, 0), (0.36, 0), (0.44, -12), (LEAVE, -52), (0.60, -46),
                 (0.78, -30), (0.92, -26), (LAND, -22), (1.01, 0), (JUMP, 0)],
                t)
    tuck = keyed([(0, 0), (LEAVE, 0), (0.72, 1), (0.90, 0.1), (LAND, 0),
                  (JUMP, 0)], t)
    pose = stand(wave_at(0, 0.05), wave_at(0, 0.1))
    ground = 0.050 * smoothstep(0, -52, tip) - 0.235 * crouch
    u = np.clip((t - LEAVE) / (LAND - LEAVE), 0, 1)
    if 0 < u < 1:
        ground = 0.050 * (1 - u) + LANDING * u
    pose.offset = pose.offset + np.array(
        [0, 0.035 * crouch, ground + air])
    pose.bend("hips", x=24 * lean)
    pose.bend("spine", x=10 * lean)
    pose.bend("chest", x=6 * lean)
    pose.bend("neck", x=-12 * lean)
    pose.bend("head", x=-16 * lean - 3 * max(0, raised) / 2)
    for side, s in ((".L", 1), (".R", -1)):
        back, front = max(0.0, -raised), max(0.0, raised)
        pose.forget_arm(side)
        pose.arm(side, hang=39.0 - s * 0.5 - 8 * back - 17 * front,
                 swing=1.0 + 1.5 * s + 44 * back - 64 * front,
                 elbow=8 + 2 * s + 20 * front * (2 - front) + 4 * back,
                 curl=20 - 9 * front, lift=5 * front, out=9 * front)
        pose.wrist(side, up=-4)
    toe = -tip * (1 - smoothstep(LEAVE, LEAVE + 0.10, t)
                  + smoothstep(LAND - 0.06, LAND, t))
    for side, foot, yaw in ((".L", (0.006, 0.012), 7),
                            (".R", (-0.004, -0.030), 11)):
        lag = 0.03 if side == ".L" else 0.0
        ankle = 0.925 + pose.offset[2] - 0.832 + (0.10 + lag) * tuck
        pose.leg(side, foot, pitch=tip, toe=toe, yaw=yaw,
                 at_least=ankle if air else 0.0,
                 knee_out=6 * crouch)
    fly = keyed([(0, 0), (0.30, 6), (0.45, -10), (0.60, -14), (0.80, 30),
                 (0.95, 46), (1.06, -6), (1.20, 8), (1.34, -2), (JUMP, 0)], t)
    tail(pose, back=fly)
    return pose


CLIPS = [("idle", idle, IDLE), ("walk", walk, WALK), ("run", run, RUN),
         ("wave", wave, WAVE), ("jump", jump, JUMP)]


# --- faces ------------------------------------------------------------------


def blinks(*times):
    """Keys of a blink at each time."""
    return [(t + dt / FPS, w) for t in times
            for dt, w in ((0, 0), (2, 1), (3, 1), (7, 0))]


# [clip][morph target]: keys of (seconds, weight), interpolated linearly. All
# weights begin and end at 0. walk and run do not move the face.
FACES = {
    "idle": {"smile": [(0, 0), (0.9, 0.05), (1.5, 0.4), (2.2, 0.4), (3, 0)],
             "blink": blinks(0.7, 2.4)},
    "wave": {"smile": [(0, 0), (0.1, 0), (0.5, 1), (1.7, 1), (2.3, 0)],
             "talk": [(0.6, 0), (0.7, 0.5), (0.8, 0.1), (0.95, 0.6),
                      (1.15, 0)],
             "blink": blinks(1.4)},
    "jump": {"frown": [(0.05, 0), (0.28, 0.45), (0.42, 0.45), (0.54, 0)],
             "smile": [(0.46, 0), (0.62, 1), (0.9, 0.7), (1.0, 0), (1.15, 0),
                       (1.3, 0.4), (JUMP, 0)],
             "talk": [(0.46, 0), (0.6, 0.45), (0.85, 0.3), (0.95, 0)],
             "blink": blinks(29 / FPS)},
}


# --- into Blender -----------------------------------------------------------


def sample(armature, function, length):
    """Quaternions of the bones and hip offsets for each frame; last = first."""
    frames = int(round(length * FPS))
    bones = armature.data.bones
    rest = {b.name: np.array(b.matrix_local.to_3x3()) for b in bones}
    quats = {b.name: [] for b in bones}
    offsets = []
    for i in range(frames + 1):
        pose = function(length * (i % frames) / frames)
        offsets.append(rest["hips"].T @ pose.offset)
        for name, b in rest.items():
            local = b.T @ pose.rotation.get(name, np.eye(3)) @ b
            q = Matrix(local.tolist()).to_quaternion().normalized()
            if quats[name] and q.dot(quats[name][-1]) < 0:
                q.negate()
            quats[name].append(q)
    return quats, offsets


def add_curves(action, path, values):
    for i in range(len(values[0])):
        fcurve = action.fcurves.new(path, index=i)
        fcurve.keyframe_points.add(len(values))
        flat = [x for f, v in enumerate(values) for x in (f, v[i])]
        fcurve.keyframe_points.foreach_set("co", flat)
        for key in fcurve.keyframe_points:
            key.interpolation = "LINEAR"
        fcurve.update()


def add_clips(armature):
    """Adds one action and one NLA track for each clip."""
    armature.animation_data_create()
    for bone in armature.pose.bones:
        bone.rotation_mode = "QUATERNION"
    for name, function, length in CLIPS:
        action = bpy.data.actions.new(name)
        action.id_root = "OBJECT"
        quats, offsets = sample(armature, function, length)
        for bone, values in quats.items():
            add_curves(action, f'pose.bones["{bone}"].rotation_quaternion',
                       values)
        add_curves(action, 'pose.bones["hips"].location', offsets)
        track = armature.animation_data.nla_tracks.new()
        track.name = name
        track.strips.new(name, 0, action)


def add_faces(obj):
    """The weights of an object's shape keys, on tracks of the same names."""
    keys = obj.data.shape_keys
    keys.animation_data_create()
    for name, targets in FACES.items():
        action = bpy.data.actions.new(name + ".face")
        action.id_root = "KEY"
        length = {n: s for n, _, s in CLIPS}[name]
        for target in keys.key_blocks.keys()[1:]:
            fcurve = action.fcurves.new(f'key_blocks["{target}"].value')
            for time, weight in [*targets.get(target, [(0, 0)]), (length, 0)]:
                key = fcurve.keyframe_points.insert(time * FPS, weight)
                key.interpolation = "LINEAR"
            fcurve.update()
        track = keys.animation_data.nla_tracks.new()
        track.name = name
        track.strips.new(name, 0, action)
