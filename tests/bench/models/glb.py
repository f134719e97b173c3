"""Writes .glb files and the pictures in them, without any package."""
import json
import struct
import zlib

FLOAT, BYTE, SHORT = 5126, 5121, 5123
SMOOTH = {"magFilter": 9729, "minFilter": 9987}


def chunk(name, data):
    crc = zlib.crc32(name + data)
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", crc)


def png(side, texel, channels):
    """A square picture; texel(x, y) returns RGBA."""
    rows = b"".join(
        b"\0" + b"".join(bytes(texel(x, y)[:channels]) for x in range(side))
        for y in range(side)
    )
    head = struct.pack(">IIBBBBB", side, side, 8, {3: 2, 4: 6}[channels], 0, 0, 0)
    parts = chunk(b"IHDR", head), chunk(b"IDAT", zlib.compress(rows)), chunk(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)


def checks(side):
    def texel(x, y):
        if (x * 8 // side ^ y * 8 // side) & 1:
            return 230, y * 255 // side, 60, 255
        return x * 255 // side, 200, 255 - x * 255 // side, 255

    return texel


def discs(side):
    def texel(x, y):
        u, v = x * 64 // side % 32 - 16, y * 64 // side % 32 - 16
        alpha = max(0, min(255, (220 - u * u - v * v) * 4))
        return (*checks(side)(x, y)[:3], alpha)

    return texel


def windows(side):
    def texel(x, y):
        lit = x * 32 // side % 4 == 1 and y * 16 // side % 2 == 1
        return (255, 200 - y * 100 // side, x * 160 // side, 255) if lit else (0, 0, 0, 255)

    return texel


class Model:
    def __init__(self):
        self.bytes = b""
        self.json = {
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": []}],
            **{name: [] for name in (
                "nodes", "meshes", "accessors", "bufferViews", "materials",
                "textures", "images", "samplers", "skins", "animations",
            )},
        }  # fmt: skip

    def add(self, name, value):
        self.json[name].append(value)
        return len(self.json[name]) - 1

    def view(self, data):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        value = {"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data)}
        self.bytes += data
        return self.add("bufferViews", value)

    def accessor(self, kind, component, rows, **more):
        letter = {FLOAT: "f", BYTE: "B", SHORT: "H"}[component]
        data = b"".join(struct.pack(f"<{len(r)}{letter}", *r) for r in rows)
        return self.add("accessors", {
            "bufferView": self.view(data), "componentType": component,
            "count": len(rows), "type": kind, **more,
        })  # fmt: skip

    def texture(self, data, **more):
        image = self.add("images", {"bufferView": self.view(data), "mimeType": "image/png"})
        sampler = self.add("samplers", {**SMOOTH, **more})
        return self.add("textures", {"source": image, "sampler": sampler})

    def material(self, texture=None, color=(1, 1, 1, 1), **more):
        surface = {"metallicFactor": 0, "baseColorFactor": color}
        if texture is not None:
            surface["baseColorTexture"] = {"index": texture}
        return self.add("materials", {"pbrMetallicRoughness": surface, **more})

    def mesh(self, material, shape, colors=None, **place):
        positions, normals, texcoords, indices = shape
        ends = {f.__name__: [f(p[i] for p in positions) for i in range(3)] for f in (min, max)}
        attributes = {
            "POSITION": self.accessor("VEC3", FLOAT, positions, **ends),
        }
        if normals:
            attributes["NORMAL"] = self.accessor("VEC3", FLOAT, normals)
        attributes["TEXCOORD_0"] = self.accessor("VEC2", FLOAT, texcoords)
        if colors:
            attributes["COLOR_0"] = self.accessor("VEC4", BYTE, colors, normalized=True)
        primitive = {
            "attributes": attributes,
            "indices": self.accessor("SCALAR", SHORT, [(i,) for i in indices]),
            "material": material,
        }
        return self.show(self.add("meshes", {"primitives": [primitive]}), **place)

    def show(self, mesh, **place):
        node = self.add("nodes", {"mesh": mesh, "translation": (0, 0, 0), **place})
        self.json["scenes"][0]["nodes"].append(node)
        return mesh

    def save(self, path):
        used = {name: value for name, value in self.json.items() if value != []}
        used["buffers"] = [{"byteLength": len(self.bytes)}]
        text = json.dumps(used).encode()
        text += b" " * (-len(text) % 4)
        data = self.bytes + b"\0" * (-len(self.bytes) % 4)
        size = 28 + len(text) + len(data)
        path.write_bytes(
            struct.pack("<4sII", b"glTF", 2, size)
            + struct.pack("<I4s", len(text), b"JSON") + text
            + struct.pack("<I4s", len(data), b"BIN\0") + data
        )  # fmt: skip
