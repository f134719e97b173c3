"""What make bench-arm11 measures: one line a row.

A row is a program and its arguments. It prints "count N", what its figures are
divided by, and marks regions for the model: 1 and 2, or others by number.
"""

import os
from dataclasses import dataclass

LOOPS = ("an4044", "float", "fixed", "armv6")
VERTICES = "1024"


@dataclass(frozen=True)
class Row:
    name: str
    title: str
    program: str
    arguments: tuple  # KERNEL stands for the kernel's name
    kernels: tuple = LOOPS
    unit: str = "vertex"
    scale: float = 1  # of the figures
    regions: dict = None  # by the memory's name; "" stands for all others
    full: tuple = ("warm", "cold", "cold low", "cold high")
    short: tuple = ("warm", "cold")
    bound: float = None  # what the core cannot beat
    limit: dict = None  # what the best kernel is to reach, by figure
    times: dict = None  # the same, as so many times an4044's speed
    osmesa: bool = False  # instructions of the other GL driver, too
    chapters: str = None  # a folder of objects, to tell cycles apart
    stages: bool = False  # a whole frame, from animation to picture

    def model(self):
        """The model that it needs, as found under the samples, or None."""
        return next((a for a in self.arguments if a.endswith(".glb")), None)

    def missing(self, options):
        model = self.model()
        return model and not os.path.exists(self.path(options, model))

    def path(self, options, model):
        here = model.startswith(("assets/", "build/"))
        return model if here else os.path.join(options.samples, "models", model)

    def command(self, options, kernel):
        words = [kernel if a == "KERNEL" else a for a in self.arguments]
        words = [self.path(options, a) if a == self.model() else a for a in words]
        return [f"{options.programs}/{self.program}", *words]

    def region(self, memory):
        return self.regions.get(memory, self.regions[""])

    def is_best(self, kernel):
        return kernel == self.kernels[-1]


def loop(name, title, mesh=VERTICES, loop=None, **more):
    regions = {"warm": (1,), "": (2,)}
    return Row(name, title, "arm11", (loop or name, "KERNEL", mesh), regions=regions, **more)


def pose(model, clip, **more):
    return Row(
        f"pose-{model.split('/')[-1][:-4].lower()}-{clip.lower()}",
        f"{model.split('/')[-1][:-4]}, clip {clip}",
        "pose_cost",
        (model, clip, "20"),
        kernels=("pose",),
        unit="joint",
        regions={"": (1, 2, 3)},
        full=("warm", "cold"),
        limit={"instructions": 250},
        **more,
    )


def picture(name, title, aim, program, *arguments, **more):
    return Row(
        name,
        title,
        program,
        (*arguments, "2", "soft"),
        kernels=("soft",),
        unit="frame, millions",
        scale=1e6,
        regions={"": (1,)},
        full=("cold", "cold low", "cold high"),
        short=("cold",),
        limit={"instructions": aim},
        osmesa=True,
        chapters="platform/gl/soft",
        **more,
    )


def user_model(name, title, aim):
    """A model of user_models.py in the viewer."""
    return picture(f"gl-{name}", title, aim, "demo_frames", f"build/bench-models/{name}.glb")


