// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a sweep: the grid of final shapes, the table, plots against the axes; what is selected is so in all of them.
import { Body } from "./body.mjs";
import { choice, element, field, section } from "./elements.mjs";
import { capital, shown, withUnit } from "./numbers.mjs";
import { plot } from "./plot.mjs";
import { viewerOrPictures } from "./run.mjs";
import { Viewer } from "./viewer.mjs";
import { warningsSection } from "./facts.mjs";

/** The order of rows by a column: numbers by size, texts by letter, what is missing last. */
export function sortedOrder(values, isDescending) {
    const order = values.map((_, k) => k);
    const isMissing = (value) => value === null || value === undefined || value === "" || Number.isNaN(value);
    return order.sort((a, b) => {
        const [x, y] = [values[a], values[b]];
        if (isMissing(x) || isMissing(y)) {
            return Number(isMissing(x)) - Number(isMissing(y));
        }
        const difference = typeof x === "number" && typeof y === "number" ? x - y : String(x).localeCompare(String(y), "en", { numeric: true });
        return isDescending ? -difference : difference;
    });
}

function labelOf(content, key) {
    return content.labels[key] || key.replaceAll("_", " ");
}

/** A table whose heads sort it and whose rows select. */
class RunTable {
    constructor(content, onSelect) {
        this.columns = [{ label: "run", of: (run) => run.name },
            ...content.axes.map((axis) => ({ label: withUnit(axis.key, axis.unit), of: (run) => run.values[axis.key] })),
            { label: "status", of: (run) => run.status },
            ...content.measures.map((key) => ({ label: capital(labelOf(content, key)), of: (run) => run.numbers[key] })),
            { label: "wall time [s]", of: (run) => run.numbers.wall_s }];
        this.runs = content.runs;
        this.body = element("tbody");
        this.heads = this.columns.map((column, k) => element("th", { "aria-sort": "none" }, element("button", { type: "button", class: "sort", onclick: () => this.sort(k) }, column.label)));
        this.rows = this.runs.map((run, k) => element("tr", { tabindex: 0, "data-run": k, onclick: () => onSelect(k), onkeydown: (event) => event.key === "Enter" && onSelect(k) },
            this.columns.map((column) => element("td", {}, typeof column.of(run) === "object" ? JSON.stringify(column.of(run) ?? null) : shown(column.of(run))))));
        this.body.append(...this.rows);
        this.element = element("div", { class: "scroll" }, element("table", { class: "runs" }, element("thead", {}, element("tr", {}, this.heads)), this.body));
    }

    sort(k) {
        const isDescending = this.heads[k].getAttribute("aria-sort") === "ascending";
        this.heads.forEach((head, other) => head.setAttribute("aria-sort", other !== k ? "none" : isDescending ? "descending" : "ascending"));
        const order = sortedOrder(this.runs.map((run) => this.columns[k].of(run)), isDescending);
        this.body.append(...order.map((row) => this.rows[row]));
    }

    select(k) {
        this.rows.forEach((row, other) => row.setAttribute("aria-selected", String(other === k)));
    }
}

/** A measure against an axis, one point a run. */
class AxisPlot {
    constructor(content, onSelect) {
        Object.assign(this, { content, onSelect, selected: -1 });
        const isNumber = (key) => content.runs.some((run) => typeof run.values[key] === "number");
        this.axes = content.axes.filter((axis) => isNumber(axis.key));
        const keys = [...content.measures, ...Object.keys(content.labels).filter((key) => !content.measures.includes(key))];
        this.axis = this.axes[0];
        this.key = keys[0];
        this.picture = element("div", { class: "axis-plot" });
        this.element = element("div", {}, element("div", { class: "row" },
            field("Measure", choice(keys.map((key) => [key, capital(labelOf(content, key))]), this.key, (key) => { this.key = key; this.draw(); })),
            field("Against", choice(this.axes.map((axis, k) => [String(k), withUnit(axis.key, axis.unit)]), "0", (k) => { this.axis = this.axes[k]; this.draw(); }))), this.picture);
        this.draw();
    }

    draw() {
        if (!this.axis) {
            this.picture.textContent = "No axis of this sweep is a number.";
            return;
        }
        const { runs } = this.content;
        const curve = { label: labelOf(this.content, this.key), x: runs.map((run) => run.values[this.axis.key]), y: runs.map((run) => run.numbers[this.key] ?? NaN), isPoints: true };
        const { svg } = plot([curve], { xLabel: withUnit(this.axis.key, this.axis.unit), description: `${curve.label} against ${this.axis.key}`, size: { width: 640, height: 300, left: 64 } });
        this.picture.innerHTML = svg;
        this.picture.querySelector(".now").remove();
        for (const mark of this.picture.querySelectorAll(".mark")) {
            mark.addEventListener("click", () => this.onSelect(Number(mark.dataset.index)));
        }
        this.select(this.selected);
    }

    select(k) {
        this.selected = k;
        for (const mark of this.picture.querySelectorAll(".mark")) {
            mark.classList.toggle("selected", Number(mark.dataset.index) === k);
        }
    }
}

export async function showSweep(content, main) {
    const bodies = content.bodies.map((body) => new Body(body));
    const state = { bodies, selected: -1 };
    const parts = [];
    const select = (k) => {
        state.selected = k;
        state.table.select(k);
        state.plot.select(k);
        const { body } = content.runs[k];
        state.viewer?.highlight?.(body);
    };
    state.table = new RunTable(content, select);
    state.plot = new AxisPlot(content, select);
    state.select = select;
    if (bodies.length) {
        const runOf = (body) => content.runs.findIndex((run) => run.body === body);
        const { viewer, lead } = viewerOrPictures(content, bodies, { captions: bodies.map((body) => body.name), onName: (k) => { select(runOf(k)); viewer.focus(k); } });
        state.viewer = viewer;
        const isDrawn = viewer instanceof Viewer;
        parts.push(element("div", { class: isDrawn ? "look" : "" }, lead, isDrawn ? element("aside", { class: "side" },
            element("p", { class: "hint" }, "Click the name of a run to open it, and once more to see all."), viewer.controls) : null));
    }
    const failed = content.runs.filter((run) => run.reason).map((run) => `${run.name}: ${run.reason}`);
    const warned = content.runs.flatMap((run) => run.warnings.map((warning) => `${run.name}: ${warning}`));
    const notes = warningsSection({ warnings: [...failed, ...warned] }, content.notes);
    document.querySelector("#lead").textContent = [`${content.runs.length} runs`, content.settings.join(", "), `Corticle ${content.version}`].filter(Boolean).join(" · ");
    main.append(...parts, ...(notes ? [notes] : []), section("Runs", state.table.element), section("Measures against the axes", state.plot.element));
    await state.viewer?.start?.();
    return { viewer: {}, ...state };
}
