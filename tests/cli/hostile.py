#!/usr/bin/env python3
"""hostile.py FOLDER: writes models that are small, valid in each number, and
meant to make a program overflow, hang or fill the memory."""
import json
import math
import os
import struct
import sys
import zlib


def gltf(**members):
    return {"asset": {"version": "2.0"}, **members}


def zeros(kind, count, component=5126):
    """An accessor without a buffer view: its values are 0."""
    return {"type": kind, "componentType": component, "count": count}


def data(*values):
    """A buffer of floats as a data URI, and the view of all of it."""
    import base64

    raw = struct.pack("<%df" % len(values), *values)
    uri = "data:application/octet-stream;base64," + base64.b64encode(raw).decode()
    return {
        "buffers": [{"byteLength": len(raw), "uri": uri}],
        "bufferViews": [{"buffer": 0, "byteLength": len(raw)}],
    }


def many_nodes():
    """Nodes times primitives is 2 to the power of 32."""
    part = {"attributes": {"POSITION": 0}}
    return gltf(
        accessors=[zeros("VEC3", 3)],
        meshes=[{"primitives": [part] * 65536}],
        nodes=[{"mesh": 0}] * 65536,
    )


def shared_mesh():
    """The vertices of all nodes are more than an int counts."""
    times = {"type": "SCALAR", "componentType": 5126, "count": 2,
             "bufferView": 0}
    return gltf(
        **data(0.0, 1.0),
        accessors=[zeros("VEC3", 3000000), times, zeros("VEC3", 2)],
        meshes=[{"primitives": [{"attributes": {"POSITION": 0}}]}],
        nodes=[{"mesh": 0}] * 1500,
        animations=[{
            "samplers": [{"input": 1, "output": 2}],
            "channels": [{"sampler": 0,
                          "target": {"node": 0, "path": "translation"}}],
        }],
    )


def empty_targets():
    """Targets that displace nothing, but count."""
    return gltf(
        accessors=[zeros("VEC3", 300000)],
        meshes=[{"primitives": [{"attributes": {"POSITION": 0},
                                 "targets": [{}] * 2000}]}],
        nodes=[{"mesh": 0}],
    )


def far_apart(distance=3e38):
    """Triangles at both ends of the floats, or of what is accepted."""
    return gltf(
        **data(0, 0, 0, 1, 0, 0, 0, 1, 0),
        accessors=[{"type": "VEC3", "componentType": 5126, "count": 3,
                    "bufferView": 0}],
        meshes=[{"primitives": [{"attributes": {"POSITION": 0}}]}],
        nodes=[{"mesh": 0, "translation": [-distance, 0, 0]},
               {"mesh": 0, "translation": [distance, 0, 0]}],
    )


def nested_scales():
    """Each node is within the limits; the product of their scales is not."""
    nodes = [{"scale": [1e6] * 3, "children": [i + 1]} for i in range(12)]
    return gltf(
        **data(0, 0, 0, 1, 0, 0, 0, 1, 0),
        accessors=[{"type": "VEC3", "componentType": 5126, "count": 3,
                    "bufferView": 0}],
        meshes=[{"primitives": [{"attributes": {"POSITION": 0}}]}],
        nodes=nodes + [{"mesh": 0}],
        scenes=[{"nodes": [0]}],
    )


def many_floors():
    """Any of thousands of nodes may be ground, below a long chain of others, and
    clips move as many nodes beside them."""
    count = 6000
    corners = (0, 0, 0, 0, 0, 1, 1, 0, 0)
    chain = [{"mesh": 0, "translation": [0, 1e-6, 0], "children": [i + 1]}
             for i in range(count)]
    return gltf(
        **data(*corners, 0, 1, 0, 0, 0, 1, 1, 1),
        accessors=[
            {"type": "VEC3", "componentType": 5126, "count": 3, "bufferView": 0,
             "min": [0, 0, 0], "max": [1, 0, 1]},
            {"type": "SCALAR", "componentType": 5126, "count": 2,
             "bufferView": 0, "byteOffset": 36, "min": [0], "max": [1]},
            {"type": "VEC3", "componentType": 5126, "count": 2,
             "bufferView": 0, "byteOffset": 44},
        ],
        meshes=[{"primitives": [{"attributes": {"POSITION": 0}}]}],
        nodes=chain + [{"mesh": 0, "translation": [0, 5, 0]}] +
        [{} for _ in range(count)],
        animations=[{
            "samplers": [{"input": 1, "output": 2}],
            "channels": [{"sampler": 0, "target": {"node": count + 1 + i,
                                                   "path": "translation"}}
                         for i in range(count)],
        }],
    )


def hash_of(word, before=0):
    """A hash of words by which a table of cells of positions might be filled."""
    mixed = (before ^ word) * 0x85EBCA6B & 0xFFFFFFFF
    return mixed ^ mixed >> 15


