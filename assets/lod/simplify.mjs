// Simplifies the primitives of a mesh: fewer triangles over the same vertices.
//
// All primitives are simplified at once, so that borders between materials lose
// the same vertices on both sides and stay closed. Where the mesh touches another
// one, as the head touches the body, it keeps its vertices. The factors below
// convert errors of attributes to metres: an error of one unit of the attribute
// looks as bad as a displacement by that many metres.
import { MeshoptSimplifier } from 'meshoptimizer';
import { valuesOf } from './glb.mjs';
import { surfaceDistance } from './distance.mjs';

await MeshoptSimplifier.ready;

const NORMAL_M = 0.02; // for a unit of the normal
const COLOR_M = 0.04; // for a change from black to white
const TEXTURE = 8; // for a metre by which the texture is displaced
const WEIGHT_M = 0.5; // for a weight of 1: how far bending a limb moves the vertex
const WEIGHT_SLOTS = 8;
const SMALL_PARTS_FROM_M = 0.008; // from this error on, small parts may vanish
// From this error on, a figure is a hundred pixels tall: its outline is seen, less
// of its shading. Shares of what attributes and influences count elsewhere.
const OUTLINE_FROM_M = 0.02;
const OUTLINE_ATTRIBUTES = 0.5, OUTLINE_INFLUENCES = 0.75;

const encode = (x) =>
    (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);

// Maps each joint to a direction in a space of few dimensions. Weights of up to
// 30 joints become that many numbers, and different weights different numbers.
function jointDirections(count) {
    let state = 12345;
    const random = () => {
        state = (Math.imul(state, 1103515245) + 12345) >>> 0;
        return (state >>> 8) / (1 << 23) - 1;
    };
    return Array.from({ length: count }, () => {
        const v = Array.from({ length: WEIGHT_SLOTS }, random);
        return v.map((x) => x / Math.hypot(...v));
    });
}

// The metres of surface that a unit of the texture coordinates covers.
function textureScale(position, texcoord, index) {
    let metres = 0, units = 0;
    for (let i = 0; i + 1 < index.length; i += 3) {
        const a = index[i], b = index[i + 1];
        metres += Math.hypot(...[0, 1, 2].map((k) =>
            position[a * 3 + k] - position[b * 3 + k]));
        units += Math.hypot(...[0, 1].map((k) =>
            texcoord[a * 2 + k] - texcoord[b * 2 + k]));
    }
    return units > 0 ? metres / units : 0;
}

function readPrimitive(glb, primitive) {
    const { POSITION, NORMAL, COLOR_0, TEXCOORD_0, JOINTS_0, WEIGHTS_0 } =
        primitive.attributes;
    const maybe = (i) => (i === undefined ? null : valuesOf(glb, i));
    return {
        position: valuesOf(glb, POSITION),
        normal: maybe(NORMAL),
        color: maybe(COLOR_0),
        texcoord: maybe(TEXCOORD_0),
        joint: maybe(JOINTS_0),
        weight: maybe(WEIGHTS_0),
        index: Array.from(valuesOf(glb, primitive.indices).value),
    };
}

// The attributes of each vertex in metres: normal, colour, texture coordinates,
// then influences.
function attributesOf(part, slots, directions) {
    const { normal, color, texcoord, joint, weight } = part;
    const width = 8 + slots;
    const out = new Float32Array(part.position.count * width);
    const uv = texcoord ? textureScale(
        part.position.value, texcoord.value, part.index) : 0;
    for (let v = 0; v < part.position.count; v++) {
        const row = out.subarray(v * width, (v + 1) * width);
        for (let k = 0; k < 3; k++) {
            row[k] = normal ? normal.value[v * 3 + k] * NORMAL_M : 0;
            row[3 + k] = color
                ? encode(color.value[v * color.width + k]) * COLOR_M : 0;
        }
        for (let k = 0; k < 2; k++) {
            row[6 + k] = texcoord ? texcoord.value[v * 2 + k] * uv * TEXTURE : 0;
        }
        for (let i = 0; joint && i < 4; i++) {
            const w = weight.value[v * 4 + i] * WEIGHT_M;
            directions[joint.value[v * 4 + i]].forEach((d, k) => {
                row[8 + k] += w * d;
            });
        }
    }
    return out;
}

const placesOf = (part) => Array.from({ length: part.position.count }, (_, v) =>
    part.position.value.subarray(v * 3, v * 3 + 3).join());

