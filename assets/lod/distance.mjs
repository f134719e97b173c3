// Measures the distance between two triangle surfaces.

const sub = (p, q) => [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
const dot = (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
const mix = (p, u, s, v, t) => p.map((x, i) => x + s * u[i] + t * v[i]);

// The squared distance of a point from a triangle, after Ericson, Real-Time
// Collision Detection, 5.1.5.
function toTriangle(p, [a, b, c]) {
    const to = (q) => dot(sub(p, q), sub(p, q));
    const ab = sub(b, a), ac = sub(c, a);
    const ap = sub(p, a), bp = sub(p, b), cp = sub(p, c);
    const d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp);
    const d4 = dot(ac, bp), d5 = dot(ab, cp), d6 = dot(ac, cp);
    const va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
    if (d1 <= 0 && d2 <= 0) return to(a);
    if (d3 >= 0 && d4 <= d3) return to(b);
    if (d6 >= 0 && d5 <= d6) return to(c);
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return to(mix(a, ab, d1 / (d1 - d3), ac, 0));
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return to(mix(a, ab, 0, ac, d2 / (d2 - d6)));
    if (va <= 0 && d4 >= d3 && d5 >= d6) {
        return to(mix(b, sub(c, b), (d4 - d3) / (d4 - d3 + d5 - d6), ac, 0));
    }
    return to(mix(a, ab, vb / (va + vb + vc), ac, vc / (va + vb + vc)));
}

function cornersOf(position, list) {
    const point = (v) => [...position.subarray(v * 3, v * 3 + 3)];
    const out = [];
    for (let i = 0; i < list.length; i += 3) {
        out.push([point(list[i]), point(list[i + 1]), point(list[i + 2])]);
    }
    return out;
}

// The number of a grid cell; cells beyond 500 from the origin may share one.
const keyOf = (x, y, z) => ((x + 500) * 1000 + y + 500) * 1000 + z + 500;

// Sorts triangles into the cells that their bounding boxes touch.
function gridOf(triangles, cell) {
    const grid = new Map();
    for (const t of triangles) {
        const low = [0, 1, 2].map((k) =>
            Math.floor(Math.min(t[0][k], t[1][k], t[2][k]) / cell));
        const high = [0, 1, 2].map((k) =>
            Math.floor(Math.max(t[0][k], t[1][k], t[2][k]) / cell));
        for (let x = low[0]; x <= high[0]; x++) {
            for (let y = low[1]; y <= high[1]; y++) {
                for (let z = low[2]; z <= high[2]; z++) {
                    const key = keyOf(x, y, z);
                    if (!grid.has(key)) grid.set(key, []);
                    grid.get(key).push(t);
                }
            }
        }
    }
    return grid;
}

// Searches rings of cells outwards until no cell can hold a nearer triangle.
function nearest(p, grid, cell, rings) {
    const at = p.map((x) => Math.floor(x / cell));
    let best = Infinity;
    for (let r = 0; r <= rings && best > ((r - 1) * cell) ** 2; r++) {
        for (let x = -r; x <= r; x++) {
            for (let y = -r; y <= r; y++) {
                for (let z = -r; z <= r; z++) {
                    if (Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) < r) continue;
                    const near = grid.get(
                        keyOf(at[0] + x, at[1] + y, at[2] + z));
                    if (!near) continue;
                    for (const t of near) {
                        const d = toTriangle(p, t);
                        if (d < best) best = d;
                    }
                }
            }
        }
    }
    return Math.sqrt(best);
}

// The 99th percentile of the distances from the vertices and triangle centres of
// one list to the surface of the other. A part without a counterpart counts as
// rings * cell.
export function surfaceDistance(position, all, few, cell = 0.01, rings = 6) {
    const grid = gridOf(cornersOf(position, few), cell);
    const middles = cornersOf(position, all).map(([a, b, c]) =>
        [0, 1, 2].map((k) => (a[k] + b[k] + c[k]) / 3));
    const points = [...middles, ...[...new Set(all)].map((v) =>
        [...position.subarray(v * 3, v * 3 + 3)])];
    const distances = points.map((p) =>
        Math.min(nearest(p, grid, cell, rings), rings * cell));
    distances.sort((a, b) => a - b);
    return distances[Math.floor(0.99 * (distances.length - 1))] ?? 0;
}
