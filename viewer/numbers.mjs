// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as people read them: round steps, ticks, few digits.

/** 1, 2 or 5 times a power of ten, near length / count. */
export function roundStep(length, count) {
    const rough = length / count;
    const power = 10 ** Math.floor(Math.log10(rough));
    const digit = rough / power;
    return power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
}

/** Round numbers between low and high, about `count` of them. */
export function ticks(low, high, count = 5) {
    if (!(high > low)) {
        return [low];
    }
    const step = roundStep(high - low, count);
    const result = [];
    for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) {
        result.push(Number((k * step).toPrecision(12)));
    }
    return result;
}

/** `digits` significant digits, without trailing zeros; powers of ten only where needed. */
export function shown(value, digits = 4) {
    if (value === null || value === undefined || Number.isNaN(value)) {
        return "–";
    }
    if (typeof value !== "number") {
        return String(value);
    }
    const size = Math.abs(value);
    if (Number.isInteger(value) && size < 1e15) {
        return grouped(value);
    }
    if (size !== 0 && (size >= 1e7 || size < 1e-4)) {
        const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
        return `${Number(mantissa)}·10${superscript(Number(exponent))}`.replace("-", "−");
    }
    return size >= 10 ** digits ? grouped(Math.round(value)) : String(Number(value.toPrecision(digits))).replace("-", "−");
}

/** A whole number with thin spaces between thousands. */
export function grouped(value) {
    const text = String(Math.abs(value));
    const spaced = text.length > 4 ? text.replace(/\B(?=(\d{3})+$)/g, "\u202f") : text;
    return (value < 0 ? "−" : "") + spaced;
}

function superscript(number) {
    const digits = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };
    return String(number).split("").map((c) => digits[c]).join("");
}

/** "label [unit]", or the label alone. */
export function withUnit(label, unit) {
    return unit ? `${label} [${unit}]` : label;
}

/** The same with a capital first letter. */
export function capital(text) {
    return text.charAt(0).toUpperCase() + text.slice(1);
}
