// SPDX-License-Identifier: GPL-3.0-or-later
// Colour maps as tables of [r, g, b] from 0 to 255; the tables come with the page.

/** Labels of regions, told apart by colour-blind readers too (Okabe and Ito 2008). */
export const regionColors = [[160, 160, 160], [230, 159, 0], [86, 180, 233], [0, 158, 115], [240, 228, 66], [0, 114, 178],
    [213, 94, 0], [204, 121, 167]];

/** The colour at a fraction from 0 to 1 of a table, linear between its entries. */
export function colorAt(table, fraction) {
    const place = Math.min(Math.max(fraction, 0), 1) * (table.length - 1);
    const left = Math.min(Math.floor(place), table.length - 2);
    return table[left].map((value, c) => value + (place - left) * (table[left + 1][c] - value));
}

/** 256 colours as bytes r, g, b, 255. */
export function paletteBytes(table, size = 256) {
    const bytes = new Uint8Array(4 * size);
    for (let k = 0; k < size; ++k) {
        bytes.set([...colorAt(table, k / (size - 1)).map(Math.round), 255], 4 * k);
    }
    return bytes;
}

/** A CSS gradient from the low end to the high end. */
export function gradient(table, direction = "to top") {
    const stops = table.map((color, k) => `rgb(${color.join(",")}) ${(100 * k) / (table.length - 1)}%`);
    return `linear-gradient(${direction}, ${stops.join(", ")})`;
}

/** A table that repeats the colours of regions for whole numbers from low to high. */
export function regionTable(low, high) {
    const table = [];
    for (let label = low; label <= high; ++label) {
        table.push(regionColors[((label % regionColors.length) + regionColors.length) % regionColors.length]);
    }
    return table.length > 1 ? table : [table[0], table[0]];
}
