// Reads and writes .glb files: JSON, binary chunk, accessors.
import fs from 'node:fs';

const MAGIC = 0x46546c67, JSON_CHUNK = 0x4e4f534a, BIN_CHUNK = 0x004e4942;
const ELEMENT_ARRAY_BUFFER = 34963, U16 = 5123, U32 = 5125;
const WIDTH = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };
const COMPONENT = {
    5121: { size: 1, most: 255, get: (b, at) => b.readUInt8(at) },
    5123: { size: 2, most: 65535, get: (b, at) => b.readUInt16LE(at) },
    5125: { size: 4, most: 1, get: (b, at) => b.readUInt32LE(at) },
    5126: { size: 4, most: 1, get: (b, at) => b.readFloatLE(at) },
};

export function readGlb(path) {
    const data = fs.readFileSync(path);
    const size = data.readUInt32LE(12);
    const bytes = data.readUInt32LE(20 + size);
    return {
        json: JSON.parse(data.subarray(20, 20 + size)),
        bin: data.subarray(28 + size, 28 + size + bytes),
    };
}

function padded(data, filler) {
    return Buffer.concat([data, Buffer.alloc(-data.length & 3, filler)]);
}

function chunk(kind, data) {
    const head = Buffer.alloc(8);
    head.writeUInt32LE(data.length, 0);
    head.writeUInt32LE(kind, 4);
    return [head, data];
}

export function writeGlb(path, { json, bin }) {
    json.buffers[0].byteLength = bin.length;
    const parts = [
        ...chunk(JSON_CHUNK, padded(Buffer.from(JSON.stringify(json)), ' ')),
        ...chunk(BIN_CHUNK, padded(bin, 0)),
    ];
    const head = Buffer.alloc(12);
    head.writeUInt32LE(MAGIC, 0);
    head.writeUInt32LE(2, 4);
    head.writeUInt32LE(12 + parts.reduce((n, p) => n + p.length, 0), 8);
    fs.writeFileSync(path, Buffer.concat([head, ...parts]));
}

function unpack({ json, bin }, where, type, count, width, out, place) {
    const { size, get } = COMPONENT[type];
    const view = json.bufferViews[where.bufferView];
    const start = (view.byteOffset ?? 0) + (where.byteOffset ?? 0);
    const stride = view.byteStride ?? width * size;
    for (let i = 0; i < count; i++) {
        for (let c = 0; c < width; c++) {
            out[place(i) * width + c] = get(bin, start + i * stride + c * size);
        }
    }
}

// Unpacks an accessor to { count, width, value }; normalised integers become
// fractions.
export function valuesOf(glb, index) {
    const { count, type, componentType, normalized, sparse, bufferView,
        byteOffset } = glb.json.accessors[index];
    const width = WIDTH[type];
    const value = new Float64Array(count * width);
    if (bufferView !== undefined) {
        unpack(glb, { bufferView, byteOffset }, componentType, count, width,
            value, (i) => i);
    }
    if (sparse) {
        const at = new Float64Array(sparse.count);
        unpack(glb, sparse.indices, sparse.indices.componentType, sparse.count,
            1, at, (i) => i);
        unpack(glb, sparse.values, componentType, sparse.count, width, value,
            (i) => at[i]);
    }
    if (normalized) {
        value.forEach((v, i) => { value[i] = v / COMPONENT[componentType].most; });
    }
    return { count, width, value };
}

// Appends an index list; returns the number of its accessor.
export function addIndices(glb, list, vertexCount) {
    const small = vertexCount <= 65535;
    const data = Buffer.from((small ? Uint16Array : Uint32Array).from(list)
        .buffer);
    glb.json.bufferViews.push({
        buffer: 0, byteOffset: glb.bin.length, byteLength: data.length,
        target: ELEMENT_ARRAY_BUFFER,
    });
    glb.bin = Buffer.concat([glb.bin, padded(data, 0)]);
    return glb.json.accessors.push({
        bufferView: glb.json.bufferViews.length - 1,
        componentType: small ? U16 : U32,
        count: list.length,
        type: 'SCALAR',
    }) - 1;
}
