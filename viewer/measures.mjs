// SPDX-License-Identifier: GPL-3.0-or-later
// Plots of measures against time, linked to it.
import { capital, shown, withUnit } from "./numbers.mjs";
import { element, legend, section } from "./elements.mjs";
import { moveNow, plot } from "./plot.mjs";
import { whenSeen } from "./player.mjs";

const groups = ["Folds", "Size", "Tissue", "Energy and balance", "Steps and checks"];
const energies = ["work_growth", "energy_elastic", "energy_dissipated", "energy_zero_mode", "energy_kinetic", "energy_contact"];
const headlines = ["gi_hull", "area_ratio", "thickness_mean_mm", "sulcal_depth_mean_mm"];

/** A column of a table of measures; undefined where there is none. */
export function columnOf(measures, key) {
    return measures.find((column) => column.key === key);
}

/** The axis of time: weeks where the run knows them, else growth time. */
export function timeAxis(measures) {
    const week = columnOf(measures, "week");
    const t = columnOf(measures, "t");
    return week && week.values.every(Number.isFinite) ? { label: "gestational week", values: week.values, t: t.values, isWeek: true }
        : { label: "growth time t", values: t.values, t: t.values, isWeek: false };
}

/** The place on the axis of a growth time. */
export function placeOnAxis(axis, t) {
    const k = axis.t.findIndex((value) => value >= t);
    if (k <= 0) {
        return axis.values[k < 0 ? axis.values.length - 1 : 0];
    }
    const share = (t - axis.t[k - 1]) / (axis.t[k] - axis.t[k - 1]);
    return axis.values[k - 1] + share * (axis.values[k] - axis.values[k - 1]);
}

/** A plot of columns against an axis, whose line follows the viewer and whose points set its time. */
export function linkedPlot(viewer, axis, title, columns, sentence, size, hasLegend = false) {
    const curves = columns.map((column) => ({ label: columns.length > 1 ? column.label : "", x: column.x || axis.values, y: column.values, isPoints: column.isPoints }));
    const { svg, frame } = plot(curves, { xLabel: axis.label, description: `${title} against ${axis.label}`, size });
    const figure = element("figure", { class: "measure", title: sentence || undefined });
    figure.innerHTML = svg;
    figure.prepend(element("figcaption", {}, title), ...(columns.length > 1 && !hasLegend ? [legend(columns.map((column) => column.label))] : []));
    const picture = figure.querySelector("svg");
    figure.addEventListener("click", (event) => {
        const index = event.target.dataset?.index;
        const curve = event.target.dataset?.curve;
        if (index !== undefined && !curves[curve].isPoints) {
            viewer?.player.goTo((columns[curve].t || axis.t)[index]);
        }
    });
    if (viewer) {
        whenSeen(figure, viewer, (t) => moveNow(picture, frame, placeOnAxis(axis, t)));
    } else {
        picture.querySelector(".now").remove();
    }
    return figure;
}

function isTelling(column) {
    return column.values.some((value) => Number.isFinite(value) && value !== 0);
}

/** Numbers that matter most, at the time shown. */
export function headline(viewer, measures) {
    const axis = timeAxis(measures);
    const tiles = headlines.map((key) => columnOf(measures, key)).filter((column) => column && isTelling(column)).map((column) => {
        const number = element("b");
        viewer.onTime((t) => {
            number.textContent = shown(interpolated(axis.t, column.values, t), 3) + (column.unit ? `\u202f${column.unit}` : "");
        });
        return element("div", { class: "tile", title: column.sentence }, number, element("span", {}, capital(column.label)));
    });
    return element("div", { class: "tiles" }, tiles);
}

/** Linear between the values at t. */
export function interpolated(ts, values, t) {
    const k = ts.findIndex((value) => value >= t - 1e-12);
    if (k <= 0) {
        return values[k < 0 ? values.length - 1 : 0];
    }
    return values[k - 1] + ((t - ts[k - 1]) / (ts[k] - ts[k - 1])) * (values[k] - values[k - 1]);
}

/** The energy balance in one plot: what growth put in, and where it is. */
export function energyPlot(viewer, measures) {
    const columns = energies.map((key) => columnOf(measures, key)).filter((column) => column && isTelling(column));
    const axis = timeAxis(measures);
    const error = columnOf(measures, "energy_balance_error");
    const last = error?.values.at(-1);
    return section("Energy balance",
        element("p", {}, "Growth puts in work; it is stored elastically or dissipated.",
            last !== undefined ? ` The balance closes to ${shown(100 * Math.abs(last), 2)} % at the end.` : ""),
        element("div", { class: "one-plot" }, linkedPlot(viewer, axis, "Energies [μ_w mm³]", columns, "", { width: 720, height: 260, left: 64 })));
}

/** All measures, in groups; those that stay 0 are named in one line. */
export function measuresSection(viewer, measures) {
    const axis = timeAxis(measures);
    const parts = [];
    const silent = [];
    for (const group of groups) {
        const columns = measures.filter((column) => column.group === group && column.key !== "t" && column.key !== "week");
        silent.push(...columns.filter((column) => !isTelling(column)));
        const telling = columns.filter(isTelling);
        if (telling.length) {
            parts.push(element("h3", {}, group), element("div", { class: "plots" }, telling.map((column) =>
                linkedPlot(viewer, axis, capital(withUnit(column.label, column.unit)), [column], column.sentence))));
        }
    }
    if (silent.length) {
        parts.push(element("p", { class: "hint" }, `Zero or unknown throughout: ${silent.map((column) => column.label).join("; ")}.`));
    }
    return section("Measures", element("p", { class: "hint" }, "Click a point to go to its time."), parts);
}
