// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import test from "node:test";
import { axisRange, escaped, frameOf, plot } from "../../viewer/plot.mjs";
import { colorAt, gradient, paletteBytes, regionTable } from "../../viewer/colors.mjs";
import { interpolated, placeOnAxis, timeAxis } from "../../viewer/measures.mjs";

test("axes begin and end at round numbers around all values", () => {
    assert.deepEqual(axisRange([0.13, 0.97]), [0, 1]);
    assert.deepEqual(axisRange([2.1, 2.9]), [2, 3]);
    assert.deepEqual(axisRange([3, 3]), [1.5, 4.5]);
    assert.deepEqual(axisRange([NaN]), [0, 1]);
});

test("a plot holds its values, and nothing of a label is markup", () => {
    const { svg, frame } = plot([{ label: "<b>", x: [0, 0.5, 1], y: [1, NaN, 3] }], { xLabel: "<script>", description: 'a "b"' });
    assert.ok(!svg.includes("<script>") && !svg.includes("<b>") && svg.includes("&lt;script&gt;"));
    assert.equal((svg.match(/<circle/g) || []).length, 2);
    assert.ok(svg.includes(`cx="${frame.toX(1).toFixed(1)}"`));
    assert.ok(frame.toX(0) === frame.left && frame.toX(1) === frame.width - frame.right);
    assert.ok(frame.toY(1) > frame.toY(3));
});

test("a plot without values does not fail", () => {
    assert.ok(frameOf([{ x: [], y: [] }]).toX(0.5) > 0);
    assert.ok(plot([]).svg.startsWith("<svg"));
});

test("escaping", () => {
    assert.equal(escaped(`<a b='c' d="e">&`), "&lt;a b=&#39;c&#39; d=&quot;e&quot;&gt;&amp;");
});

test("colours", () => {
    const table = [[0, 0, 0], [100, 200, 50]];
    assert.deepEqual(colorAt(table, 0.5), [50, 100, 25]);
    assert.deepEqual(colorAt(table, 9), [100, 200, 50]);
    assert.deepEqual([...paletteBytes(table, 3)], [0, 0, 0, 255, 50, 100, 25, 255, 100, 200, 50, 255]);
    assert.match(gradient(table), /^linear-gradient\(to top, rgb\(0,0,0\) 0%/);
    assert.equal(regionTable(0, 3).length, 4);
    assert.equal(regionTable(2, 2).length, 2);
});

test("time runs in weeks where they are known", () => {
    const t = { key: "t", values: [0, 0.5, 1] };
    assert.equal(timeAxis([t, { key: "week", values: [NaN, NaN, NaN] }]).isWeek, false);
    const axis = timeAxis([t, { key: "week", values: [23, 30, 38] }]);
    assert.equal(axis.isWeek, true);
    assert.equal(placeOnAxis(axis, 0.25), 26.5);
    assert.equal(placeOnAxis(axis, 9), 38);
    assert.equal(interpolated([0, 1], [2, 6], 0.25), 3);
});
