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

/** A light from above the viewer's left shoulder; what lies beyond the plane `cut` is left out. */
export const surfaceFragmentShader = `
uniform sampler2D palette;
uniform vec2 range;
uniform vec4 cut;
uniform bool plain;
varying vec3 place;
varying vec3 side;
varying float scalar;
void main() {
    if (dot(place, cut.xyz) > cut.w) discard;
    vec3 n = normalize(side);
    if (!gl_FrontFacing) n = -n;
    float share = clamp((scalar - range.x) / (range.y - range.x), 0.0, 1.0);
    vec3 base = texture2D(palette, vec2(share * 0.99609375 + 0.001953125, 0.5)).rgb;
    if (scalar > 1e29) base = vec3(0.62);
    if (plain) base = vec3(0.84, 0.83, 0.80);
    vec3 light = normalize(vec3(-0.35, 0.55, 0.76));
    float diffuse = max(dot(n, light), 0.0);
    float front = max(n.z, 0.0);
    float shine = pow(max(dot(reflect(-light, n), vec3(0.0, 0.0, 1.0)), 0.0), 24.0);
    vec3 color = base * (0.40 + 0.38 * diffuse + 0.30 * front) + vec3(0.07 * shine);
    gl_FragColor = vec4(color, 1.0);
}`;

/** Counts faces in the stencil only. */
export const countFragmentShader = `
uniform vec4 cut;
varying vec3 place;
void main() {
    if (dot(place, cut.xyz) > cut.w) discard;
    gl_FragColor = vec4(1.0);
}`;
