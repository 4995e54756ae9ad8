// SPDX-License-Identifier: GPL-3.0-or-later
// Line plots as SVG text, with round ticks. Colours come from the style sheet: .line-0, .line-1, ...
import { roundStep, shown, ticks } from "./numbers.mjs";

/** Text for an element or an attribute of HTML or SVG. */
export function escaped(text) {
    const names = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;" };
    return String(text).replace(/[&<>"']/g, (c) => names[c]);
}

/** Where an axis begins and ends so that all values lie inside, at round numbers. */
export function axisRange(values, count = 4) {
    const finite = values.filter((value) => Number.isFinite(value));
    if (finite.length === 0) {
        return [0, 1];
    }
    let low = Math.min(...finite), high = Math.max(...finite);
    const size = Math.max(Math.abs(low), Math.abs(high));
    if (high - low <= 1e-9 * size || high === low) {
        const half = size > 0 ? size / 2 : 1;
        return [low - half, high + half];
    }
    if (low > 0 && low < 0.3 * high) {
        low = 0;
    }
    const step = roundStep(high - low, count);
    return [Math.floor(low / step + 1e-9) * step, Math.ceil(high / step - 1e-9) * step];
}

/** Scales of a plot: functions from values to places in the picture. */
export function frameOf(curves, { width = 300, height = 180, left = 52, right = 12, top = 10, bottom = 34 } = {}) {
    const xs = curves.flatMap((curve) => curve.x).filter(Number.isFinite);
    const x = xs.length ? [Math.min(...xs), Math.max(...xs)] : [0, 1];
    if (x[0] === x[1]) {
        x[0] -= 0.5;
        x[1] += 0.5;
    }
    const y = axisRange(curves.flatMap((curve) => curve.y));
    return {
        width, height, left, right, top, bottom, x, y,
        toX: (value) => left + ((value - x[0]) / (x[1] - x[0])) * (width - left - right),
        toY: (value) => height - bottom - ((value - y[0]) / (y[1] - y[0])) * (height - top - bottom),
    };
}

function pathOf(curve, frame) {
    let path = "", down = false;
    curve.x.forEach((x, i) => {
        const y = curve.y[i];
        if (!Number.isFinite(x) || !Number.isFinite(y)) {
            down = false;
            return;
        }
        path += `${down ? "L" : "M"}${frame.toX(x).toFixed(1)} ${frame.toY(y).toFixed(1)}`;
        down = true;
    });
    return path;
}

function axes(frame, xLabel, yLabel) {
    const { left, top, width, height, right, bottom } = frame;
    let text = `<path class="axis" d="M${left} ${top}V${height - bottom}H${width - right}"/>`;
    for (const y of ticks(...frame.y, 4)) {
        const at = frame.toY(y).toFixed(1);
        text += `<path class="grid" d="M${left} ${at}H${width - right}"/>` +
            `<text class="tick" x="${left - 6}" y="${at}" dy="0.32em" text-anchor="end">${escaped(shown(y))}</text>`;
    }
    for (const x of ticks(...frame.x, 5)) {
        const at = frame.toX(x).toFixed(1);
        text += `<text class="tick" x="${at}" y="${height - bottom + 14}" text-anchor="middle">${escaped(shown(x))}</text>`;
    }
    text += `<text class="label" x="${(left + width - right) / 2}" y="${height - 4}" text-anchor="middle">${escaped(xLabel)}</text>`;
    return yLabel ? `${text}<text class="label" x="${left}" y="${top - 2}" text-anchor="start">${escaped(yLabel)}</text>` : text;
}

/**
 * A plot: {svg, frame}. Curves are {label, x, y, isPoints}; `description` is its text alternative. The line with class
 * "now" marks a time; moveNow() moves it.
 */
export function plot(curves, { xLabel = "", yLabel = "", description = "", size = {}, markPoints = true } = {}) {
    const frame = frameOf(curves, size);
    let text = `<svg class="plot" viewBox="0 0 ${frame.width} ${frame.height}" role="img" aria-label="${escaped(description)}">`;
    text += axes(frame, xLabel, yLabel);
    text += `<path class="now" d="M${frame.left} ${frame.top}V${frame.height - frame.bottom}"/>`;
    curves.forEach((curve, k) => {
        if (!curve.isPoints) {
            text += `<path class="line line-${k}" d="${pathOf(curve, frame)}"/>`;
        }
        curve.x.forEach((x, i) => {
            if ((curve.isPoints || markPoints) && Number.isFinite(x) && Number.isFinite(curve.y[i])) {
                const title = `${curve.label ? curve.label + ": " : ""}${shown(x)}: ${shown(curve.y[i], 6)}`;
                text += `<circle class="mark line-${k}" cx="${frame.toX(x).toFixed(1)}" cy="${frame.toY(curve.y[i]).toFixed(1)}" ` +
                    `r="${curve.isPoints ? 4 : 2.2}" data-curve="${k}" data-index="${i}"><title>${escaped(title)}</title></circle>`;
            }
        });
    });
    return { svg: `${text}</svg>`, frame };
}

/** Puts the line of the present time at x. */
export function moveNow(svg, frame, x) {
    const at = frame.toX(Math.min(Math.max(x, frame.x[0]), frame.x[1])).toFixed(1);
    svg.querySelector(".now").setAttribute("d", `M${at} ${frame.top}V${frame.height - frame.bottom}`);
}