def colliding_cells(count=60000):
    """Vertices in cells of 1/65536 that have the same slot in a hash table: those
    whose hash is a multiple of its size."""
    inverse = pow(0x85EBCA6B, -1, 1 << 32)
    lows = {}  # by upper bits of z and the hash before it: lower bits
    for wanted in range(0, 1 << 32, 1 << (2 * count - 1).bit_length()):
        word = (wanted ^ wanted >> 15 ^ wanted >> 30) * inverse & 0xFFFFFFFF
        lows.setdefault(word >> 16, []).append(word & 0xFFFF)
    found = [(0, 0, 0), (65536, 65536, 65536)]
    x = 0
    while len(found) < count:
        x += 1
        for y in range(65536):
            before = hash_of(y, hash_of(x))
            found += [(x, y, before & 0xFFFF ^ low)
                      for low in lows.get(before >> 16, ())]
    return gltf(
        **data(*(i / 65536 for cell in found[:count] for i in cell)),
        accessors=[{"type": "VEC3", "componentType": 5126, "count": count,
                    "bufferView": 0}],
        meshes=[{"primitives": [{"attributes": {"POSITION": 0}}]}],
        nodes=[{"mesh": 0}],
    )


def names():
    """Names with escape sequences, a C1 control and the end of a comment."""
    evil = "*/ int evil;\x1b[31m\u009b31m\u202e/*"
    times = {"type": "SCALAR", "componentType": 5126, "count": 2,
             "bufferView": 0}
    return gltf(
        **data(0.0, 1.0),
        accessors=[zeros("VEC3", 3), times, zeros("VEC3", 2)],
        meshes=[{"name": evil, "primitives": [{"attributes": {"POSITION": 0}}],
                 "extras": {"targetNames": [evil]}}],
        nodes=[{"mesh": 0, "name": evil}],
        animations=[{
            "name": evil,
            "samplers": [{"input": 1, "output": 2}],
            "channels": [{"sampler": 0,
                          "target": {"node": 0, "path": "translation"}}],
        }],
    )


def repeated_levels():
    """A list that names one level of detail again and again."""
    long = [0.0] * 20000
    return gltf(
        accessors=[zeros("VEC3", 3)],
        meshes=[{"primitives": [{"attributes": {"POSITION": 0}}]}] * 2,
        nodes=[{"mesh": 0, "translation": long,
                "extensions": {"MSFT_lod": {"ids": [1] * 60000}}},
               {"mesh": 1, "translation": long}],
    )


def long_chain():
    """Joints behind each other, whose skeleton never branches."""
    count = 12000
    return gltf(
        **data(*[1.0, 0.0, 0.0, 0.0] * 3),
        accessors=[zeros("VEC3", 3), zeros("VEC4", 3, 5121),
                   {**zeros("VEC4", 3), "bufferView": 0}],
        meshes=[{"primitives": [{"attributes": {
            "POSITION": 0, "JOINTS_0": 1, "WEIGHTS_0": 2}}]}],
        skins=[{"joints": list(range(count))}],
        nodes=[{"name": "joint%d" % i, "translation": [0, 1e-3, 0],
                "children": [i + 1] if i + 1 < count else []}
               for i in range(count)] + [{"mesh": 0, "skin": 0}],
    )


def many_clips():
    """More clips than a character of its own has states for."""
    return gltf(
        **data(0, 1, 0, 0, 0, 1, 1, 1),
        accessors=[zeros("VEC3", 3),
                   {"type": "SCALAR", "componentType": 5126, "count": 2,
                    "bufferView": 0, "min": [0], "max": [1]},
                   {"type": "VEC3", "componentType": 5126, "count": 2,
                    "bufferView": 0, "byteOffset": 8}],
        meshes=[{"primitives": [{"attributes": {"POSITION": 0}}]}],
        nodes=[{"mesh": 0}],
        animations=[{
            "name": "clip %d" % i,
            "samplers": [{"input": 1, "output": 2}],
            "channels": [{"sampler": 0,
                          "target": {"node": 0, "path": "translation"}}],
        } for i in range(3000)],
    )


