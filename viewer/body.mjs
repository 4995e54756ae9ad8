// SPDX-License-Identifier: GPL-3.0-or-later
// A surface over time, whose arrays are unpacked when they are asked for first.
import { bytesOf, inflated, summed, unpacked } from "./packing.mjs";
import { bounds, vertexNormals } from "./geometry.mjs";

/** The text of an array of the page. */
export function blobText(number) {
    return document.getElementById(`blob-${number}`).textContent;
}

/** Two neighbouring times and the share of the second: {a, b, blend}; times ascend. */
export function placeInTimes(times, t) {
    if (t <= times[0] || times.length === 1) {
        return { a: 0, b: 0, blend: 0 };
    }
    for (let k = 1; k < times.length; ++k) {
        if (t <= times[k] + 1e-12) {
            const blend = (t - times[k - 1]) / (times[k] - times[k - 1]);
            return blend > 1 - 1e-9 ? { a: k, b: k, blend: 0 } : { a: k - 1, b: k, blend };
        }
    }
    return { a: times.length - 1, b: times.length - 1, blend: 0 };
}

/** One body of a page; `content` is what pack_body wrote, textOf(number) the text of an array. */
export class Body {
    constructor(content, textOf = blobText) {
        this.content = content;
        this.name = content.name;
        this.isBrain = content.brain;
        this.frames = content.frames;
        this.times = content.frames.map((frame) => frame.t);
        this.hasBoundary = content.frames.every((frame) => frame.boundary);
        this.scalarKeys = Object.keys(content.ranges);
        this.textOf = textOf;
        this.cache = new Map();
    }

    once(key, make) {
        if (!this.cache.has(key)) {
            this.cache.set(key, make());
        }
        return this.cache.get(key);
    }

    async numbers(description) {
        const planes = await inflated(bytesOf(this.textOf(description.blob)));
        return unpacked(summed(planes, 2), description);
    }

    /** Numbers of the corners of all triangles. */
    triangles() {
        return this.once("triangles", async () => summed(await inflated(bytesOf(this.textOf(this.content.triangles.blob))), 4));
    }

    /** Points of a frame: of the surface ("points"), or of the boundary of cortex and white matter ("boundary"). */
    points(frame, which = "points") {
        return this.once(`${which} ${frame}`, () => this.numbers(this.frames[frame][which]));
    }

    normals(frame, which = "points") {
        return this.once(`normals ${which} ${frame}`,
            async () => vertexNormals(await this.points(frame, which), await this.triangles()));
    }

    /** Values of a scalar at the vertices in a frame; NaN where there is none. */
    values(frame, key) {
        const description = this.frames[frame].scalars[key];
        return this.once(`${key} ${frame}`, async () => (description ? this.numbers(description)
            : new Float32Array(this.content.vertices).fill(NaN)));
    }

    /** The corners of the box around a frame. */
    bounds(frame = this.frames.length - 1) {
        return this.once(`bounds ${frame}`, async () => bounds(await this.points(frame)));
    }
}
