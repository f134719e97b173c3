"""A robot arm, a toy truck and a crate, made of rigid parts.

Each part is an object whose origin is its pivot, without rotation or scale at
rest. A program can therefore set heading (about +Y), pitch (about +X) and bank
(about +Z). All lengths are metres in glTF's axes: Y up; the arm points along
+Z, and the truck drives along +Z.
"""

import math
import os
import sys

import bpy
import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import common
from shapes import (arc, ball, box, drum, knob, lathe, link_outline, mirror,
                    outward, place, plate, tube, turn, without_buried)

# Pivots, in metres in the frame of the parent part. arm.md lists them, too.
SHOULDER = (0, 0.32, 0)
ELBOW = (0, 0.56, 0)
WRIST = (0, 0, 0.46)
KNUCKLE = (0.065, 0, 0.165)
FINGER_GRIP_DEG = -6  # the heading at which the pads hold the crate
CRATE = 0.12
CRATE_PLACE = (0.34, 0.06, 0.40)
CAR_PLACE = (-0.42, 0, 0.22)
BED = 0.134  # height of the truck's load floor
HUB = (0.112, 0.056, 0.14)

COLORS = {
    "orange": "#f28a1e",
    "grey": "#434a54",
    "dark": "#2a2e35",
    "metal": "#c3cad1",
    "cream": "#f6ecd8",
    "red": "#d93b33",
    "glass": "#2f4a5e",
    "rubber": "#2b2b2f",
    "lamp": "#fff3b8",
    "tail": "#8f1414",
    "wood": "#d8a25c",
    "frame": "#b4773a",
    "teal": "#2aa198",
}
MATERIALS = {"paint": 0.45, "metal": 0.3, "matte": 0.9}
FINISH = {"metal": "metal", "grey": "metal", "dark": "matte",
          "rubber": "matte", "wood": "matte", "frame": "matte"}


# --- parts to objects -------------------------------------------------------


class Part:
    """Gathers coloured shapes that become one object."""

    def __init__(self, name, pivot, parent=None):
        self.name, self.pivot, self.parent = name, pivot, parent
        self.shapes, self.colors = [], []

    def add(self, color, *shapes):
        self.shapes += map(outward, shapes)
        self.colors += [color] * len(shapes)

    def both(self, color, *shapes):
        """Adds the shapes and their mirror images."""
        self.add(color, *shapes, *(mirror(s) for s in shapes))

    def object(self, materials):
        mesh = bpy.data.meshes.new(self.name)
        points, faces, face_colors = [], [], []
        for shape, color in zip(without_buried(self.shapes), self.colors):
            # Shapes have glTF's axes: x, y, z are Blender's x, z, -y.
            start = len(points)
            points += [(x, -z, y) for x, y, z in shape[0].tolist()]
            faces += [[v + start for v in f] for f in shape[1]]
            face_colors += [color] * len(shape[1])
        mesh.from_pydata(points, [], faces)
        slots = list(MATERIALS)
        for name in slots:
            mesh.materials.append(materials[name])
        corner_colors = []
        for polygon, color in zip(mesh.polygons, face_colors):
            polygon.use_smooth = True
            polygon.material_index = slots.index(FINISH.get(color, "paint"))
            rgb = common.srgb(COLORS[color])
            corner_colors += [rgb] * len(polygon.vertices)
        mesh.update()
        common.set_colors(mesh, np.array(corner_colors))
        obj = bpy.data.objects.new(self.name, mesh)
        x, y, z = self.pivot
        obj.location = (x, -z, y)
        common.link(obj, self.parent)
        return obj


def finish(obj):
    """Triangulates; flat faces with rounded edges."""
    common.select_only(obj)
    obj.data.use_auto_smooth = True
    obj.data.auto_smooth_angle = math.pi
    weigh = obj.modifiers.new("Weigh", "WEIGHTED_NORMAL")
    weigh.mode = "FACE_AREA"
    weigh.weight = 50
    weigh.thresh = 0.01
    bpy.ops.object.modifier_apply(modifier=weigh.name)


def bolts(radius, count, size, x, sides=6):
    """Bolt heads in a circle on a plane that faces +X."""
    head = lathe([(size, 0), (size * 0.85, size * 0.9)], sides, "x")
    return [place(head, None,
                  (x, radius * math.cos(2 * math.pi * k / count),
                   radius * math.sin(2 * math.pi * k / count)))
            for k in range(count)]


