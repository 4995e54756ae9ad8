// SPDX-License-Identifier: GPL-3.0-or-later
// Arrays as src/corticle/report/packed.hpp packs them: planes of bytes of differences, deflated, base64.

const missing = 65535;
const largest = 65534;

/** Bytes of a base64 text. */
export function bytesOf(base64) {
    const text = atob(base64);
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) {
        bytes[i] = text.charCodeAt(i);
    }
    return bytes;
}

/** What a zlib stream holds. */
export async function inflated(bytes) {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Whole numbers of `width` bytes from the planes of their differences. */
export function summed(planes, width) {
    const count = planes.length / width;
    const numbers = width === 4 ? new Uint32Array(count) : new Uint16Array(count);
    let before = 0;
    for (let i = 0; i < count; ++i) {
        let difference = 0;
        for (let k = 0; k < width; ++k) {
            difference |= planes[k * count + i] << (8 * k);
        }
        before = (before + difference) >>> 0;
        numbers[i] = before;
    }
    return numbers;
}

/** Numbers of a description {count, low, high}: component after component becomes point after point. */
export function unpacked(numbers, { count, low, high }) {
    const components = low.length;
    const values = new Float32Array(components * count);
    for (let c = 0; c < components; ++c) {
        const step = (high[c] - low[c]) / largest;
        for (let i = 0; i < count; ++i) {
            const number = numbers[c * count + i];
            values[components * i + c] = number === missing ? NaN : low[c] + step * number;
        }
    }
    return values;
}
