// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles: normals, what a ray hits, where a plane cuts. Points are x, y, z one after the other.

/** Normals of the vertices, weighted with area. */
export function vertexNormals(points, triangles) {
    const normals = new Float32Array(points.length);
    for (let i = 0; i < triangles.length; i += 3) {
        const [a, b, c] = [3 * triangles[i], 3 * triangles[i + 1], 3 * triangles[i + 2]];
        const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1], uz = points[b + 2] - points[a + 2];
        const vx = points[c] - points[a], vy = points[c + 1] - points[a + 1], vz = points[c + 2] - points[a + 2];
        const nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
        for (const v of [a, b, c]) {
            normals[v] += nx;
            normals[v + 1] += ny;
            normals[v + 2] += nz;
        }
    }
    for (let i = 0; i < normals.length; i += 3) {
        const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]) || 1;
        normals[i] /= length;
        normals[i + 1] /= length;
        normals[i + 2] /= length;
    }
    return normals;
}

/** 1 where the triangles of a closed surface look outward, -1 where they look inward, 0 where the surface is open. */
export function orientation(points, triangles) {
    const sum = [0, 0, 0]; // of the area vectors: 0 for a closed surface
    let volume = 0, area = 0;
    for (let i = 0; i < triangles.length; i += 3) {
        const [a, b, c] = [3 * triangles[i], 3 * triangles[i + 1], 3 * triangles[i + 2]];
        const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1], uz = points[b + 2] - points[a + 2];
        const vx = points[c] - points[a], vy = points[c + 1] - points[a + 1], vz = points[c + 2] - points[a + 2];
        const nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
        sum[0] += nx;
        sum[1] += ny;
        sum[2] += nz;
        area += Math.hypot(nx, ny, nz);
        volume += nx * points[a] + ny * points[a + 1] + nz * points[a + 2];
    }
    return Math.hypot(...sum) > 1e-3 * area ? 0 : Math.sign(volume);
}

/** Least and largest coordinates: {low: [x, y, z], high: [x, y, z]}. */
export function bounds(points) {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < points.length; ++i) {
        const c = i % 3;
        low[c] = Math.min(low[c], points[i]);
        high[c] = Math.max(high[c], points[i]);
    }
    return { low, high };
}

/**
 * The first triangle on a ray: {triangle, distance, weights, point, isFront}, or null (Möller and Trumbore 1997). It is
 * seen from its front where its corners run counter-clockwise.
 * isShown(x, y, z) leaves out what is cut away.
 */
export function firstHit(points, triangles, origin, direction, isShown = () => true) {
    let best = null;
    const [ox, oy, oz] = origin, [dx, dy, dz] = direction;
    for (let i = 0; i < triangles.length; i += 3) {
        const a = 3 * triangles[i], b = 3 * triangles[i + 1], c = 3 * triangles[i + 2];
        const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1], uz = points[b + 2] - points[a + 2];
        const vx = points[c] - points[a], vy = points[c + 1] - points[a + 1], vz = points[c + 2] - points[a + 2];
        const px = dy * vz - dz * vy, py = dz * vx - dx * vz, pz = dx * vy - dy * vx;
        const determinant = ux * px + uy * py + uz * pz;
        if (Math.abs(determinant) < 1e-12) {
            continue;
        }
        const tx = ox - points[a], ty = oy - points[a + 1], tz = oz - points[a + 2];
        const u = (tx * px + ty * py + tz * pz) / determinant;
        if (u < 0 || u > 1) {
            continue;
        }
        const qx = ty * uz - tz * uy, qy = tz * ux - tx * uz, qz = tx * uy - ty * ux;
        const v = (dx * qx + dy * qy + dz * qz) / determinant;
        const distance = (vx * qx + vy * qy + vz * qz) / determinant;
        if (v < 0 || u + v > 1 || distance < 0 || (best && distance >= best.distance)) {
            continue;
        }
        const point = [ox + distance * dx, oy + distance * dy, oz + distance * dz];
        if (isShown(...point)) {
            best = { triangle: i / 3, distance, weights: [1 - u - v, u, v], point, isFront: determinant > 0 };
        }
    }
    return best;
}

/** Segments where the plane normal·x = offset cuts the triangles: x, y, z of both ends, one after the other. */
export function planeSegments(points, triangles, normal, offset) {
    const height = (v) => normal[0] * points[3 * v] + normal[1] * points[3 * v + 1] + normal[2] * points[3 * v + 2] - offset;
    const segments = [];
    for (let i = 0; i < triangles.length; i += 3) {
        const corners = [triangles[i], triangles[i + 1], triangles[i + 2]];
        const heights = corners.map(height);
        if (heights.every((h) => h >= 0) || heights.every((h) => h < 0)) {
            continue;
        }
        for (let k = 0; k < 3; ++k) {
            const a = k, b = (k + 1) % 3;
            if (heights[a] >= 0 !== heights[b] >= 0) {
                const share = heights[a] / (heights[a] - heights[b]);
                for (let c = 0; c < 3; ++c) {
                    const from = points[3 * corners[a] + c];
                    segments.push(from + share * (points[3 * corners[b] + c] - from));
                }
            }
        }
    }
    return new Float32Array(segments);
}

/** (1 - blend) a + blend b. */
export function mixed(a, b, blend) {
    return blend === 0 || a === b ? a : a.map((value, i) => value + blend * (b[i] - value));
}
