// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies drawn with three.js (the global THREE), one pane each, all seen by one camera.
import { paletteBytes } from "./colors.mjs";
import { firstHit, mixed, orientation } from "./geometry.mjs";
import { placeInTimes } from "./body.mjs";
import { views } from "./anatomy.mjs";
import { countFragmentShader, surfaceFragmentShader, surfaceVertexShader } from "./shaders.mjs";

const cortexColor = "#c4604f";
const whiteColor = "#e9e6df";
const unknownColor = "#b4b4b4";
const nothingCut = [0, 0, 0, 1];
const missingValue = 1e30;
const roomForBar = 112; // right of several panes
const narrow = 500; // pixels
const fine = 2; // pixels of the picture for one of the page, each way: edges come out smooth
const coarse = 1;
const restMs = 200; // without a change, until a coarse picture is drawn finely

/** Why a browser cannot draw; empty where it can. */
export function reasonForNoWebGL() {
    try {
        const context = document.createElement("canvas").getContext("webgl", { stencil: true });
        return context ? "" : "this browser has WebGL switched off, or no graphics driver for it";
    } catch (error) {
        return error.message;
    }
}

/** Whether the processor draws, for want of a graphics card: its time goes with the number of pixels. */
function isSoftware(context) {
    const info = context.getExtension("WEBGL_debug_renderer_info");
    const name = context.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : context.RENDERER);
    return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

function countMaterial(uniforms, side, operation) {
    return new THREE.ShaderMaterial({
        uniforms, vertexShader: surfaceVertexShader, fragmentShader: countFragmentShader, side,
        depthTest: false, depthWrite: false, colorWrite: false, stencilWrite: true, stencilFunc: THREE.AlwaysStencilFunc,
        stencilFail: operation, stencilZFail: operation, stencilZPass: operation,
    });
}

/** Faces that the cut opens: their back faces count up and their front faces down, so that inside is not 0. */
class Section {
    constructor(scene, geometry, uniforms, color, order) {
        const counted = [[THREE.BackSide, THREE.IncrementWrapStencilOp], [THREE.FrontSide, THREE.DecrementWrapStencilOp]];
        this.parts = counted.map(([side, operation]) => {
            const mesh = new THREE.Mesh(geometry, countMaterial(uniforms, side, operation));
            mesh.renderOrder = order;
            return mesh;
        });
        this.cap = new THREE.Mesh(new THREE.PlaneBufferGeometry(1, 1), new THREE.MeshBasicMaterial({
            color, side: THREE.DoubleSide, stencilWrite: true, stencilRef: 0, stencilFunc: THREE.NotEqualStencilFunc,
            stencilFail: THREE.ZeroStencilOp, stencilZFail: THREE.ZeroStencilOp, stencilZPass: THREE.ZeroStencilOp,
        }));
        this.cap.renderOrder = order + 0.5;
        this.parts.push(this.cap);
        for (const part of this.parts) {
            part.frustumCulled = false;
            scene.add(part);
        }
    }

    show(cut, middle, size) {
        for (const part of this.parts) {
            part.visible = cut !== null;
        }
        if (cut) {
            const normal = new THREE.Vector3().setComponent(cut.axis, 1);
            this.cap.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), normal);
            this.cap.position.fromArray(middle).setComponent(cut.axis, cut.offset);
            this.cap.scale.set(4 * size, 4 * size, 1);
        }
    }
}

/** The number of columns that leaves each of `count` panes the most room. */
export function roomiestColumns(count, width, height) {
    const room = (columns) => Math.min(width / columns, height / Math.ceil(count / columns));
    const choices = Array.from({ length: count }, (_, k) => k + 1);
    return choices.reduce((best, columns) => (room(columns) > room(best) ? columns : best));
}

