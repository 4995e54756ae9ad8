// SPDX-License-Identifier: GPL-3.0-or-later
// What the graphics processor computes: shapes between two output times, colours from a scalar, the cut.

/** Both output times are attributes; `blend` is the share of the second. NaN comes as a number beyond `none`. */
export const surfaceVertexShader = `
attribute vec3 positionNext;
attribute vec3 normalNext;
attribute float value;
attribute float valueNext;
uniform float blend;
varying vec3 place;
varying vec3 side;
varying float scalar;
void main() {
    place = mix(position, positionNext, blend);
    side = normalMatrix * mix(normal, normalNext, blend);
    scalar = mix(value, valueNext, blend);
    gl_Position = projectionMatrix * modelViewMatrix * vec4(place, 1.0);
}`;

/**
 * A light from above the viewer's left shoulder. With CUT, what lies beyond the plane `cut` is left out; without, hidden
 * places need not be coloured at all. three.js defines DOUBLE_SIDED and FLIP_SIDED by the sides that are drawn.
 */
export const surfaceFragmentShader = `
uniform sampler2D palette;
uniform vec2 range;
uniform vec4 cut;
varying vec3 place;
varying vec3 side;
varying float scalar;
const vec3 light = vec3(-0.349606, 0.549381, 0.759145);
const vec3 half_way = vec3(-0.186395, 0.292906, 0.937801); // between the light and the eye
void main() {
#ifdef CUT
    if (dot(place, cut.xyz) > cut.w) discard;
#endif
    vec3 n = normalize(side);
#ifdef DOUBLE_SIDED
    if (!gl_FrontFacing) n = -n;
#endif
#ifdef FLIP_SIDED
    n = -n;
#endif
    float share = clamp((scalar - range.x) / (range.y - range.x), 0.0, 1.0);
    vec3 base = scalar > 1e29 ? vec3(0.62) : texture2D(palette, vec2(share * 0.99609375 + 0.001953125, 0.5)).rgb;
    float shine = max(dot(n, half_way), 0.0);
    shine *= shine;
    shine *= shine;
    shine *= shine;
    shine *= shine;
    shine *= shine;
    shine *= shine;
    gl_FragColor = vec4(base * (0.40 + 0.38 * max(dot(n, light), 0.0) + 0.30 * max(n.z, 0.0)) + 0.07 * shine, 1.0);
}`;

/** Counts faces in the stencil only. */
export const countFragmentShader = `
uniform vec4 cut;
varying vec3 place;
void main() {
    if (dot(place, cut.xyz) > cut.w) discard;
    gl_FragColor = vec4(1.0);
}`;
