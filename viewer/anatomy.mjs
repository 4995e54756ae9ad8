// SPDX-License-Identifier: GPL-3.0-or-later
// Where the sides of a brain are: x to the right, y to the front, z up (RAS). Standard views and marks.
import { roundStep } from "./numbers.mjs";

/**
 * Standard views: from where the camera looks (a hair off the poles, so that the front is up there), and what is cut
 * away: keep -1 shows what lies below the middle of the axis, 1 what lies above.
 */
export const views = {
    left: { label: "Left", from: [-1, 0, 0] },
    right: { label: "Right", from: [1, 0, 0] },
    "left-medial": { label: "Left medial", from: [1, 0, 0], cut: { axis: 0, keep: -1 } },
    "right-medial": { label: "Right medial", from: [-1, 0, 0], cut: { axis: 0, keep: 1 } },
    superior: { label: "Superior", from: [0, -1e-4, 1] },
    inferior: { label: "Inferior", from: [0, 1e-4, -1] },
    anterior: { label: "Anterior", from: [0, 1, 0] },
    posterior: { label: "Posterior", from: [0, -1, 0] },
    oblique: { label: "Oblique", from: [-0.62, 0.6, 0.5] },
};

/** Views of a body without sides. */
export const plainLabels = {
    left: "−x", right: "+x", "left-medial": "−x half", "right-medial": "+x half", superior: "+z", inferior: "−z",
    anterior: "+y", posterior: "−y", oblique: "Oblique",
};

const letters = [["L", "R"], ["P", "A"], ["I", "S"]];
const plainLetters = [["−x", "+x"], ["−y", "+y"], ["−z", "+z"]];
const least = 0.35;

/** What lies towards a direction of the screen: "A", "AS", ... */
export function markOf(direction, isBrain) {
    const names = isBrain ? letters : plainLetters;
    return [0, 1, 2]
        .filter((axis) => Math.abs(direction[axis]) > least)
        .sort((a, b) => Math.abs(direction[b]) - Math.abs(direction[a]))
        .slice(0, 2)
        .map((axis) => names[axis][direction[axis] > 0 ? 1 : 0])
        .join(isBrain ? "" : " ");
}

/** A round length that takes at most `pixels` on the screen: {length, pixels}. */
export function scaleBar(pixelsPerMm, pixels = 110) {
    let length = roundStep(pixels / pixelsPerMm, 1);
    while (length * pixelsPerMm > pixels) {
        length = roundStep(length / 2.2, 1);
    }
    return { length, pixels: length * pixelsPerMm };
}
