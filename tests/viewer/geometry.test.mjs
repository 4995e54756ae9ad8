// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import test from "node:test";
import { bounds, firstHit, mixed, orientation, planeSegments, vertexNormals } from "../../viewer/geometry.mjs";
import { roomiestColumns } from "../../viewer/stage.mjs";
import { markOf, scaleBar, views } from "../../viewer/anatomy.mjs";

// A tetrahedron, outward.
const points = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
const triangles = new Uint32Array([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]);

test("normals point outward", () => {
    const n = vertexNormals(points, triangles);
    assert.ok(n[3] > 0 && n[7] > 0 && n[11] > 0 && n[0] < 0);
    assert.ok(Math.abs(Math.hypot(n[0], n[1], n[2]) - 1) < 1e-6);
});

test("a closed surface looks outward or inward, an open one neither", () => {
    assert.equal(orientation(points, triangles), 1);
    assert.equal(orientation(points, new Uint32Array(triangles).reverse()), -1);
    assert.equal(orientation(points, triangles.slice(3)), 0);
});

test("a ray meets the nearest triangle that is shown", () => {
    const hit = firstHit(points, triangles, [0.2, 0.2, 5], [0, 0, -1]);
    assert.equal(hit.triangle, 3);
    assert.ok(hit.isFront);
    assert.ok(Math.abs(hit.point[2] - 0.6) < 1e-6);
    assert.ok(Math.abs(hit.weights.reduce((a, b) => a + b) - 1) < 1e-6);
    const behind = firstHit(points, triangles, [0.2, 0.2, 5], [0, 0, -1], (x, y, z) => z < 0.3);
    assert.equal(behind.triangle, 0);
    assert.ok(!behind.isFront);
    assert.equal(firstHit(points, triangles, [2, 2, 5], [0, 0, -1]), null);
});

test("a plane cuts a closed line", () => {
    const segments = planeSegments(points, triangles, [0, 0, 1], 0.25);
    assert.equal(segments.length, 3 * 6);
    const length = [0, 1, 2].reduce((sum, k) => sum + Math.hypot(...[0, 1, 2].map((c) => segments[6 * k + c] - segments[6 * k + 3 + c])), 0);
    assert.ok(Math.abs(length - 0.75 * (2 + Math.SQRT2)) < 1e-6);
    assert.equal(planeSegments(points, triangles, [0, 0, 1], 2).length, 0);
});

test("boxes and mixtures", () => {
    assert.deepEqual(bounds(points), { low: [0, 0, 0], high: [1, 1, 1] });
    assert.deepEqual([...mixed(new Float32Array([0, 2]), new Float32Array([1, 4]), 0.5)], [0.5, 3]);
});

test("panes lie where each has the most room", () => {
    assert.equal(roomiestColumns(2, 860, 680), 2);
    assert.equal(roomiestColumns(2, 376, 410), 1);
    assert.equal(roomiestColumns(4, 860, 680), 2);
    assert.equal(roomiestColumns(12, 860, 680), 4);
});

test("marks name the sides of a brain", () => {
    assert.equal(markOf([1, 0, 0], true), "R");
    assert.equal(markOf([0, -1, 0], true), "P");
    assert.equal(markOf([0, 0.6, 0.8], true), "SA");
    assert.equal(markOf([-1, 0, 0], false), "−x");
});

test("views look from where their names say", () => {
    assert.ok(views.left.from[0] < 0 && views.anterior.from[1] > 0 && views.superior.from[2] > 0);
    // The medial side of the left half is seen from the right.
    assert.deepEqual([views["left-medial"].from[0], views["left-medial"].cut.keep], [1, -1]);
});

test("the scale bar is round and fits", () => {
    for (const perMm of [0.3, 1, 4.7, 22, 310]) {
        const { length, pixels } = scaleBar(perMm, 110);
        assert.ok(pixels <= 110 && pixels > 30, `${perMm}: ${pixels}`);
        assert.ok(Math.abs(length * perMm - pixels) < 1e-9);
        assert.match(String(Number(length.toPrecision(3))), /^0*\.?0*[125]0*$/);
    }
});
