// SPDX-License-Identifier: GPL-3.0-or-later
// A click on the surface: the vertex, its values, and its curve over time.
import { capital, shown, withUnit } from "./numbers.mjs";
import { element, table } from "./elements.mjs";
import { moveNow, plot } from "./plot.mjs";

/** What a body knows at a vertex in a frame: {point, values: {key: number}}. */
export async function valuesAt(body, vertex, frame) {
    const points = await body.points(frame);
    const values = {};
    for (const key of body.scalarKeys) {
        values[key] = (await body.values(frame, key))[vertex];
    }
    return { point: [...points.slice(3 * vertex, 3 * vertex + 3)], values };
}

/** A scalar at a vertex at all output times. */
export async function historyOf(body, vertex, key) {
    const history = [];
    for (let k = 0; k < body.frames.length; ++k) {
        history.push((await body.values(k, key))[vertex]);
    }
    return history;
}

/** Shows what was clicked at in the panel; the time goes to the nearest output time, whose files hold these values. */
export class Picker {
    constructor(viewer) {
        this.viewer = viewer;
        this.panel = element("div", { class: "picked", "aria-live": "polite" },
            element("p", { class: "hint" }, "Click the surface to read its values there."));
        let down = null;
        viewer.canvas.addEventListener("pointerdown", (event) => { down = [event.clientX, event.clientY]; });
        viewer.canvas.addEventListener("pointerup", (event) => {
            if (down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4) {
                const box = viewer.canvas.getBoundingClientRect();
                this.pickAt(event.clientX - box.left, event.clientY - box.top);
            }
        });
        viewer.scalarChoice.addEventListener("change", () => this.refresh());
        viewer.onTime((t) => {
            this.follow(t);
        });
    }

    async pickAt(x, y) {
        const hit = await this.viewer.stage.pick(x, y);
        return hit ? this.choose(hit.pane, hit.vertex) : undefined;
    }

    async choose(pane, vertex) {
        for (const other of this.viewer.stage.panes) {
            other.picked = other === pane ? vertex : -1;
            other.placeMarker();
        }
        this.pane = pane;
        this.vertex = vertex;
        this.viewer.stage.draw();
        await this.refresh();
    }

    frameAt(t) {
        const distances = this.pane.body.times.map((time) => Math.abs(time - t));
        return distances.indexOf(Math.min(...distances));
    }

    async refresh() {
        if (!this.pane) {
            return;
        }
        const { body } = this.pane;
        this.frame = this.frameAt(this.viewer.player.t);
        const { point, values } = await valuesAt(body, this.vertex, this.frame);
        const rows = Object.entries(values).map(([key, value]) => {
            const scalar = this.viewer.scalar(key);
            return [capital(withUnit(scalar.label, scalar.unit)), shown(value)];
        });
        const scalar = this.viewer.scalar();
        const curve = { label: "", x: body.times, y: await historyOf(body, this.vertex, this.viewer.key) };
        const { svg, frame } = plot([curve], { xLabel: "growth time t", yLabel: "",
            description: `${scalar.label} at vertex ${this.vertex} over time`, size: { width: 300, height: 150 } });
        const chart = element("div", {});
        chart.innerHTML = svg;
        this.curve = { svg: chart.firstChild, frame };
        this.panel.replaceChildren(
            element("h3", {}, `Vertex ${this.vertex}`),
            element("p", { class: "hint" }, `x, y, z = ${point.map((value) => shown(value, 4)).join(", ")} mm at t = ${shown(body.times[this.frame], 3)}`),
            table(["", ""], rows, { class: "values" }),
            element("p", { class: "caption" }, `${capital(withUnit(scalar.label, scalar.unit))} over time`), chart);
        moveNow(this.curve.svg, frame, this.viewer.player.t);
    }

    follow(t) {
        if (this.curve) {
            moveNow(this.curve.svg, this.curve.frame, t);
        }
        if (this.pane && this.frameAt(t) !== this.frame && !this.viewer.player.isPlaying) {
            this.refresh();
        }
    }
}