/** A body in its pane. */
export class Pane {
    constructor(body, shared) {
        this.body = body;
        this.shared = shared;
        this.scene = new THREE.Scene();
        this.group = new THREE.Group();
        this.scene.add(this.group);
        this.geometries = { points: new THREE.BufferGeometry(), boundary: new THREE.BufferGeometry() };
        this.uniforms = { blend: { value: 0 }, cut: { value: new THREE.Vector4(...nothingCut) }, palette: shared.palette,
            range: shared.range };
        this.attributes = new WeakMap();
        const shaders = { uniforms: this.uniforms, vertexShader: surfaceVertexShader, fragmentShader: surfaceFragmentShader };
        this.whole = new THREE.ShaderMaterial(shaders);
        this.open = new THREE.ShaderMaterial({ ...shaders, side: THREE.DoubleSide, defines: { CUT: "" } });
        this.surface = new THREE.Mesh(this.geometries.points, this.open);
        this.surface.renderOrder = 5;
        this.surface.frustumCulled = false;
        this.group.add(this.surface);
        this.sections = { points: new Section(this.group, this.geometries.points, this.uniforms, body.hasBoundary ? cortexColor : unknownColor, 1) };
        if (body.hasBoundary) {
            this.sections.boundary = new Section(this.group, this.geometries.boundary, this.uniforms, whiteColor, 3);
        }
        this.marker = new THREE.Mesh(new THREE.SphereBufferGeometry(1, 20, 14),
            new THREE.MeshBasicMaterial({ color: "#d81b60", depthTest: false, transparent: true }));
        this.marker.renderOrder = 9;
        this.marker.visible = false;
        this.group.add(this.marker);
        this.place = { a: 0, b: 0, blend: 0 };
        this.picked = -1;
    }

    async start() {
        const triangles = await this.body.triangles();
        const index = new THREE.BufferAttribute(triangles, 1);
        this.geometries.points.setIndex(index);
        this.geometries.boundary.setIndex(index);
        const { low, high } = await this.body.bounds();
        this.orientation = orientation(await this.body.points(this.body.frames.length - 1), triangles);
        this.whole.side = [THREE.BackSide, THREE.DoubleSide, THREE.FrontSide][this.orientation + 1];
        this.middle = low.map((value, c) => 0.5 * (value + high[c]));
        this.low = low;
        this.high = high;
        this.radius = 0.5 * Math.hypot(...high.map((value, c) => value - low[c]));
        this.group.position.set(...this.middle.map((value) => -value));
    }

    attribute(values, size) {
        if (!this.attributes.has(values)) {
            const shown = size > 1 ? values : values.map((value) => (Number.isNaN(value) ? missingValue : value));
            this.attributes.set(values, new THREE.BufferAttribute(shown, size));
        }
        return this.attributes.get(values);
    }

    /** Shows the body at growth time t. */
    async show(t, key, which, cut) {
        const { a, b, blend } = placeInTimes(this.body.times, t);
        const surface = which === "boundary" && this.body.hasBoundary ? "boundary" : "points";
        const needed = [surface, ...(cut ? ["points"] : []), ...(cut && this.body.hasBoundary ? ["boundary"] : [])];
        const values = await Promise.all([this.body.values(a, key), this.body.values(b, key)]);
        for (const name of new Set(needed)) {
            const [p, q, n, m] = await Promise.all([this.body.points(a, name), this.body.points(b, name),
                this.body.normals(a, name), this.body.normals(b, name)]);
            const entries = { position: [p, 3], positionNext: [q, 3], normal: [n, 3], normalNext: [m, 3],
                value: [values[0], 1], valueNext: [values[1], 1] };
            for (const [attribute, [array, size]] of Object.entries(entries)) {
                this.geometries[name].setAttribute(attribute, this.attribute(array, size));
            }
        }
        this.place = { a, b, blend };
        this.uniforms.blend.value = blend;
        this.surface.geometry = this.geometries[surface];
        // The far side of a whole closed surface is hidden: not to draw it halves the work.
        this.surface.material = surface === "points" && !cut ? this.whole : this.open;
        this.points = [await this.body.points(a, surface), await this.body.points(b, surface)];
        this.setCut(cut);
        this.placeMarker();
    }

    setCut(cut) {
        this.cut = cut;
        const plane = cut ? [0, 1, 2].map((axis) => (axis === cut.axis ? -cut.keep : 0)).concat(-cut.keep * cut.offset) : nothingCut;
        this.uniforms.cut.value.set(...plane);
        for (const section of Object.values(this.sections)) {
            section.show(cut, this.middle, this.radius);
        }
    }

