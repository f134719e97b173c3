"""Functions that all asset scripts share.

An asset script runs inside Blender 3.4 without a window:

    blender -b --factory-startup -P assets/NAME.py -- OUT.glb

Scripts use Blender's axes (Z up, a figure faces -Y); the export converts them
to glTF's (Y up, facing +Z). Colours are sRGB, as a colour picker shows them.
"""

import json
import os
import struct
import sys

import bpy
import numpy as np

FPS = 30
COLOR = "Color"  # the one colour attribute, exported as COLOR_0


# --- script and scene -------------------------------------------------------


def output_path():
    """The file named after `--` on the command line."""
    if "--" not in sys.argv or sys.argv.index("--") + 1 >= len(sys.argv):
        sys.exit("usage: blender -b --factory-startup -P SCRIPT -- OUT.glb")
    return os.path.abspath(sys.argv[sys.argv.index("--") + 1])


def run(build):
    """Calls build(path); a failure ends Blender with exit status 1."""
    try:
        build(output_path())
    except Exception:  # Blender itself would go on and exit with 0
        import traceback

        traceback.print_exc()
        sys.exit(1)


def reset_scene():
    """An empty scene at 30 frames a second."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.fps = FPS
    scene.world = bpy.data.worlds.new("World")
    return scene


def link(obj, parent=None):
    """Puts an object into the scene, below parent if one is given."""
    bpy.context.scene.collection.objects.link(obj)
    obj.parent = parent
    return obj


def select_only(*objects):
    """Selects these objects; the first becomes the active one."""
    for obj in bpy.context.scene.objects:
        obj.select_set(False)
    for obj in objects:
        obj.select_set(True)
    bpy.context.view_layer.objects.active = objects[0]


# --- colour and material ----------------------------------------------------


def srgb(text):
    """'#rrggbb' as three floats, still sRGB-encoded."""
    text = text.lstrip("#")
    return tuple(int(text[i : i + 2], 16) / 255 for i in (0, 2, 4))


def to_linear(color):
    """sRGB-encoded values (any array shape) to linear light."""
    c = np.asarray(color, dtype=float)
    return np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)


def to_srgb(color):
    """Linear light (any array shape) to sRGB-encoded values."""
    c = np.clip(np.asarray(color, dtype=float), 0, 1)
    return np.where(c <= 0.0031308, c * 12.92, 1.055 * c ** (1 / 2.4) - 0.055)


def image(name, pixels, data=False):
    """A packed PNG from an array [height][width][3], sRGB, top row first.

    data: the values are not colours (a normal map), so they are not converted.
    """
    height, width = pixels.shape[:2]
    img = bpy.data.images.new(name, width, height, alpha=False)
    if data:
        img.colorspace_settings.name = "Non-Color"
    rgba = np.ones((height, width, 4), dtype=np.float32)
    rgba[:, :, :3] = np.clip(pixels, 0, 1)
    img.pixels.foreach_set(np.ascontiguousarray(rgba[::-1]).ravel())
    img.file_format = "PNG"
    img.pack()
    return img


def normal_map(height, depth):
    """Tangent-space normals [height][width][3] of a height map that tiles.

    height is 0..1, top row first; depth is the height of 1, in texels.
    """
    right = (np.roll(height, -1, 1) - np.roll(height, 1, 1)) * depth / 2
    up = (np.roll(height, 1, 0) - np.roll(height, -1, 0)) * depth / 2
    n = np.stack([-right, -up, np.ones_like(height)], axis=-1)
    return 0.5 + 0.5 * n / np.linalg.norm(n, axis=-1)[..., None]


def material(name, color="#ffffff", texture=None, normals=None,
             roughness=0.8, cull=True):
    """A Principled material: base colour (sRGB), or a base colour image.

    Colour attributes multiply either. normals is a normal map (see image,
    data=True). cull=False makes it double-sided.
    """
    mat = bpy.data.materials.new(name)
    mat.use_nodes = True
    mat.use_backface_culling = cull
    shader = mat.node_tree.nodes["Principled BSDF"]
    rgb = to_linear(srgb(color))
    shader.inputs["Base Color"].default_value = (*rgb, 1)
    shader.inputs["Roughness"].default_value = roughness
    shader.inputs["Metallic"].default_value = 0
    if texture is not None:
        node = mat.node_tree.nodes.new("ShaderNodeTexImage")
        node.image = texture
        mat.node_tree.links.new(
            shader.inputs["Base Color"], node.outputs["Color"]
        )
    if normals is not None:
        node = mat.node_tree.nodes.new("ShaderNodeTexImage")
        node.image = normals
        bump = mat.node_tree.nodes.new("ShaderNodeNormalMap")
        mat.node_tree.links.new(bump.inputs["Color"], node.outputs["Color"])
        mat.node_tree.links.new(
            shader.inputs["Normal"], bump.outputs["Normal"]
        )
    return mat


# --- colour attribute and ambient occlusion ---------------------------------


def corner_vertices(mesh):
    """The vertex number of each face corner."""
    out = np.empty(len(mesh.loops), dtype=np.int32)
    mesh.loops.foreach_get("vertex_index", out)
    return out


def set_colors(mesh, corners):
    """Fills the colour attribute from sRGB values [corner][3]."""
    attr = mesh.color_attributes.get(COLOR)
    if attr is None:
        attr = mesh.color_attributes.new(COLOR, "BYTE_COLOR", "CORNER")
    mesh.color_attributes.active_color = attr
    rgba = np.ones((len(mesh.loops), 4), dtype=np.float32)
    rgba[:, :3] = np.clip(corners, 0, 1)
    attr.data.foreach_set("color_srgb", rgba.ravel())


def get_colors(mesh):
    """The colour attribute as sRGB values [corner][3]."""
    rgba = np.empty(len(mesh.loops) * 4, dtype=np.float32)
    mesh.color_attributes[COLOR].data.foreach_get("color_srgb", rgba)
    return rgba.reshape(-1, 4)[:, :3].astype(float)


def fill_color(mesh, color="#ffffff"):
    """One colour for the whole mesh."""
    set_colors(mesh, np.tile(srgb(color), (len(mesh.loops), 1)))


def smooth_over_edges(mesh, value, rounds):
    """Averages each vertex's value with its neighbours', rounds times."""
    edges = np.empty(len(mesh.edges) * 2, dtype=np.int32)
    mesh.edges.foreach_get("vertices", edges)
    a, b = edges[0::2], edges[1::2]
    n = len(value)
    degree = np.bincount(a, minlength=n) + np.bincount(b, minlength=n)
    for _ in range(rounds):
        near = np.bincount(a, value[b], n) + np.bincount(b, value[a], n)
        value = 0.5 * value + 0.5 * near / np.maximum(degree, 1)
    return value


def bake_ao(objects, distance=0.5, samples=256, strength=1.0, rounds=1):
    """Multiplies baked ambient occlusion into the colours of the objects.

    All renderable objects occlude each other in their current positions.
    distance is in metres; strength is 0 (no occlusion) to 1 (all of it).
    Rounds of smoothing along the edges remove noise. Each mesh needs a colour
    attribute and a material. The result is one value for each vertex, so
    that borders between colours stay sharp.
    """
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = samples
    scene.cycles.seed = 0
    scene.cycles.use_adaptive_sampling = False
    scene.world.light_settings.distance = distance
    scene.render.bake.target = "VERTEX_COLORS"
    for obj in objects:
        attrs = obj.data.color_attributes
        attrs.active_color = attrs.new("AO", "FLOAT_COLOR", "CORNER")
        # Blender bakes into the colour attribute that is set for rendering
        attrs.render_color_index = attrs.active_color_index
    select_only(*objects)
    bpy.ops.object.bake(type="AO")
    for obj in objects:
        apply_ao(obj.data, strength, rounds)


def apply_ao(mesh, strength, rounds):
    """Averages the baked corners of each vertex and multiplies them in."""
    rgba = np.empty(len(mesh.loops) * 4, dtype=np.float32)
    mesh.color_attributes["AO"].data.foreach_get("color", rgba)
    corner = corner_vertices(mesh)
    n = len(mesh.vertices)
    ao = np.bincount(corner, rgba[0::4], n)
    ao = ao / np.maximum(np.bincount(corner, minlength=n), 1)
    ao = smooth_over_edges(mesh, ao, rounds)
    ao = 1 - strength * (1 - np.clip(ao, 0, 1))
    mesh.color_attributes.remove(mesh.color_attributes["AO"])
    linear = to_linear(get_colors(mesh))
    # light that bounces between bright surfaces brightens occluded parts
    linear = linear * ao[corner][:, None] ** (1 - 0.55 * linear)
    set_colors(mesh, to_srgb(linear))


# --- export -----------------------------------------------------------------


def export_glb(path, tangents_for=(), tolerance=0.0005):
    """Writes the scene as one .glb, then tidies it (see Tidy).

    NLA tracks become clips of the same name; each holds the action of an
    object as a strip. tangents_for names the materials whose primitives keep
    tangents. tolerance is the largest error that removing keys may cause, in
    the unit of the channel.
    """
    repair_exporter()
    bpy.ops.export_scene.gltf(
        filepath=path,
        export_format="GLB",
        export_yup=True,
        export_apply=False,
        export_texcoords=True,
        export_normals=True,
        export_tangents=bool(tangents_for),
        export_colors=True,
        export_animations=True,
        export_nla_strips=True,
        export_force_sampling=True,
        export_frame_range=False,
        export_optimize_animation_size=False,
        export_skins=True,
        export_all_influences=False,
        export_def_bones=False,
        export_morph=True,
        export_morph_normal=True,
        export_morph_tangent=False,
        export_cameras=False,
        export_lights=False,
        export_extras=False,
    )
    Tidy(path).write(path, tangents_for, tolerance)


def repair_exporter():
    """Makes Blender 3.4's exporter read colours by face corner.

    Otherwise it reads a corner's colour at the index of the corner's vertex.
    """
    if bpy.app.version >= (3, 5, 0):
        return
    from io_scene_gltf2.blender.exp import (
        gltf2_blender_gather_primitives_extract as extract)

    def get_color_attribute(self, attr):
        colors = self.blender_mesh.color_attributes
        data = colors[colors.render_color_index].data
        rgba = np.empty(len(data) * 4, dtype=np.float32)
        data.foreach_get("color", rgba)
        rgba = rgba.reshape(-1, 4)
        if attr["blender_domain"] == "POINT":
            rgba = rgba[self.dots["vertex_index"]]
        for i in range(4):
            self.dots[attr["gltf_attribute_name"] + str(i)] = rgba[:, i]

    extract.PrimitiveCreator._PrimitiveCreator__get_color_attribute = (
        get_color_attribute)


COMPONENT = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4",
             5126: "<f4"}
WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9,
         "MAT4": 16}


def needed_keys(time, value, path, tolerance):
    """Which keys of a linear channel to keep (Ramer-Douglas-Peucker)."""
    keep = np.zeros(len(time), dtype=bool)
    keep[0] = keep[-1] = True
    todo = [(0, len(time) - 1)]
    while todo:
        a, b = todo.pop()
        if b - a < 2:
            continue
        f = ((time[a + 1 : b] - time[a]) / (time[b] - time[a]))[:, None]
        line = value[a] * (1 - f) + value[b] * f
        if path == "rotation":
            line /= np.linalg.norm(line, axis=1)[:, None]
        error = np.abs(line - value[a + 1 : b]).max(axis=1)
        worst = int(error.argmax())
        if error[worst] > tolerance:
            keep[a + 1 + worst] = True
            todo += [(a, a + 1 + worst), (a + 1 + worst, b)]
    return keep


class Tidy:
    """Makes an exported .glb smaller without changing its picture.

    Removes channels that stay at the node's rest, keys on the line between
    their neighbours, texture coordinates and tangents that no texture needs,
    and duplicate accessors. Rounds normals and tangents to 1/4096, because
    Blender's differ in the last bit from run to run. Moves skinned meshes to
    the root, as glTF recommends.
    """

    def __init__(self, path):
        with open(path, "rb") as f:
            data = f.read()
        size = struct.unpack_from("<I", data, 12)[0]
        self.json = json.loads(data[20 : 20 + size])
        self.bin = data[20 + size + 8 :]
        self.chunks = []
        self.size = 0
        self.views = []
        self.accessors = []
        self.known = {}

    def read(self, index):
        """An accessor as an array [count][width]."""
        acc = self.json["accessors"][index]
        view = self.json["bufferViews"][acc["bufferView"]]
        kind = np.dtype(COMPONENT[acc["componentType"]])
        width = WIDTH[acc["type"]]
        start = view.get("byteOffset", 0) + acc.get("byteOffset", 0)
        flat = np.frombuffer(self.bin, kind, acc["count"] * width, start)
        return flat.reshape(acc["count"], width)

    def add_view(self, data, target=None):
        """Appends bytes as a bufferView, aligned to four bytes."""
        view = {"buffer": 0, "byteOffset": self.size, "byteLength": len(data)}
        if target:
            view["target"] = target
        data += bytes(-len(data) % 4)
        self.chunks.append(data)
        self.size += len(data)
        self.views.append(view)
        return len(self.views) - 1

    def keep(self, index, array=None, target=None):
        """Copies an accessor; an array replaces its values."""
        acc = dict(self.json["accessors"][index])
        if "bufferView" not in acc:
            return self.remember(acc, b"")
        if "sparse" in acc:
            raise ValueError("sparse accessors are not expected here")
        if array is None:
            array = self.read(index)
        array = np.ascontiguousarray(array)
        acc["count"] = len(array)
        if "min" in acc:
            acc["min"] = [float(v) for v in array.min(axis=0)]
            acc["max"] = [float(v) for v in array.max(axis=0)]
        acc.pop("byteOffset", None)
        acc.pop("bufferView")
        return self.remember(acc, array.tobytes(), target)

    def remember(self, acc, data, target=None):
        key = (json.dumps(acc, sort_keys=True), data, target)
        if key not in self.known:
            if data:
                acc["bufferView"] = self.add_view(data, target)
            self.accessors.append(acc)
            self.known[key] = len(self.accessors) - 1
        return self.known[key]

    def primitive(self, prim, tangents_for):
        mat = {}
        if "material" in prim:
            mat = self.json["materials"][prim["material"]]
        textured = "baseColorTexture" in mat.get("pbrMetallicRoughness", {})
        attributes = {}
        for name, index in prim["attributes"].items():
            wanted = mat.get("name") in tangents_for
            if name == "TANGENT" and not wanted:
                continue
            if name.startswith("TEXCOORD") and not textured and not wanted:
                continue
            array = self.read(index)
            if name in ("NORMAL", "TANGENT"):
                array = np.round(array * 4096) / np.float32(4096)
            attributes[name] = self.keep(index, array, target=34962)
        prim["attributes"] = attributes
        if "indices" in prim:
            prim["indices"] = self.keep(prim["indices"], target=34963)
        for target in prim.get("targets", []):
            for name in target:
                target[name] = self.keep(target[name])

    def is_rest(self, node, path, value):
        """Whether a channel only repeats the node's rest value."""
        rest = {"translation": [0, 0, 0], "rotation": [0, 0, 0, 1],
                "scale": [1, 1, 1]}
        if path not in rest:
            return False
        rest = np.array(node.get(path, rest[path]))
        return np.abs(value - rest).max() < 1e-5

    def animation(self, clip, tolerance):
        channels, samplers = [], []
        for channel in clip["channels"]:
            sampler = clip["samplers"][channel["sampler"]]
            path = channel["target"]["path"]
            node = self.json["nodes"][channel["target"]["node"]]
            time = self.read(sampler["input"])
            value = self.read(sampler["output"])
            if sampler.get("interpolation", "LINEAR") == "LINEAR":
                if self.is_rest(node, path, value):
                    continue
                rows = value.reshape(len(time), -1)
                used = needed_keys(time[:, 0], rows, path, tolerance)
                time = time[used]
                value = rows[used].reshape(-1, value.shape[1])
            sampler = dict(sampler)
            sampler["input"] = self.keep(sampler["input"], time)
            sampler["output"] = self.keep(sampler["output"], value)
            samplers.append(sampler)
            channels.append(dict(channel, sampler=len(samplers) - 1))
        clip["channels"] = channels
        clip["samplers"] = samplers

    def raise_skinned_nodes(self):
        """Removes the parents of skinned meshes, which glTF ignores."""
        nodes = self.json["nodes"]
        skinned = {i for i, n in enumerate(nodes) if "skin" in n}
        for node in nodes:
            if skinned & set(node.get("children", [])):
                left = [c for c in node["children"] if c not in skinned]
                node["children"] = left
                if not left:
                    del node["children"]
        roots = self.json["scenes"][0]["nodes"]
        roots += sorted(skinned - set(roots))

    def write(self, path, tangents_for=(), tolerance=0.0005):
        gltf = self.json
        self.raise_skinned_nodes()
        for mesh in gltf.get("meshes", []):
            for prim in mesh["primitives"]:
                self.primitive(prim, tangents_for)
        for skin in gltf.get("skins", []):
            bind = skin["inverseBindMatrices"]
            skin["inverseBindMatrices"] = self.keep(bind)
        for clip in gltf.get("animations", []):
            self.animation(clip, tolerance)
        for img in gltf.get("images", []):
            view = gltf["bufferViews"][img["bufferView"]]
            start = view.get("byteOffset", 0)
            data = self.bin[start : start + view["byteLength"]]
            img["bufferView"] = self.add_view(data)
        gltf["accessors"] = self.accessors
        gltf["bufferViews"] = self.views
        gltf["buffers"] = [{"byteLength": self.size}]
        text = json.dumps(gltf, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        with open(path, "wb") as f:
            f.write(struct.pack("<III", 0x46546C67, 2,
                                12 + 8 + len(text) + 8 + self.size))
            f.write(struct.pack("<II", len(text), 0x4E4F534A) + text)
            f.write(struct.pack("<II", self.size, 0x004E4942))
            f.write(b"".join(self.chunks))