def joint_disc(part, centre, radius, x):
    """The bolted cover on both sides of a joint that turns about X."""
    def at(shape):
        return place(shape, None, centre)

    part.both("metal", at(knob(radius, x, x + 0.012, 0.004, 18)))
    part.both("grey", at(knob(radius * 0.42, x + 0.012, x + 0.02, 0.003, 10)))
    part.both("grey", *(at(b) for b in bolts(radius * 0.72, 6, radius * 0.12,
                                             x + 0.012)))


# --- the robot --------------------------------------------------------------


def build_base():
    part = Part("Base", (0, 0, 0))
    part.add("grey", lathe([(0.2, 0), (0.2, 0.022), (0.192, 0.03),
                            (0.15, 0.032)], 24))
    for k in range(8):
        head = lathe([(0.012, 0), (0.01, 0.01)], 6)
        a = 2 * math.pi * (k + 0.5) / 8
        part.add("metal", place(head, None, (0.172 * math.sin(a), 0.031,
                                             0.172 * math.cos(a))))
    part.add("orange", lathe([(0.15, 0.02), (0.15, 0.042), (0.143, 0.05),
                              (0.122, 0.12), (0.117, 0.176)], 24))
    part.add("metal", lathe([(0.118, 0.17), (0.126, 0.176), (0.126, 0.192),
                             (0.118, 0.198)], 24))
    part.add("grey", lathe([(0.116, 0.194), (0.12, 0.2), (0.12, 0.238),
                            (0.114, 0.246), (0.103, 0.246), (0.098, 0.238),
                            (0.06, 0.22)], 24))
    return part


def build_arm():
    part = Part("Arm", SHOULDER)
    part.add("grey", ball(0.108, 22, 10))
    boom = arc((0.0, 0), 0.098, 128, 232, 7) + [
        (0.12, -0.072), (0.4, -0.055), (0.445, -0.04), (0.462, 0),
        (0.445, 0.04), (0.4, 0.055), (0.12, 0.072)]
    boom = [(u + 0.09 if i < 7 else u, v) for i, (u, v) in enumerate(boom)]
    part.add("orange", plate(boom, -0.052, 0.052, 0.012))
    panel = [(0.15, -0.042), (0.39, -0.033), (0.4, -0.02), (0.4, 0.02),
             (0.39, 0.033), (0.15, 0.042), (0.138, 0.03), (0.138, -0.03)]
    part.both("cream", plate(panel, 0.045, 0.056, 0.003))
    cheek = [(0.56 - u, v) for u, v in link_outline(0.21, 0.082, 0.035)]
    part.both("orange", plate(cheek, 0.05, 0.078, 0.007))
    joint_disc(part, (0, 0.56, 0), 0.062, 0.078)
    part.both("orange", knob(0.062, 0.08, 0.118, 0.008, 20))
    joint_disc(part, (0, 0, 0), 0.048, 0.118)
    hose = [(0, y, z) for y, z in
            ((0.06, -0.06), (0.09, -0.1), (0.14, -0.115), (0.22, -0.11),
             (0.32, -0.1), (0.40, -0.09), (0.45, -0.065), (0.47, -0.03))]
    part.add("dark", tube(hose, 0.016))
    for y, z in ((0.16, -0.113), (0.36, -0.096)):
        clip = drum(0.022, -0.012, 0.012, 0.004, 10, "y")
        part.add("metal", place(clip, turn("x", -5), (0, y, z)))
        part.add("metal", box((-0.008, y - 0.01, z), (0.008, y + 0.01, -0.05),
                              0.003))
    return part


