// node lod.mjs FILE.glb...: adds levels of detail to models, in place.
//
// A level is an index list over the existing vertices. In the file it is a node
// of MSFT_lod whose mesh has the attributes of the full node and its own indices.
// extras.error_m is the distance of its surface from the full one; extras.shape
// marks a level for shadows. Existing levels are replaced, so a second run
// changes nothing.
import { addIndices, readGlb, valuesOf, writeGlb } from './glb.mjs';
import { makeLevels } from './simplify.mjs';

const ERRORS_M = [
    0.0004, 0.0008, 0.0016, 0.0035, 0.005, 0.007, 0.0095, 0.0125, 0.0175, 0.028,
];
// The first error as a fraction of the largest mesh's extent: 1.5 pixels when the
// mesh covers two thirds of a screen with 640 rows.
const SHAPE_ERROR = 0.0035;
const WORTH = 0.2; // the fraction of the triangles that a level must save
const LOD = 'MSFT_lod';

// The screen coverage at which the error is one pixel of 640, for players that
// choose levels by coverage.
const SCREEN_PX = 640;

const levelsOf = (node) => node.extensions?.[LOD]?.ids ?? [];

function removeUse(json) {
    const left = (json.extensionsUsed ?? []).filter((name) => name !== LOD);
    if (left.length > 0) json.extensionsUsed = left;
    else delete json.extensionsUsed;
}

// This script appends levels, so existing ones are the last nodes and meshes.
function removeLevels(glb) {
    const { json } = glb;
    const ids = json.nodes.flatMap(levelsOf);
    if (ids.length === 0) return;
    if (!ids.every((i) => json.nodes[i].extras?.error_m > 0)) {
        throw new Error('it has levels that were not made here');
    }
    const mesh = Math.min(...ids.map((i) => json.nodes[i].mesh));
    const accessor = Math.min(...json.meshes.slice(mesh).flatMap((m) =>
        m.primitives.map((p) => p.indices)));
    const view = json.accessors[accessor].bufferView;
    glb.bin = glb.bin.subarray(0, json.bufferViews[view].byteOffset);
    json.bufferViews.length = view;
    json.accessors.length = accessor;
    json.meshes.length = mesh;
    json.nodes.length = Math.min(...ids);
    for (const node of json.nodes) {
        delete node.extensions?.[LOD];
        delete node.extras?.MSFT_screencoverage;
        for (const key of ['extensions', 'extras']) {
            if (node[key] && Object.keys(node[key]).length === 0) delete node[key];
        }
    }
    removeUse(json);
}

// The other meshes that are moved by a skin of this mesh.
function neighboursOf({ nodes }, mesh) {
    const skins = new Set(nodes.filter((n) => n.mesh === mesh &&
        n.skin !== undefined).map((n) => n.skin));
    return [...new Set(nodes.filter((n) => n.mesh !== mesh &&
        n.mesh !== undefined && skins.has(n.skin)).map((n) => n.mesh))];
}

function addLevelMesh(glb, mesh, lists) {
    const { name, weights, primitives } = glb.json.meshes[mesh];
    return glb.json.meshes.push({
        name,
        ...(weights && { weights }),
        primitives: primitives.map((p, i) => ({
            ...p,
            indices: addIndices(glb, lists[i],
                glb.json.accessors[p.attributes.POSITION].count),
        })),
    }) - 1;
}

// For each mesh, its levels as { error_m, shape, mesh }.
function addMeshes(glb) {
    const levels = new Map();
    const primitives = (mesh) => glb.json.meshes[mesh].primitives;
    const shapeError = SHAPE_ERROR * Math.max(...glb.json.meshes.map((_, m) =>
        extentOf(glb, m)));
    // limber makes levels of moving faces at load, with more regard to shading.
    const isList = (p) => p.indices !== undefined && (p.mode ?? 4) === 4 &&
        !p.targets;
    for (let m = glb.json.meshes.length - 1; m >= 0; m--) {
        if (!primitives(m).every(isList)) continue;
        const others = neighboursOf(glb.json, m).flatMap(primitives);
        const made = makeLevels(glb, primitives(m), others, ERRORS_M,
            shapeError, WORTH);
        levels.set(m, made.map(({ error_m, shape, index }) => ({
            error_m, shape, mesh: addLevelMesh(glb, m, index),
        })));
    }
    return levels;
}

function extentOf({ json }, mesh) {
    const boxes = json.meshes[mesh].primitives.map((p) =>
        json.accessors[p.attributes.POSITION]);
    return Math.max(...[0, 1, 2].map((k) =>
        Math.max(...boxes.map((b) => b.max[k])) -
        Math.min(...boxes.map((b) => b.min[k]))));
}

const inMillimetres = (m) => Math.ceil(m * 1e4) / 1e4;

function addNodes(glb, levels) {
    const { json } = glb;
    const count = json.nodes.length;
    for (let i = 0; i < count; i++) {
        const node = json.nodes[i];
        const made = levels.get(node.mesh) ?? [];
        if (made.length === 0) continue;
        const { children, extensions, extras, ...rest } = node;
        const ids = made.map(({ mesh, shape, error_m }, k) => json.nodes.push({
            ...rest,
            name: `${node.name}.${shape ? 'shape' : `lod${k + 1}`}`,
            mesh,
            extras: { error_m: inMillimetres(error_m), ...(shape && { shape }) },
        }) - 1);
        const extent = extentOf(glb, node.mesh);
        node.extensions = { ...extensions, [LOD]: { ids } };
        node.extras = { ...extras, MSFT_screencoverage: [
            ...made.map(({ error_m }) => Number(Math.min(1,
                (extent / error_m / SCREEN_PX) ** 2).toPrecision(4))), 0] };
    }
}

function tell(path, { json }) {
    const triangles = (mesh) => json.meshes[mesh].primitives.reduce((n, p) =>
        n + json.accessors[p.indices].count / 3, 0);
    for (const node of json.nodes) {
        const levels = levelsOf(node).map((i) => json.nodes[i]);
        if (levels.length > 0) {
            console.log(`${path}: ${node.name} ${triangles(node.mesh)}:`,
                levels.map(({ mesh, extras }) => `${triangles(mesh)} at ` +
                    `${(extras.error_m * 1000).toFixed(1)} mm` +
                    `${extras.shape ? ' (shape)' : ''}`).join(', '));
        }
    }
}

for (const path of process.argv.slice(2)) {
    try {
        const glb = readGlb(path);
        removeLevels(glb);
        const levels = addMeshes(glb);
        if ([...levels.values()].some((made) => made.length > 0)) {
            addNodes(glb, levels);
            glb.json.extensionsUsed = [...glb.json.extensionsUsed ?? [], LOD];
        }
        writeGlb(path, glb);
        tell(path, glb);
    } catch (error) {
        console.error(`lod.mjs: ${path}: ${error.message}`);
        process.exitCode = 1;
    }
}