def long_clip():
    """Half an hour, in which a node trembles a little and jerks once."""
    count, vertices = 1800, 200
    jerk = 1350
    times = [float(i) for i in range(count)]
    moved = []
    times[jerk - 1], times[jerk + 1] = jerk - 0.02, jerk + 0.02
    for i in range(count):
        moved += [0, 1e-3 * (i * 7919 % 97) / 97 + 0.06 * (i == jerk), 0]
    corners = [c for i in range(vertices) for c in (i % 20, i // 20, i % 7)]
    ends = (4 * count, 16 * count)
    return gltf(
        **data(*times, *moved, *corners),
        accessors=[
            {"type": "SCALAR", "componentType": 5126, "count": count,
             "bufferView": 0, "min": [0], "max": [count - 1]},
            {"type": "VEC3", "componentType": 5126, "count": count,
             "bufferView": 0, "byteOffset": ends[0]},
            {"type": "VEC3", "componentType": 5126, "count": vertices - 2,
             "bufferView": 0, "byteOffset": ends[1],
             "min": [0, 0, 0], "max": [19, 9, 6]},
        ],
        meshes=[{"primitives": [{"attributes": {"POSITION": 2}}]}],
        nodes=[{"mesh": 0}],
        animations=[{
            "samplers": [{"input": 0, "output": 1}],
            "channels": [{"sampler": 0,
                          "target": {"node": 0, "path": "translation"}}],
        }],
    )


def heavy():
    """A wheel of 60,000 vertices that turns to and fro for half a minute."""
    count, vertices = 60, 60000
    times = [i / 2 for i in range(count)]
    turns = []
    for i in range(count):
        a = 0.3 * math.sin(2.4 * i)
        turns += [0, math.sin(a), 0, math.cos(a)]
    rim = [c for i in range(vertices)
           for c in (math.cos(i), i % 3 / 3, math.sin(i))]
    ends = (4 * count, 20 * count)
    return gltf(
        **data(*times, *turns, *rim),
        accessors=[
            {"type": "SCALAR", "componentType": 5126, "count": count,
             "bufferView": 0, "min": [0], "max": [times[-1]]},
            {"type": "VEC4", "componentType": 5126, "count": count,
             "bufferView": 0, "byteOffset": ends[0]},
            {"type": "VEC3", "componentType": 5126, "count": vertices,
             "bufferView": 0, "byteOffset": ends[1],
             "min": [-1, 0, -1], "max": [1, 1, 1]},
        ],
        meshes=[{"primitives": [{"attributes": {"POSITION": 2}}]}],
        nodes=[{"mesh": 0}],
        animations=[{
            "samplers": [{"input": 0, "output": 1}],
            "channels": [{"sampler": 0, "target": {"node": 0, "path": "rotation"}}],
        }],
    )


def png(side):
    """A black picture, compressed about a thousand times."""
    def chunk(kind, body):
        return (struct.pack(">I", len(body)) + kind + body +
                struct.pack(">I", zlib.crc32(kind + body)))

    rows = zlib.compressobj(9)
    body = b"".join(rows.compress(b"\0" * (side + 1)) for _ in range(side))
    return (b"\x89PNG\r\n\x1a\n" +
            chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 0, 0, 0, 0)) +
            chunk(b"IDAT", body + rows.flush()) + chunk(b"IEND", b""))


def one_png_many_names():
    """The same file under names that differ, and materials that use them."""
    text = ["xof 0303txt 0032"]
    for i in range(2000):
        text.append('Material m%d{1;1;1;1;;1;1;1;1;;0;0;0;;TextureFilename{"'
                    '%sbomb.png";}}' % (i, "./" * i))
    text.append("Mesh{3;0;0;0;,1;0;0;,0;1;0;;1;3;0,1,2;;}")
    return "\n".join(text)


def textured(**parts):
    """A primitive with a material of its own for each texture."""
    count = len(parts["textures"])
    return gltf(
        accessors=[zeros("VEC3", 3), zeros("VEC2", 3)],
        **parts,
        materials=[{"pbrMetallicRoughness": {"baseColorTexture": {"index": i}}}
                   for i in range(count)],
        meshes=[{"primitives": [
            {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": i}
            for i in range(count)]}],
        nodes=[{"mesh": 0}],
    )


def one_image_many_textures():
    """A picture of one colour, which each of many textures stores again."""
    import base64

    uri = "data:image/png;base64," + base64.b64encode(png(1024)).decode()
    return textured(images=[{"uri": uri}],
                    samplers=[{"wrapS": 33648, "wrapT": 33648}],
                    textures=[{"source": 0, "sampler": 0}] * 600)


def large_images(count):
    """Pictures of 4096 x 4096 pixels, as painters of textures export them."""
    return textured(images=[{"uri": "bomb.png"}] * count,
                    textures=[{"source": i} for i in range(count)])


def many_warnings():
    """A warning for each of many references."""
    frames = "".join("{missing%d}" % i for i in range(100000))
    return "xof 0303txt 0032\nFrame f{%s}\n%s" % (
        frames, "Mesh{3;0;0;0;,1;0;0;,0;1;0;;1;3;0,1,2;;}")


def main(folder):
    made = {
        "many-nodes.gltf": many_nodes(),
        "shared-mesh.gltf": shared_mesh(),
        "empty-targets.gltf": empty_targets(),
        "far-apart.gltf": far_apart(),
        "nested-scales.gltf": nested_scales(),
        "names.gltf": names(),
        "many-textures.gltf": one_image_many_textures(),
        "many-floors.gltf": many_floors(),
        "long-chain.gltf": long_chain(),
        "many-clips.gltf": many_clips(),
        "repeated-levels.gltf": repeated_levels(),
        "edge.gltf": far_apart(1e9),
        "long-clip.gltf": long_clip(),
        "heavy.gltf": heavy(),
        "colliding-cells.gltf": colliding_cells(),
        "nothing.gltf": gltf(),
        "large-images.gltf": large_images(12),
        "too-large-images.gltf": large_images(20),
    }
    for name, model in made.items():
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            json.dump(model, file, separators=(",", ":"))
    with open(os.path.join(folder, "bomb.png"), "wb") as file:
        file.write(png(4096))
    for name, text in {
        "many-names.x": one_png_many_names(),
        "many-warnings.x": many_warnings(),
    }.items():
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)


main(sys.argv[1])
