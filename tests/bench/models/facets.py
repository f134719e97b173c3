#!/usr/bin/env python3
"""facets.py KIND TRIANGLES OUT.glb: writes a dense model of one class.

KIND is words joined by "-": shared (vertices shared, smooth normals), bare
(shared, no normals), soup (no normals, three vertices a triangle), flat (three
vertices a triangle with its plane's normal), and of the options skin, morph,
parts, uv (each triangle has texture coordinates of its own), box (a box with
sharp edges instead of a body).
"""
import json, math, struct, sys

def body(u, v, box):
    a, d = 2 * math.pi * u, math.pi * v
    if box:
        x, y, z = math.sin(d) * math.cos(a), math.cos(d), math.sin(d) * math.sin(a)
        m = max(abs(x), abs(y), abs(z))
        return (0.5 * x / m, 0.9 + 0.9 * y / m, 0.3 * z / m)
    r = 1 + 0.15 * math.sin(5 * a) * math.sin(d) + 0.1 * math.sin(9 * d)
    return (0.35 * r * math.sin(d) * math.cos(a), 0.9 + 0.9 * math.cos(d),
            0.25 * r * math.sin(d) * math.sin(a))

def sub(a, b): return tuple(x - y for x, y in zip(a, b))
def cross(a, b): return (a[1]*b[2]-a[2]*b[1], a[2]*b[0]-a[0]*b[2], a[0]*b[1]-a[1]*b[0])
def unit(a):
    l = math.sqrt(sum(x * x for x in a)) or 1.0
    return tuple(x / l for x in a)

def net(count, box):
    rows = max(3, int(math.sqrt(count / 4)))
    cols = 2 * rows
    p = [body(0, 0, box)]
    for j in range(1, rows):
        p += [body(i / cols, j / rows, box) for i in range(cols)]
    p.append(body(0, 1, box))
    last, t = len(p) - 1, []
    at = lambda i, j: 0 if j == 0 else last if j == rows else 1 + (j - 1) * cols + i % cols
    for j in range(rows):
        for i in range(cols):
            a, b, c, d = at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)
            if j > 0: t.append((a, b, c) if j < rows - 1 else (a, b, c))
            if j < rows - 1: t.append((b, d, c))
    return p, t

def main(kind, count, out):
    words = kind.split("-")
    p, t = net(count, "box" in words)
    normals = [[0.0] * 3 for _ in p]
    for tri in t:
        n = cross(sub(p[tri[1]], p[tri[0]]), sub(p[tri[2]], p[tri[0]]))
        for v in tri:
            for k in range(3): normals[v][k] += n[k]
    if words[0] in ("shared", "bare"):
        source, normal, index = list(range(len(p))), [unit(n) for n in normals], [v for tri in t for v in tri]
    else:
        source = [v for tri in t for v in tri]
        index = list(range(len(source)))
        normal = []
        for tri in t:
            normal += [unit(cross(sub(p[tri[1]], p[tri[0]]), sub(p[tri[2]], p[tri[0]])))] * 3
    pos = [p[s] for s in source]
    blob, views, accs = bytearray(), [], []
    def add(rows, comp, kind, fmt, low=None):
        data = b"".join(struct.pack("<" + fmt, *(r if isinstance(r, (tuple, list)) else (r,))) for r in rows)
        while len(blob) % 4: blob.append(0)
        views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(data)})
        blob.extend(data)
        a = {"bufferView": len(views) - 1, "componentType": comp, "count": len(rows), "type": kind}
        if low: a["min"] = [min(r[k] for r in rows) for k in range(3)]; a["max"] = [max(r[k] for r in rows) for k in range(3)]
        accs.append(a)
        return len(accs) - 1
    attr = {"POSITION": add(pos, 5126, "VEC3", "3f", True)}
    if words[0] in ("shared", "flat"): attr["NORMAL"] = add(normal, 5126, "VEC3", "3f")
    if "uv" in words:
        n = int(math.sqrt(len(t))) + 1
        uv = []
        for i in range(len(source)):
            k = i // 3
            uv.append(((k % n + 0.3 * (i % 3 == 1)) / n, (k // n + 0.3 * (i % 3 == 2)) / n))
        attr["TEXCOORD_0"] = add(uv, 5126, "VEC2", "2f")
    nodes, skins, anim = [{"mesh": 0, "name": "body"}], [], None
    times = add([0.0, 0.5, 1.0], 5126, "SCALAR", "f")
    accs[times]["min"], accs[times]["max"] = [0.0], [1.0]
    s = math.sin(0.35); c = math.cos(0.35)
    turn = add([(0, 0, -s, c), (0, 0, s, c), (0, 0, -s, c)], 5126, "VEC4", "4f")
    prim = {"attributes": attr, "indices": add(index, 5125, "SCALAR", "I"), "material": 0}
    mesh = {"primitives": [prim]}
    channel = None
    if "skin" in words:
        attr["JOINTS_0"] = add([(0, 1, 2, 0)] * len(pos), 5121, "VEC4", "4B")
        w = []
        for q in pos:
            y = min(max(q[1] / 0.9, 0.0), 2.0)
            a, b, d = max(0, 1 - y), 1 - abs(y - 1), max(0, y - 1)
            w.append((a, b, d, 0.0))
        attr["WEIGHTS_0"] = add(w, 5126, "VEC4", "4f")
        nodes = [{"mesh": 0, "skin": 0, "name": "body"}, {"name": "hip", "children": [2]},
                 {"name": "waist", "translation": [0, 0.9, 0], "children": [3]},
                 {"name": "head", "translation": [0, 0.9, 0]}]
        ib = [(1,0,0,0,0,1,0,0,0,0,1,0,0,-y,0,1) for y in (0.0, 0.9, 1.8)]
        skins = [{"joints": [1, 2, 3], "inverseBindMatrices": add(ib, 5126, "MAT4", "16f")}]
        channel = {"node": 2, "path": "rotation"}, turn
    elif "morph" in words:
        prim["targets"] = [{"POSITION": add([(0.3 * q[0], 0.0, 0.3 * q[2]) for q in pos], 5126, "VEC3", "3f", True)}]
        mesh["weights"] = [0]
        channel = {"node": 0, "path": "weights"}, add([0.0, 1.0, 0.0], 5126, "SCALAR", "f")
    else:
        channel = {"node": 0, "path": "rotation"}, turn
    while len(blob) % 4: blob.append(0)
    g = {"asset": {"version": "2.0"}, "buffers": [{"byteLength": len(blob)}], "bufferViews": views, "accessors": accs,
         "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.5, 0.2, 1], "roughnessFactor": 0.6}}],
         "meshes": [mesh], "nodes": nodes, "scenes": [{"nodes": [0, 1] if skins else [0]}], "scene": 0,
         "animations": [{"name": "move", "samplers": [{"input": times, "output": channel[1]}],
                         "channels": [{"sampler": 0, "target": channel[0]}]}]}
    if skins: g["skins"] = skins
    text = json.dumps(g).encode()
    text += b" " * (-len(text) % 4)
    with open(out, "wb") as f:
        f.write(struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(blob)))
        f.write(struct.pack("<II", len(text), 0x4E4F534A) + text)
        f.write(struct.pack("<II", len(blob), 0x004E4942) + blob)

main(sys.argv[1], int(sys.argv[2]), sys.argv[3])
