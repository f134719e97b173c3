"""What make bench-arm11 measures: one line a row."""

import os
from dataclasses import dataclass

KERNELS = ("an4044", "float", "fixed", "armv6")
VERTICES = 1024


@dataclass(frozen=True)
class Row:
    name: str
    title: str
    loop: str  # a row of app/cmd/bench_rows.c
    mesh: str = str(VERTICES)  # vertices of a made mesh, or a sample model
    bound: float = None  # what the core cannot beat
    limit: float = None  # warm, for armv6
    times: float = None  # an4044's warm cycles, for armv6
    cold_times: float = None
    unit: str = "vertex"
    kernels: tuple = KERNELS

    def command(self, options, kernel):
        mesh = self.mesh
        if mesh.endswith(".glb"):
            mesh = os.path.join(options.samples, "models", mesh)
        return [f"{options.programs}/arm11", self.loop, kernel, mesh]

    def wanted(self, options):
        if options.rows and self.name not in options.rows:
            return False
        return not self.mesh.endswith(".glb") or os.path.exists(
            os.path.join(options.samples, "models", self.mesh)
        )

    def limits(self, kernel):
        if kernel == "armv6" and self.limit:
            yield "warm", self.limit

    def ratios(self, kernel):
        if kernel == "armv6" and self.times:
            yield "warm", self.times
        if kernel == "armv6" and self.cold_times:
            yield "cold", self.cold_times

    def parts(self, figures):
        return ()


# fmt: off
ROWS = (
    Row("skin-1", "skin positions, 1 influence", "skin-1", bound=14, limit=15, times=3.5),
    Row("skin-2", "skin positions, 2 influences", "skin-2", bound=26, limit=28, times=3.5),
    Row("skin-3", "skin positions, 3 influences", "skin-3"),
    Row("skin-4", "skin positions, 4 influences", "skin-4"),
    Row("skin-normals-1", "skin with normals, 1 influence", "skin-normals-1"),
    Row("skin-normals-2", "skin with normals, 2 influences", "skin-normals-2", limit=55, times=3.3),
    Row("skin-normals-4", "skin with normals, 4 influences", "skin-normals-4"),
    Row("skin-tangents-2", "skin with tangents too, 2", "skin-tangents-2"),
    Row("lerp", "morph lerp, positions", "lerp"),
    Row("lerp-normals", "morph lerp, positions, normals", "lerp-normals", bound=15, limit=17, times=8),
    Row("targets-2", "morph two targets, positions", "targets-2", bound=9, limit=10, times=8),
    Row("by-frames", "morph by frames, positions", "by-frames"),
    Row("cesium", "CesiumMan, positions", "skin-1", "CesiumMan.glb", limit=36, times=3, cold_times=2.8),
    Row("cesium-normals", "CesiumMan, with normals", "skin-normals-1", "CesiumMan.glb"),
)
# fmt: on
