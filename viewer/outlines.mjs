// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines of several bodies in one plane, as SVG.
import { element, field } from "./elements.mjs";
import { escaped } from "./plot.mjs";
import { mixed, planeSegments } from "./geometry.mjs";
import { placeInTimes } from "./body.mjs";
import { roundStep, shown } from "./numbers.mjs";
import { whenSeen } from "./player.mjs";

const size = 460;

/** The plane's two axes on the screen, to the right and up: a coronal section is seen from behind, right on the right. */
const screenAxes = [[1, 2], [0, 2], [0, 1]];

/** Outlines as an SVG text: one path for each set of segments, on one scale with a bar. */
export function outlineSvg(sets, axis, { low, high }, labels) {
    const [u, v] = screenAxes[axis];
    const middle = [0.5 * (low[u] + high[u]), 0.5 * (low[v] + high[v])];
    const perMm = (0.9 * size) / Math.max(high[u] - low[u], high[v] - low[v]);
    const place = (segments, i) => [size / 2 + perMm * (segments[i + u] - middle[0]), size / 2 - perMm * (segments[i + v] - middle[1])];
    const paths = sets.map((segments, k) => {
        let path = "";
        for (let i = 0; i < segments.length; i += 6) {
            path += `M${place(segments, i).map((x) => x.toFixed(1)).join(" ")}L${place(segments, i + 3).map((x) => x.toFixed(1)).join(" ")}`;
        }
        return `<path class="line line-${k}" d="${path}"/>`;
    });
    const bar = roundStep((0.25 * size) / perMm, 1);
    return `<svg class="plot outlines" viewBox="0 0 ${size} ${size}" role="img" aria-label="${escaped(`Outlines of ${labels.join(" and ")} in one plane`)}">` +
        `${paths.join("")}<path class="axis" d="M14 ${size - 14}h${bar * perMm}"/><text class="tick" x="14" y="${size - 20}">${shown(bar)} mm</text></svg>`;
}

/** Outlines that follow the time of a viewer; the plane has its own slider. */
export class Outlines {
    constructor(viewer, bodies) {
        Object.assign(this, { viewer, bodies, axis: 1, share: 0.5 });
        this.picture = element("div", { class: "outline-picture" });
        this.text = element("output", { class: "hint" });
        const axis = element("select", { onchange: (event) => { this.axis = Number(event.target.value); this.draw(); } },
            ["sagittal (x)", "coronal (y)", "axial (z)"].map((name, k) => element("option", { value: k, selected: k === 1 }, name)));
        const slider = element("input", { type: "range", min: 0.02, max: 0.98, step: 0.005, value: 0.5, "aria-label": "Place of the plane",
            oninput: (event) => { this.share = Number(event.target.value); this.draw(); } });
        this.element = element("div", { class: "outline-box" }, this.picture, element("div", {}, field("Plane", axis), slider, this.text));
        whenSeen(this.element, viewer, (t) => this.draw(t));
    }

    async draw(t = this.viewer.player.t) {
        const boxes = await Promise.all(this.bodies.map((body) => body.bounds()));
        const low = [0, 1, 2].map((c) => Math.min(...boxes.map((box) => box.low[c])));
        const high = [0, 1, 2].map((c) => Math.max(...boxes.map((box) => box.high[c])));
        const offset = low[this.axis] + this.share * (high[this.axis] - low[this.axis]);
        const normal = [0, 1, 2].map((c) => Number(c === this.axis));
        const sets = await Promise.all(this.bodies.map(async (body) => {
            const { a, b, blend } = placeInTimes(body.times, t);
            const points = mixed(await body.points(a), await body.points(b), blend);
            return planeSegments(points, await body.triangles(), normal, offset);
        }));
        this.picture.innerHTML = outlineSvg(sets, this.axis, { low, high }, this.bodies.map((body) => body.name));
        this.text.textContent = `${"xyz"[this.axis]} = ${shown(Number(offset.toPrecision(3)), 3)} mm`;
    }
}