# fmt: off
ROWS = (
    loop("skin-1", "skin positions, 1 influence", bound=14, limit={"warm": 15}, times={"warm": 3.5}),
    loop("skin-2", "skin positions, 2 influences", bound=26, limit={"warm": 28}, times={"warm": 3.5}),
    loop("skin-3", "skin positions, 3 influences"),
    loop("skin-4", "skin positions, 4 influences"),
    loop("skin-8", "skin positions, 8 influences"),
    loop("skin-2-scattered", "2 influences, joints at random"),
    loop("skin-normals-1", "skin with normals, 1 influence"),
    loop("skin-normals-2", "skin with normals, 2 influences", limit={"warm": 55}, times={"warm": 3.3}),
    loop("skin-normals-4", "skin with normals, 4 influences"),
    loop("skin-normals-8", "skin with normals, 8 influences"),
    loop("skin-tangents-2", "skin with tangents too, 2"),
    loop("lerp", "morph lerp, positions"),
    loop("lerp-normals", "morph lerp, positions, normals", bound=15, limit={"warm": 17}, times={"warm": 8}),
    loop("lerp-keys", "morph lerp of targets, positions"),
    loop("targets-2", "morph two targets, positions", bound=9, limit={"warm": 10}, times={"warm": 8}),
    loop("by-frames", "morph by frames, positions"),
    loop("cesium", "CesiumMan, positions", "CesiumMan.glb", "skin-1", limit={"warm": 36}, times={"warm": 3, "cold": 2.8}),
    loop("cesium-normals", "CesiumMan, with normals", "CesiumMan.glb", "skin-normals-1"),
    loop("walker-normals", "walker's body, with normals", "assets/walker.glb", "skin-normals-1"),
    loop("walker-update", "walker, all that moves", "assets/walker.glb", "update"),
    pose("CesiumMan.glb", "0"),
    pose("assets/walker.glb", "walk"),
    picture("gl-A", "A: lit sphere, Gouraud", 9, "gl_scenes", "A"),
    picture("gl-B", "B: lit sphere, textured", 10, "gl_scenes", "B"),
    picture("gl-Ac", "A, culled", 7, "gl_scenes", "Ac"),
    picture("gl-Bc", "B, culled", 7.5, "gl_scenes", "Bc"),
    picture("gl-Ag", "A, geometry alone", 2.5, "gl_scenes", "Ag"),
    picture("gl-Bg", "B, geometry alone", 2.5, "gl_scenes", "Bg"),
    picture("gl-clear", "clear alone", 0.4, "gl_scenes", "clear"),
    picture("gl-S1a", "S1: tilted quad, nearest", 12, "gl_states", "S1a"),
    picture("gl-S1b", "S1: bilinear", 20, "gl_states", "S1b"),
    picture("gl-S2", "S2: the same untextured", 5.2, "gl_states", "S2"),
    picture("gl-blend-a", "S1 blended, RGBA nearest", 20, "gl_states", "blend-a"),
    picture("gl-blend-b", "S1 blended, RGBA bilinear", 30, "gl_states", "blend-b"),
    picture("gl-S4a", "S4: lit cube, nearest", 6.3, "gl_states", "S4a"),
    picture("gl-S4b", "S4: bilinear", 11, "gl_states", "S4b"),
    picture("gl-S5", "S5: 500 triangles, bilinear", 13, "gl_states", "S5b"),
    picture("gl-S5s", "S5: w less apart", 13, "gl_states", "S5s"),
    picture("gl-test-a", "S5 alpha-tested, nearest", 8, "gl_states", "test-a"),
    picture("gl-test-b", "S5 alpha-tested, bilinear", 13, "gl_states", "test-b"),
    picture("gl-fog", "S5 in fog, bilinear", 15, "gl_states", "fog-b"),
    picture("gl-mip", "60 large triangles, mipmaps", 30, "gl_states", "mip"),
    picture("gl-walker", "the walker demo", 8.3, "demo_frames", "walker", stages=True),
    picture("gl-arm", "the arm demo", 8.3, "demo_frames", "arm"),
    picture("gl-face", "the face demo", 8.3, "demo_frames", "face"),
    picture("gl-crowd", "a crowd of 12", 8.3, "demo_frames", "crowd"),
    picture("gl-two-a", "S1 with two textures, nearest", 46, "gl_states", "two-a"),
    picture("gl-two-b", "S1 with two textures, bilinear", 66, "gl_states", "two-b"),
    picture("gl-add", "S1 by GL_ADD, bilinear", 46, "gl_states", "add-b"),
    picture("gl-count", "S2, counted in the stencil", 11, "gl_states", "count"),
    picture("gl-decal", "S1 by GL_DECAL, bilinear", 36, "gl_states", "decal-b"),
    picture("gl-mip2", "mipmaps, two mixed", 70, "gl_states", "mip2"),
    user_model("box", "12 triangles, textured", 14),
    user_model("duck", "4,000 triangles, textured", 13),
    user_model("duck-two-sided", "the same on both sides", 23),
    user_model("colors", "colours and a texture", 10.5),
    user_model("cards", "quads in all alpha modes", 12.2),
    user_model("layers", "six blended quads", 85),
    # A press waits for a frame and is seen in the next: two in 100 ms at 250 million a second.
    picture("gl-walker-ground", "the walker on uneven ground", 12.5, "demo_frames", "walker@13"),
)
# fmt: on