def build_forearm(arm):
    part = Part("Forearm", ELBOW, arm)
    part.add("grey", ball(0.074, 18, 8))
    part.add("orange", lathe([(0.04, -0.05), (0.052, -0.062), (0.052, -0.11),
                              (0.044, -0.118)], 16, "z"))
    part.add("grey", lathe([(0.04, -0.112), (0.04, -0.13), (0.034, -0.136)],
                           16, "z"))
    part.add("metal", lathe([(0.05, 0.05), (0.056, 0.056), (0.056, 0.07),
                             (0.05, 0.076)], 16, "z"))
    boom = [(-0.05, 0.068), (-0.058, 0.08), (-0.058, 0.15), (-0.038, 0.36),
            (-0.028, 0.39), (0, 0.4), (0.028, 0.39), (0.038, 0.36),
            (0.058, 0.15), (0.058, 0.08), (0.05, 0.068)]
    part.add("orange", plate(boom, -0.042, 0.042, 0.01))
    panel = [(-0.036, 0.11), (-0.036, 0.15), (-0.022, 0.33), (-0.012, 0.342),
             (0.012, 0.342), (0.022, 0.33), (0.036, 0.15), (0.036, 0.11),
             (0.028, 0.1), (-0.028, 0.1)]
    part.both("cream", plate(panel, 0.036, 0.046, 0.003))
    cheek = [(v, 0.46 - u) for u, v in link_outline(0.14, 0.056, 0.026)]
    part.both("orange", plate(cheek, 0.04, 0.06, 0.005))
    joint_disc(part, (0, 0, 0.46), 0.042, 0.06)
    return part


def build_hand(forearm):
    part = Part("Hand", WRIST, forearm)
    part.add("grey", ball(0.05, 16, 8))
    part.add("metal", lathe([(0.03, 0.03), (0.036, 0.04), (0.036, 0.09),
                             (0.03, 0.096)], 16, "z"))
    part.add("orange", lathe([(0.05, 0.084), (0.056, 0.09), (0.056, 0.108),
                              (0.046, 0.116)], 16, "z"))
    palm = [(-0.09, 0.128), (-0.078, 0.114), (0.078, 0.114), (0.09, 0.128),
            (0.09, 0.15), (0.045, 0.158), (0.03, 0.142), (-0.03, 0.142),
            (-0.045, 0.158), (-0.09, 0.15)]
    part.add("grey", plate([(z, x) for x, z in palm], -0.034, 0.034,
                           0.006, "y"))
    for x in (KNUCKLE[0], -KNUCKLE[0]):
        for low, high in ((-0.036, -0.025), (0.025, 0.036)):
            part.add("metal", place(drum(0.024, low, high, 0.003, 14),
                                    None, (x, 0, KNUCKLE[2])))
        for low, high in ((-0.042, -0.034), (0.034, 0.042)):
            part.add("grey", place(drum(0.01, low, high, 0.002, 8), None,
                                   (x, 0, KNUCKLE[2])))
    return part


def finger_shapes():
    """The index finger about its knuckle: (color, shape) pairs.

    Modelled in its position at the crate, then opened, so that its gripping
    angle is FINGER_GRIP_DEG.
    """
    pad = CRATE / 2 - KNUCKLE[0]  # x of the pad's face
    claw = [(-0.018, -0.008), (-0.008, -0.02), (0.008, -0.02),
            (0.022, -0.006), (0.046, 0.04), (0.046, 0.066), (0.032, 0.12),
            (0.026, 0.152), (0.014, 0.158), (pad + 0.006, 0.15),
            (pad + 0.006, 0.075), (pad + 0.012, 0.062), (0.006, 0.045),
            (-0.016, 0.008)]
    claw = [(z, x) for x, z in claw]
    grip = [(pad, 0.08), (pad + 0.003, 0.076), (pad + 0.009, 0.076),
            (pad + 0.009, 0.15), (pad + 0.003, 0.15), (pad, 0.146)]
    grip = [(z, x) for x, z in grip]
    shapes = [("orange", plate(claw, -0.024, 0.024, 0.005, "y")),
              ("rubber", plate(grip, -0.02, 0.02, 0.002, "y"))]
    for k in range(4):
        z = 0.09 + k * 0.015
        rib = box((pad - 0.0005, -0.018, z - 0.003),
                  (pad + 0.004, 0.018, z + 0.003), 0.001)
        shapes.append(("dark", rib))
    opened = turn("y", -FINGER_GRIP_DEG)
    return [(color, place(shape, opened)) for color, shape in shapes]


def build_fingers(hand):
    index = Part("IndexFinger", KNUCKLE, hand)
    x, y, z = KNUCKLE
    thumb = Part("Thumb", (-x, y, z), hand)
    for color, shape in finger_shapes():
        index.add(color, shape)
        thumb.add(color, mirror(shape))
    return index, thumb


