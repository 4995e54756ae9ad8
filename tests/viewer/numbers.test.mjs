// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import test from "node:test";
import { capital, grouped, roundStep, shown, ticks, withUnit } from "../../viewer/numbers.mjs";

test("steps are 1, 2 or 5 times a power of ten", () => {
    assert.deepEqual([roundStep(1, 5), roundStep(3.2, 5), roundStep(45, 10), roundStep(0.07, 10)], [0.2, 0.5, 5, 0.005]);
});

test("ticks are round and inside", () => {
    assert.deepEqual(ticks(0.03, 1.02, 5), [0.2, 0.4, 0.6, 0.8, 1]);
    assert.deepEqual(ticks(-3, 3, 3), [-2, 0, 2]);
    assert.deepEqual(ticks(2, 2), [2]);
});

test("numbers have few digits", () => {
    assert.equal(shown(2.4531234), "2.453");
    assert.equal(shown(-0.5), "−0.5");
    assert.equal(shown(45000), "45\u202f000");
    assert.equal(shown(1234567.8), "1\u202f234\u202f568");
    assert.equal(shown(1.2345e-7, 3), "1.23·10⁻⁷");
    assert.equal(shown(NaN), "–");
    assert.equal(shown(null), "–");
    assert.equal(grouped(-12345), "−12\u202f345");
});

test("labels", () => {
    assert.equal(withUnit("depth", "mm"), "depth [mm]");
    assert.equal(withUnit("index", ""), "index");
    assert.equal(capital("volume ratio J"), "Volume ratio J");
});
