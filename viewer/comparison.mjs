// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a comparison: two runs, or a run and real brains.
import { Body } from "./body.mjs";
import { choice, element, field, legend, section, table } from "./elements.mjs";
import { linkedPlot } from "./measures.mjs";
import { capital, shown, withUnit } from "./numbers.mjs";
import { Outlines } from "./outlines.mjs";
import { Picker } from "./pick.mjs";
import { viewerOrPictures } from "./run.mjs";
import { Viewer } from "./viewer.mjs";
import { warningsSection } from "./facts.mjs";

const wide = { width: 560, height: 240 };

function percentText(value) {
    return value === null || value === undefined ? "" : `${value > 0 ? "+" : ""}${shown(value, 3)} %`;
}

/** Distances of the surfaces at the time shown, and against time. */
function distanceSection(content, viewer) {
    const keys = [["surface_distance_mean_mm", "mean"], ["surface_distance_95_mm", "95 %"], ["surface_distance_hausdorff_mm", "largest (Hausdorff)"]];
    const t = content.frames.map((frame) => frame.t[0]);
    const columns = keys.map(([key, label]) => ({ label, values: content.frames.map((frame) => frame[key]) }));
    const axis = { label: "growth time t", values: t, t };
    return section("Distance of the surfaces", element("p", { class: "hint" }, "From the vertices of each surface to the other one, both ways together."),
        element("div", { class: "plots wide" }, linkedPlot(viewer, axis, "Distance [mm]", columns, "", wide),
            linkedPlot(viewer, axis, "Mean difference of J", [{ label: "J", values: content.frames.map((frame) => frame.J_mean_difference) }], "", wide)));
}

function runsMeasures(content, viewer) {
    const axis = { label: "growth time t", values: content.t, t: content.t };
    const telling = content.paired.filter((row) => [...row.a, ...row.b].some((value) => value));
    const last = content.t.length - 1;
    return [
        section("Measures", legend(content.names), element("div", { class: "plots" }, telling.map((row) =>
            linkedPlot(viewer, axis, capital(withUnit(row.label, row.unit)), content.names.map((label, k) => ({ label, values: k ? row.b : row.a })), "", undefined, true)))),
        section(`At t = ${shown(content.t[last], 3)}`, element("div", { class: "scroll" }, table(["", "unit", ...content.names, "difference"], content.paired.map((row) =>
            [capital(row.label), row.unit, shown(row.a[last]), shown(row.b[last]), percentText(row.percent[last])])))),
        section("Runs", element("div", { class: "scroll" }, table(["", ...content.names], content.rows.map(([label, a, b]) => [capital(label), shown(a), shown(b)])))),
    ];
}

function realMeasures(content) {
    const label = content.axis === "week" ? "gestational week" : "growth time t";
    const axis = { label, values: content.places, t: content.places };
    const plots = content.measures.map((row) => linkedPlot(null, axis, capital(withUnit(row.label, row.unit)), [
        { label: "run", values: row.values },
        { label: "real", values: row.points.map((point) => point.real), x: row.points.map((point) => point.at), isPoints: true },
    ], "", undefined, true));
    const rows = content.measures.flatMap((row) => row.points.map((point) => [capital(withUnit(row.label, row.unit)), shown(point.at), shown(point.real), shown(point.run), percentText(point.percent)]));
    return [section("Measures, by week", legend(["run", "real"]), element("div", { class: "plots" }, plots)),
        section("Run less real", element("div", { class: "scroll" }, table(["", content.axis, "real", "run", "difference"], rows)))];
}

/** The panes of one pair, with outlines and distances. */
function showPair(content, pair) {
    const bodies = pair.bodies.map((body) => new Body(body));
    const { viewer, lead } = viewerOrPictures(content, bodies, { captions: bodies.map((body) => body.name) });
    const isDrawn = viewer instanceof Viewer;
    const picker = isDrawn ? new Picker(viewer) : null;
    const outlines = new Outlines(viewer, bodies);
    const distance = pair.distance ? element("p", {}, `Distance: mean ${shown(pair.distance.mean, 3)} mm, 95 % below ${shown(pair.distance.p95, 3)} mm, largest ${shown(pair.distance.hausdorff, 3)} mm.`) : null;
    const parts = [element("div", { class: isDrawn ? "look" : "" }, lead, isDrawn ? element("aside", { class: "side" }, viewer.controls, picker.panel) : null),
        section("Outlines", distance, legend(bodies.map((body) => body.name)), outlines.element)];
    return { viewer, picker, bodies, outlines, parts };
}

export async function showComparison(content, main) {
    const place = element("div");
    const state = {};
    const show = async (k) => {
        state.viewer?.dispose?.();
        const pair = showPair(content, content.pairs[k]);
        place.replaceChildren(...pair.parts);
        Object.assign(state, pair);
        await pair.viewer.start?.();
        return pair;
    };
    const chooser = content.pairs.length > 1 ? field("Real brain", choice(content.pairs.map((pair, k) => [String(k), pair.label]), "0", (k) => show(Number(k)), { id: "pair" })) : null;
    main.append(...[chooser, place].filter(Boolean));
    if (content.pairs.length) {
        await show(0);
    }
    const viewer = state.viewer || { onTime: () => {}, player: { goTo: () => {} } };
    document.querySelector("#lead").textContent = `Comparison by Corticle ${content.version}`;
    const notes = warningsSection({ warnings: [] }, content.notes);
    main.append(...(notes ? [notes] : []), ...(content.paired ? [distanceSection(content, viewer), ...runsMeasures(content, viewer)] : realMeasures(content)));
    return state;
}
