// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import test from "node:test";
import { deflateSync } from "node:zlib";
import { Body, placeInTimes } from "../../viewer/body.mjs";
import { bytesOf, inflated, summed, unpacked } from "../../viewer/packing.mjs";

/** Planes of bytes of the differences of numbers, as the program writes them. */
function planes(numbers, width) {
    const bytes = new Uint8Array(width * numbers.length);
    let before = 0;
    numbers.forEach((number, i) => {
        const difference = (number - before) >>> 0;
        before = number;
        for (let k = 0; k < width; ++k) {
            bytes[k * numbers.length + i] = (difference >>> (8 * k)) & 255;
        }
    });
    return bytes;
}

const packed = (numbers, width) => deflateSync(planes(numbers, width)).toString("base64");

test("what is packed comes back", async () => {
    const numbers = [0, 65534, 3, 65535, 17, 17, 0];
    assert.deepEqual([...summed(await inflated(bytesOf(packed(numbers, 2))), 2)], numbers);
    const indices = [4000000000, 5, 70000, 0];
    assert.deepEqual([...summed(await inflated(bytesOf(packed(indices, 4))), 4)], indices);
});

test("numbers lie between the ends of their component; 65535 is missing", () => {
    const values = unpacked([0, 65534, 32767, 65535], { count: 2, low: [-1, 10], high: [1, 30] });
    assert.deepEqual([...values.slice(0, 3)], [-1, 20, 1]);
    assert.ok(Number.isNaN(values[3]));
});

test("a body unpacks its arrays once, when they are asked for", async () => {
    const texts = [packed([0, 1, 2], 4), packed([0, 65534, 0, 0, 0, 65534, 0, 0, 0], 2), packed([0, 65534, 32767], 2)];
    let asked = 0;
    const body = new Body({ name: "a", brain: true, vertices: 3, ranges: { J: {} }, triangles: { blob: 0 },
        frames: [{ t: 0, week: null, points: { blob: 1, count: 3, low: [0, 0, 0], high: [2, 3, 0] }, scalars: { J: { blob: 2, count: 3, low: [1], high: [3] } } }] },
    (number) => { ++asked; return texts[number]; });
    assert.deepEqual([...await body.points(0)], [0, 0, 0, 2, 0, 0, 0, 3, 0]);
    assert.deepEqual([...await body.points(0)].length, 9);
    assert.equal(asked, 1);
    assert.deepEqual([...await body.values(0, "J")], [1, 3, 2]);
    assert.ok(Number.isNaN((await body.values(0, "unknown"))[2] ?? (await body.values(0, "unknown"))[0]));
    assert.deepEqual([...await body.normals(0)].slice(0, 3), [0, 0, 1]);
    assert.deepEqual(await body.bounds(), { low: [0, 0, 0], high: [2, 3, 0] });
});

test("places between output times", () => {
    assert.deepEqual(placeInTimes([0, 0.5, 1], 0.75), { a: 1, b: 2, blend: 0.5 });
    assert.deepEqual(placeInTimes([0, 0.5, 1], 0.5), { a: 1, b: 1, blend: 0 });
    assert.deepEqual(placeInTimes([0, 0.5, 1], 7), { a: 2, b: 2, blend: 0 });
    assert.deepEqual(placeInTimes([0.3], 7), { a: 0, b: 0, blend: 0 });
});