// The vertices of all primitives in one array, with their attributes.
function join(glb, primitives, others) {
    const parts = primitives.map((p) => readPrimitive(glb, p));
    const taken = new Set(others.flatMap((p) =>
        placesOf(readPrimitive(glb, p))));
    const joints = 1 + Math.max(0, ...parts.flatMap((p) =>
        (p.joint ? Array.from(p.joint.value) : [])));
    const directions = jointDirections(joints);
    const slots = parts.some((p) => p.joint) ? WEIGHT_SLOTS : 0;
    const first = [];
    let count = 0;
    for (const part of parts) {
        first.push(count);
        count += part.position.count;
    }
    const position = new Float32Array(count * 3);
    const attribute = new Float32Array(count * (8 + slots));
    parts.forEach((part, i) => {
        position.set(part.position.value, first[i] * 3);
        attribute.set(attributesOf(part, slots, directions),
            first[i] * (8 + slots));
    });
    return { parts, first, count, position, attribute, width: 8 + slots,
        lock: Uint8Array.from(parts.flatMap(placesOf), (at) => taken.has(at)),
        index: Uint32Array.from(parts.flatMap((part, i) =>
            part.index.map((v) => v + first[i]))) };
}

// For shadow levels: welds vertices of a primitive that have the same position
// and influences.
function weld({ parts, first, count, position, attribute, width }) {
    const same = new Map();
    const weldTo = Uint32Array.from({ length: count }, (_, i) => i);
    parts.forEach((part, p) => {
        for (let v = first[p]; v < first[p] + part.position.count; v++) {
            const key = [p, ...position.subarray(v * 3, v * 3 + 3),
                ...attribute.subarray(v * width + 8, (v + 1) * width)].join();
            if (!same.has(key)) same.set(key, v);
            weldTo[v] = same.get(key);
        }
    });
    return weldTo;
}

function simplify(group, index, error, used) {
    const { position, attribute, width, lock } = group;
    const scale = MeshoptSimplifier.getScale(position, 3);
    const share = (i) => (error < OUTLINE_FROM_M ? 1
        : i < 8 ? OUTLINE_ATTRIBUTES : OUTLINE_INFLUENCES);
    const factor = Array.from({ length: width }, (_, i) =>
        (used(i) ? share(i) / scale : 0));
    const flags = ['ErrorAbsolute'];
    if (error >= SMALL_PARTS_FROM_M) flags.push('Prune');
    return MeshoptSimplifier.simplifyWithAttributes(index, position, 3,
        attribute, width, factor, lock, 0, error, flags)[0];
}

// Splits the result into one index list for each primitive.
function split({ parts, first }, list) {
    return parts.map((part, p) => {
        const out = [];
        for (let i = 0; i < list.length; i += 3) {
            if (list[i] >= first[p] && list[i] < first[p] + part.position.count) {
                out.push(...[0, 1, 2].map((k) => list[i + k] - first[p]));
            }
        }
        return out;
    });
}

// Makes a level { error_m, index } for each allowed error in metres. error_m is
// the measured distance, index holds a list for each primitive. With shape, only
// positions and influences count, and seams are welded. A level must
// save a fraction (worth) of the triangles of the one before. others are the
// primitives of the meshes that this mesh touches.
export function makeLevels(glb, primitives, others, errors, shapeError, share) {
    const group = join(glb, primitives, others);
    const levels = [];
    let last = group.index.length;
    for (const error of errors) {
        const list = simplify(group, group.index, error, () => true);
        const index = split(group, list);
        // A primitive of a glTF file cannot be empty.
        if (index.every((part) => part.length > 0) &&
                list.length <= last * (1 - share)) {
            const error_m = surfaceDistance(
                group.position, group.index, list);
            // A coarser level may be nearer by chance; it then replaces this one.
            while (levels.at(-1)?.error_m >= error_m) levels.pop();
            levels.push({ error_m, index });
            last = list.length;
        }
    }
    const welded = weld(group);
    const list = simplify(group, group.index.map((v) => welded[v]), shapeError,
        (i) => i >= 8);
    const index = split(group, list);
    if (index.every((part) => part.length > 0) &&
            list.length < group.index.length) {
        levels.push({ error_m: surfaceDistance(
            group.position, group.index, list), shape: true, index });
    }
    return levels;
}