# --- the truck and the crate ------------------------------------------------


def build_car():
    part = Part("Car", CAR_PLACE)
    x, y, z = HUB
    part.add("grey", box((-0.07, 0.045, -0.22), (0.07, 0.1, 0.1), 0.01))
    part.add("grey", box((-0.125, 0.114, -0.235), (0.125, 0.128, -0.002),
                         0.005))
    for k in range(5):
        plank = -0.1135 + k * 0.0456
        part.add("wood", box((plank, 0.122, -0.232),
                             (plank + 0.0446, BED, -0.003), 0.003))
    rail = 0.146
    part.both("red", box((0.115, 0.112, -0.24), (0.128, rail, -0.0), 0.004))
    part.add("red", box((-0.128, 0.112, -0.246), (0.128, rail, -0.233),
                        0.004))
    for side in (-1, 1):
        part.add("tail", place(drum(0.011, -0.01, 0.0, 0.003, 10, "z"),
                               turn("y", 180), (0.095 * side, 0.13, -0.256)))
    arch = [(y + 0.068 * math.sin(math.radians(a)),
             z + 0.068 * math.cos(math.radians(a)))
            for a in np.linspace(172, 8, 11)]
    cab = ([(0.05, 0.005)] + [(0.05, arch[0][1] - 0.004)] + arch
           + [(0.05, arch[-1][1] + 0.004), (0.05, 0.228), (0.06, 0.238),
              (0.115, 0.24), (0.135, 0.23), (0.148, 0.2), (0.152, 0.14),
              (0.25, 0.1), (0.258, 0.09), (0.258, 0.012), (0.25, 0.005)])
    part.add("red", plate(cab, -0.112, 0.112, 0.014))
    part.add("cream", plate([(0.245, -0.004), (0.258, -0.004), (0.27, 0.014),
                             (0.276, 0.05), (0.272, 0.08), (0.258, 0.106),
                             (0.245, 0.112)], -0.106, 0.106, 0.008))
    window = [(0.165, 0.022), (0.165, 0.118), (0.172, 0.121), (0.235, 0.09),
              (0.24, 0.082), (0.24, 0.03), (0.232, 0.022)]
    part.both("glass", plate(window, 0.104, 0.1145, 0.003))
    part.add("glass", *windshield())
    part.add("glass", box((-0.08, 0.17, 0.0), (0.08, 0.24, 0.02), 0.004))
    for side in (-1, 1):
        lamp = lathe([(0.026, 0), (0.026, 0.012), (0.021, 0.018)], 12, "z")
        part.add("metal", place(lamp, None, (0.072 * side, 0.105, 0.228)))
        lamp = lathe([(0.02, 0), (0.02, 0.003), (0.011, 0.008), (0, 0.01)],
                     12, "z")
        part.add("lamp", place(lamp, None, (0.072 * side, 0.105, 0.245)))
    part.add("dark", box((-0.036, 0.09, 0.232), (0.036, 0.118, 0.243), 0.004))
    for k in range(3):
        part.add("metal", box((-0.034, 0.094 + k * 0.009, 0.24),
                              (0.034, 0.098 + k * 0.009, 0.246), 0.0015))
    part.add("metal", box((-0.118, 0.042, 0.226), (0.118, 0.07, 0.256),
                          0.009))
    part.add("metal", box((-0.115, 0.06, -0.256), (0.115, 0.085, -0.23),
                          0.008))
    part.both("grey", box((0.1, 0.04, -0.075), (0.118, 0.056, 0.062), 0.005))
    part.both("metal", box((0.112, 0.136, 0.032), (0.117, 0.142, 0.056),
                           0.0015))
    return part


def windshield():
    """A pane on the slope between bonnet and roof."""
    low, high = np.array((0.152, 0.14)), np.array((0.245, 0.1))
    along = (high - low) / np.linalg.norm(high - low)
    length = np.linalg.norm(high - low)
    angle = math.degrees(math.atan2(along[1], along[0]))
    pane = box((-0.088, 0.01, -0.006), (0.088, length - 0.008, 0.0035), 0.003)
    return [place(pane, turn("x", angle), (0, low[0], low[1]))]