    placeMarker() {
        this.marker.visible = this.picked >= 0;
        if (this.marker.visible) {
            const [p, q] = this.points;
            this.marker.position.set(...[0, 1, 2].map((c) => {
                const from = p[3 * this.picked + c];
                return from + this.place.blend * (q[3 * this.picked + c] - from);
            }));
            this.marker.scale.setScalar(0.014 * this.radius);
        }
    }

    /** The vertex that a ray (in the scene) meets first; -1 where it meets none, or the section: its first face is seen from inside. */
    async pick(origin, direction) {
        const triangles = await this.body.triangles();
        const points = mixed(this.points[0], this.points[1], this.place.blend);
        const from = origin.map((value, c) => value + this.middle[c]);
        const cut = this.cut;
        const isShown = (...point) => !cut || cut.keep * (point[cut.axis] - cut.offset) >= 0;
        const hit = firstHit(points, triangles, from, direction, isShown);
        const isSection = hit && this.orientation !== 0 && hit.isFront !== this.orientation > 0;
        return hit && !isSection ? triangles[3 * hit.triangle + hit.weights.indexOf(Math.max(...hit.weights))] : -1;
    }
}

/** The canvas with its panes, camera and colours. */
export class Stage {
    constructor(canvas, bodies, onDraw) {
        this.canvas = canvas;
        this.onDraw = onDraw;
        this.renderer = new THREE.WebGLRenderer({ canvas, stencil: true, preserveDrawingBuffer: true });
        this.movingRatio = isSoftware(this.renderer.getContext()) ? coarse : fine;
        this.renderer.setClearColor(0xffffff, 1);
        this.renderer.clear();
        this.shared = { palette: { value: null }, range: { value: new THREE.Vector2(0, 1) } };
        this.panes = bodies.map((body) => new Pane(body, this.shared));
        this.camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 10);
        this.camera.up.set(0, 0, 1);
        this.controls = new THREE.OrbitControls(this.camera, canvas);
        this.controls.enableKeys = false;
        this.controls.rotateSpeed = 0.8;
        this.controls.addEventListener("change", () => this.draw());
        this.state = { t: 0, key: "", which: "points", cut: null };
        this.alone = null;
        this.turn = Promise.resolve();
    }

    async start() {
        await Promise.all(this.panes.map((pane) => pane.start()));
        this.radius = Math.max(...this.panes.map((pane) => pane.radius));
        this.camera.near = 0.1 * this.radius;
        this.camera.far = 20 * this.radius;
        this.setView("oblique");
    }

    /** Changes what is shown: any of t, key, which, cut. Changes are shown one after the other; of several that wait, the last. */
    update(changes) {
        Object.assign(this.state, changes);
        const wanted = ++this.wanted || (this.wanted = 1);
        this.turn = this.turn.then(async () => {
            if (wanted === this.wanted) {
                const { t, key, which, cut } = this.state;
                await Promise.all(this.panes.map((pane) => pane.show(t, key, which, cut)));
                this.render();
            }
        });
        return this.turn;
    }

    setColors(table, low, high) {
        const texture = new THREE.DataTexture(paletteBytes(table), 256, 1, THREE.RGBAFormat);
        texture.magFilter = texture.minFilter = THREE.NearestFilter;
        texture.needsUpdate = true;
        this.shared.palette.value = texture;
        this.shared.range.value.set(low, high);
        this.draw();
    }

    /** Looks from a direction; all panes fit. */
    setView(name) {
        const from = new THREE.Vector3(...views[name].from).normalize();
        this.controls.target.set(0, 0, 0);
        this.camera.position.copy(from.multiplyScalar(6 * this.radius));
        this.camera.zoom = 1;
        this.resize();
        this.controls.update();
        this.draw();
    }

    /** Where pane number k lies: {x, y, width, height} in CSS pixels from the top left. */
    rectangle(k) {
        if (this.alone !== null) {
            return k === this.alone ? { x: 0, y: 0, width: this.width, height: this.height } : { x: 0, y: 0, width: 0, height: 0 };
        }
        const bar = this.panes.length > 1 ? roomForBar : 0;
        const isNarrow = this.width < narrow; // a phone: the bar lies below
        const roomWide = Math.max(this.width - (isNarrow ? 0 : bar), 1), roomHigh = Math.max(this.height - (isNarrow ? bar : 0), 1);
        const columns = roomiestColumns(this.panes.length, roomWide, roomHigh);
        const width = roomWide / columns, height = roomHigh / Math.ceil(this.panes.length / columns);
        return { x: (k % columns) * width, y: Math.floor(k / columns) * height, width, height };
    }

    resize() {
        const box = this.canvas.parentElement.getBoundingClientRect();
        this.width = Math.max(Math.round(box.width), 50);
        this.height = Math.max(Math.round(box.height), 50);
        const { width, height } = this.rectangle(this.alone ?? 0);
        const half = (this.panes.length > 1 ? 0.82 : 0.74) * this.radius * Math.max(1, height / width);
        Object.assign(this.camera, { top: half, bottom: -half, left: (-half * width) / height, right: (half * width) / height });
        this.camera.updateProjectionMatrix();
        this.draw();
    }

    pixelsPerMm() {
        return (this.rectangle(this.alone ?? 0).height * this.camera.zoom) / (this.camera.top - this.camera.bottom);
    }

    /** Directions of the screen in the body: {right, up}. */
    directions() {
        this.camera.updateMatrixWorld();
        const e = this.camera.matrixWorld.elements;
        return { right: [e[0], e[1], e[2]], up: [e[4], e[5], e[6]] };
    }

    draw() {
        if (!this.isWaiting) {
            this.isWaiting = true;
            requestAnimationFrame(() => {
                this.isWaiting = false;
                this.render();
            });
        }
    }

    /** Draws what is there now: where the processor has to do it, coarsely, and finely once nothing changes. */
    render() {
        const isSlow = this.movingRatio < fine && this.state.cut; // a section is drawn in six passes
        this.paint(isSlow ? 0.5 * this.movingRatio : this.movingRatio);
        clearTimeout(this.rest);
        if (this.movingRatio < fine) {
            this.rest = setTimeout(() => this.paint(fine), restMs);
        }
    }

    paint(ratio = fine) {
        if (this.renderer.getPixelRatio() !== ratio || this.painted !== `${this.width} ${this.height}`) {
            this.painted = `${this.width} ${this.height}`;
            this.renderer.setPixelRatio(ratio);
            this.renderer.setSize(this.width, this.height, false);
        }
        this.renderer.setScissorTest(false);
        this.renderer.clear();
        if (!this.panes.every((pane) => pane.points)) {
            return;
        }
        this.renderer.setScissorTest(true);
        this.panes.forEach((pane, k) => {
            const { x, y, width, height } = this.rectangle(k);
            if (width === 0) {
                return;
            }
            this.renderer.setViewport(x, this.height - y - height, width, height);
            this.renderer.setScissor(x, this.height - y - height, width, height);
            this.renderer.render(pane.scene, this.camera);
        });
        this.onDraw?.(this);
    }

    dispose() {
        clearTimeout(this.rest);
        this.renderer.forceContextLoss();
        this.renderer.dispose();
    }

    /** What lies under a place of the canvas (CSS pixels): {pane, vertex}, or null. */
    async pick(x, y) {
        for (const [k, pane] of this.panes.entries()) {
            const box = this.rectangle(k);
            if (x >= box.x && x < box.x + box.width && y >= box.y && y < box.y + box.height) {
                const place = new THREE.Vector2((2 * (x - box.x)) / box.width - 1, 1 - (2 * (y - box.y)) / box.height);
                const caster = new THREE.Raycaster();
                caster.setFromCamera(place, this.camera);
                const vertex = await pane.pick(caster.ray.origin.toArray(), caster.ray.direction.toArray());
                return vertex < 0 ? null : { pane, vertex };
            }
        }
        return null;
    }
}