def build_wheel(name, car, side, front):
    """side 1 is left (+X); the hub faces outwards."""
    part = Part(name, (HUB[0] * side, HUB[1], HUB[2] if front else -HUB[2]),
                car)
    r, w = HUB[1], 0.022
    tyre = [(0.05, -w), (r, -w + 0.006), (r, w - 0.006), (0.051, w),
            (0.043, w), (0.038, w - 0.006), (0.038, -0.004)]
    rim = [(0.04, 0.0), (0.04, w - 0.002), (0.035, w - 0.002),
           (0.033, w - 0.012), (0, w - 0.014)]
    shapes = [("rubber", lathe(tyre, 18, "x")),
              ("cream", lathe(rim, 18, "x")),
              ("red", knob(0.011, w - 0.016, w + 0.003, 0.004, 8))]
    for k in range(5):
        spoke = box((w - 0.016, 0.006, -0.006), (w - 0.003, 0.037, 0.006),
                    0.002)
        shapes.append(("red", place(spoke, turn("x", 72 * k))))
    for color, shape in shapes:
        part.add(color, shape if side > 0 else mirror(shape))
    return part


def build_crate():
    part = Part("Crate", CRATE_PLACE)
    h = CRATE / 2
    part.add("wood", box((-h + 0.006,) * 3, (h - 0.006,) * 3, 0.002))
    w = 0.02
    for a in range(3):
        for su, sv in np.ndindex(2, 2):
            low, high = np.zeros(3), np.zeros(3)
            # Only the upright bars (a == 1) have the crate's full length; the
            # others end at them.
            for axis, s in (((a + 1) % 3, su), ((a + 2) % 3, sv)):
                low[axis], high[axis] = (h - w, h) if s else (-h, -h + w)
            end = h if a == 1 else h - w
            low[a], high[a] = -end, end
            part.add("frame", box(low, high, 0.003))
    for axis in range(3):
        for side in (-1, 1):
            brace = box((-0.052, -0.009, 0), (0.052, 0.009, 0.01), 0.002)
            brace = place(brace, turn("z", 45), (0, 0, h - 0.012))
            if axis == 0:
                brace = place(brace, turn("y", 90 * side))
            elif axis == 1:
                brace = place(brace, turn("x", -90 * side))
            elif side < 0:
                brace = place(brace, turn("y", 180))
            part.add("frame", brace)
    return part


# --- all together -----------------------------------------------------------


def add_floor():
    """A floor that occludes the parts; removed before the export."""
    mesh = bpy.data.meshes.new("Floor")
    s = 2
    mesh.from_pydata([(-s, -s, 0), (s, -s, 0), (s, s, 0), (-s, s, 0)], [],
                     [(0, 1, 2, 3)])
    return common.link(bpy.data.objects.new("Floor", mesh))


def bake(objects, among, **settings):
    """Bakes objects while the scene holds only those in `among`."""
    for obj in bpy.context.scene.objects:
        obj.hide_render = obj not in among
    common.bake_ao(objects, rounds=0, **settings)
    for obj in bpy.context.scene.objects:
        obj.hide_render = False


def build(path):
    common.reset_scene()
    materials = {name: common.material(name.title(), roughness=r)
                 for name, r in MATERIALS.items()}
    robot = [build_base().object(materials), build_arm().object(materials)]
    robot.append(build_forearm(robot[1]).object(materials))
    robot.append(build_hand(robot[2]).object(materials))
    robot += [p.object(materials) for p in build_fingers(robot[3])]
    car = build_car().object(materials)
    wheels = [build_wheel(n, car, s, f).object(materials)
              for n, s, f in (("WheelFL", 1, True), ("WheelFR", -1, True),
                              ("WheelRL", 1, False), ("WheelRR", -1, False))]
    crate = build_crate().object(materials)
    for obj in robot + [car] + wheels + [crate]:
        finish(obj)
    floor = add_floor()
    bake(robot, robot + [floor], distance=0.2, strength=0.85)
    bake([car], [car, floor] + wheels, distance=0.15, strength=0.8)
    for wheel in wheels:
        bake([wheel], [wheel], distance=0.05, strength=0.8)
    bake([crate], [crate], distance=0.05, strength=0.4)
    bpy.data.objects.remove(floor)
    common.export_glb(path)


common.run(build)
