// SPDX-License-Identifier: GPL-3.0-or-later
// The stage with what lies over it (marks, scale bar, colour bar) and its controls.
import { capital, shown, ticks, withUnit } from "./numbers.mjs";
import { gradient, regionTable } from "./colors.mjs";
import { markOf, plainLabels, scaleBar, views } from "./anatomy.mjs";
import { choice, element, field } from "./elements.mjs";
import { Player } from "./player.mjs";
import { Stage } from "./stage.mjs";

const axisNames = ["x: left to right", "y: back to front", "z: bottom to top"];
const plainAxisNames = ["x", "y", "z"];
const defaultScalar = "sulcal_depth";

/** Output times of all bodies, each once. */
export function allFrames(bodies) {
    const frames = bodies.flatMap((body) => body.frames.map(({ t, week }) => ({ t, week }))).sort((a, b) => a.t - b.t);
    return frames.filter((frame, k) => k === 0 || frame.t - frames[k - 1].t > 1e-9);
}

/** From the least to the largest of the bodies' ranges of a scalar. */
export function commonRange(bodies, key, which) {
    const ranges = bodies.map((body) => body.content.ranges[key]?.[which]).filter(Boolean);
    return [Math.min(...ranges.map((range) => range[0])), Math.max(...ranges.map((range) => range[1]))];
}

/** A scalar above and below 0 gets a range with 0 in its middle. */
export function symmetric([low, high]) {
    const size = Math.max(Math.abs(low), Math.abs(high));
    return [-size, size];
}

/** The bodies of a page, to be looked at. */
export class Viewer {
    constructor(content, bodies, { captions = null, onName = null } = {}) {
        this.content = content;
        this.bodies = bodies;
        this.isBrain = bodies.every((body) => body.isBrain);
        this.keys = bodies[0].scalarKeys.filter((key) => bodies.every((body) => body.scalarKeys.includes(key)));
        const order = Object.keys(content.scalars);
        this.keys.sort((a, b) => (order.indexOf(a) + 1 || 99) - (order.indexOf(b) + 1 || 99));
        this.key = this.keys.includes(defaultScalar) ? defaultScalar : this.keys[0];
        this.rule = "robust";
        this.captions = captions;
        this.onName = onName;
        this.listeners = [];
        this.makeStage();
        this.makeControls();
    }

    scalar(key = this.key) {
        return this.content.scalars[key] || { label: key.replaceAll("_", " "), unit: "", sentence: "", map: "viridis" };
    }

    makeStage() {
        this.canvas = element("canvas", { tabindex: 0, role: "img", "aria-label": "Surface; arrow keys change the time" });
        this.marks = ["top", "bottom", "left", "right"].map((place) => element("span", { class: `mark-${place} mark-side` }));
        this.bar = element("div", { class: "scale-bar" }, element("i"), element("span"));
        this.colorBar = element("div", { class: "color-bar" });
        this.names = element("div", { class: "pane-names" });
        this.frame = element("div", { class: this.captions ? "stage captioned" : "stage" }, this.canvas, this.marks, this.bar, this.colorBar, this.names);
        this.player = new Player(allFrames(this.bodies), (t, place) => this.setTime(t, place));
        this.still = element("div", { class: "still" }); // what is printed: the page's own box has other sides on paper
        this.element = element("div", { class: "viewer" }, this.frame, this.still, this.player.bar);
    }

    makeControls() {
        const labels = this.isBrain ? (name) => views[name].label : (name) => plainLabels[name];
        this.buttons = Object.keys(views).map((name) => element("button", { type: "button", "data-view": name,
            onclick: () => this.setView(name) }, labels(name)));
        this.mapChoice = choice([], "", (map) => this.setMap(map), { "aria-label": "Colour map" });
        this.low = element("input", { type: "number", step: "any", "aria-label": "Lower end of the colours", onchange: () => this.setOwnRange() });
        this.high = element("input", { type: "number", step: "any", "aria-label": "Upper end of the colours", onchange: () => this.setOwnRange() });
        this.ruleChoice = choice([["robust", "most values"], ["full", "least to largest"], ["own", "as entered"]], this.rule,
            (rule) => this.setRule(rule));
        this.scalarChoice = choice(this.keys.map((key) => [key, capital(this.scalar(key).label)]), this.key, (key) => this.setScalar(key));
        this.sentence = element("p", { class: "hint" });
        const axes = this.isBrain ? axisNames : plainAxisNames;
        this.axisChoice = choice([["", "none"], ...axes.map((name, axis) => [String(axis), name])], "", (axis) => this.setCutAxis(axis));
        this.offset = element("input", { type: "range", min: 0, max: 1, step: 0.002, value: 0.5, "aria-label": "Place of the cut", oninput: () => this.moveCut() });
        this.flip = element("button", { type: "button", onclick: () => this.flipCut() }, "Other half");
        this.offsetText = element("output", { class: "hint" });
        const hasBoundary = this.bodies.every((body) => body.hasBoundary);
        this.whichChoice = choice([["points", "cortex (outer)"], ["boundary", "white matter (inner)"]], "points", (which) => this.stage.update({ which }));
        this.controls = element("div", { class: "controls" },
            element("div", { class: "views", role: "group", "aria-label": "Views" }, this.buttons),
            field("Colour by", this.scalarChoice), this.sentence,
            element("div", { class: "row" }, field("Map", this.mapChoice), field("Range", this.ruleChoice)),
            element("div", { class: "row" }, field("from", this.low), field("to", this.high)),
            field("Cut", this.axisChoice),
            element("div", { class: "row cut-row" }, this.offset, this.flip), this.offsetText,
            hasBoundary ? field("Surface", this.whichChoice) : null,
            element("button", { type: "button", class: "save", onclick: () => this.savePicture() }, "Save picture"));
    }

    async start() {
        this.stage = new Stage(this.canvas, this.bodies, () => this.drawOver());
        await this.stage.start();
        this.setCutAxis("", false);
        this.setScalar(this.key, false);
        this.setView("oblique");
        await this.player.go(this.player.place);
        const observer = new ResizeObserver(() => this.stage.resize());
        observer.observe(this.frame);
        this.ending = new AbortController();
        this.ending.signal.addEventListener("abort", () => observer.disconnect());
        addEventListener("beforeprint", () => this.still.replaceChildren(this.picture()), { signal: this.ending.signal });
        this.addKeys();
    }

    /** Unpacks what is not shown yet, one after the other, so that the slider does not wait. */
    async readAhead() {
        for (const body of this.bodies) {
            for (let k = 0; k < body.frames.length; ++k) {
                await Promise.all([body.normals(k), body.values(k, this.key)]);
                await new Promise((done) => setTimeout(done, 0));
            }
        }
    }

    addKeys() {
        const actions = { ArrowLeft: () => this.player.step(-1), ArrowRight: () => this.player.step(1), " ": () => this.player.toggle(),
            Home: () => this.player.go(0), End: () => this.player.go(Infinity) };
        const names = Object.keys(views);
        document.addEventListener("keydown", (event) => {
            const isOfControl = /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName) || (event.key === " " && event.target.tagName !== "BODY" && event.target !== this.canvas);
            if (event.ctrlKey || event.metaKey || event.altKey || isOfControl) {
                return;
            }
            const action = actions[event.key] || (/^[1-9]$/.test(event.key) && names[event.key - 1] && (() => this.setView(names[event.key - 1])));
            if (action) {
                event.preventDefault();
                action();
            }
        }, { signal: this.ending.signal });
    }

    onTime(listener) {
        this.listeners.push(listener);
        listener(this.player.t);
    }

    setTime(t) {
        for (const listener of this.listeners) {
            listener(t);
        }
        return this.stage ? this.stage.update({ t }) : undefined;
    }

    setView(name) {
        for (const button of this.buttons) {
            button.setAttribute("aria-pressed", String(button.dataset.view === name));
        }
        const { cut } = views[name];
        if (cut || this.isCutOfView) {
            this.setCutAxis(cut ? String(cut.axis) : "");
            if (cut) {
                this.keep = cut.keep;
                this.moveCut();
            }
        }
        this.isCutOfView = Boolean(cut);
        this.stage.setView(name);
    }

    setScalar(key, isShown = true) {
        this.key = key;
        this.scalarChoice.value = key;
        const scalar = this.scalar();
        this.sentence.textContent = scalar.sentence ? `${capital(scalar.sentence)}.` : "";
        const maps = scalar.map === "regions" ? ["regions"] : Object.keys(this.content.maps);
        this.mapChoice.replaceChildren(...maps.map((name) => element("option", { value: name }, capital(name))));
        this.map = scalar.map;
        this.mapChoice.value = this.map;
        this.setRule(this.rule === "own" ? "robust" : this.rule);
        return isShown ? this.stage.update({ key }) : Object.assign(this.stage.state, { key });
    }

    setMap(map) {
        this.map = map;
        this.applyColors();
    }

    setRule(rule) {
        this.rule = rule;
        this.ruleChoice.value = rule;
        if (rule !== "own") {
            const range = commonRange(this.bodies, this.key, rule);
            this.range = this.scalar().map === "blue-orange" ? symmetric(range) : range;
            this.low.value = Number(this.range[0].toPrecision(6));
            this.high.value = Number(this.range[1].toPrecision(6));
        }
        this.applyColors();
    }

    setOwnRange() {
        const [low, high] = [Number(this.low.value), Number(this.high.value)];
        if (Number.isFinite(low) && Number.isFinite(high) && low !== high) {
            this.range = [low, high];
            this.setRule("own");
        }
    }

    table() {
        return this.map === "regions" ? regionTable(...this.range) : this.content.maps[this.map];
    }

    applyColors() {
        const [low, high] = this.range[0] === this.range[1] ? [this.range[0] - 0.5, this.range[1] + 0.5] : this.range;
        this.stage?.setColors(this.table(), low, high);
        const { label, unit } = this.scalar();
        const labels = ticks(Math.min(low, high), Math.max(low, high), 5).map((value) => element("span",
            { class: "tick", style: `bottom: ${(100 * (value - low)) / (high - low)}%` }, shown(value, 3)));
        this.colorBar.replaceChildren(element("div", { class: "bar-label" }, capital(withUnit(label, unit))),
            element("div", { class: "bar" }, element("i", { style: `background: ${gradient(this.table())}` }), labels));
    }

    /** @param axis  "0", "1", "2", or "" for no cut */
    setCutAxis(axis, isShown = true) {
        this.axisChoice.value = axis;
        this.offset.disabled = this.flip.disabled = axis === "";
        this.keep = this.keep || -1;
        if (axis === "") {
            this.offsetText.textContent = "";
            return isShown ? this.stage.update({ cut: null }) : undefined;
        }
        this.offset.value = 0.5;
        if (!this.isCutOfView) { // the section looks to the viewer
            this.keep = this.stage.camera.position.getComponent(Number(axis)) > 0 ? -1 : 1;
        }
        return this.moveCut();
    }

    moveCut() {
        const axis = Number(this.axisChoice.value);
        const { low, high } = this.stage.panes[0];
        const offset = low[axis] + Number(this.offset.value) * (high[axis] - low[axis]);
        const tissues = [this.bodies.some((body) => body.hasBoundary) ? "cortex red, white matter pale" : "",
            this.bodies.every((body) => body.hasBoundary) ? "" : "grey where tissues are not known"].filter(Boolean).join(", ");
        this.offsetText.textContent = `${"xyz"[axis]} = ${shown(Number(offset.toPrecision(3)), 3)} mm; section: ${tissues}`;
        return this.stage.update({ cut: { axis, offset, keep: this.keep } });
    }

    flipCut() {
        this.keep = -this.keep;
        return this.moveCut();
    }

    /** Marks, scale bar and names follow the camera. */
    drawOver() {
        const { right, up } = this.stage.directions();
        const negative = (v) => v.map((value) => -value);
        const directions = [up, negative(up), negative(right), right];
        this.sides = directions.map((direction) => markOf(direction, this.isBrain));
        this.marks.forEach((mark, k) => { mark.textContent = this.sides[k]; });
        this.scale = scaleBar(this.stage.pixelsPerMm());
        this.bar.firstChild.style.width = `${this.scale.pixels}px`;
        this.bar.lastChild.textContent = `${shown(this.scale.length)} mm`;
        this.captions?.forEach((caption, k) => {
            const name = this.names.children[k] || this.names.appendChild(element(this.onName ? "button" : "span",
                { type: this.onName ? "button" : undefined, onclick: () => this.onName?.(k) }, caption));
            const box = this.stage.rectangle(k);
            Object.assign(name.style, { left: `${box.x + 8}px`, top: `${box.y + 6}px`, maxWidth: `${box.width - 16}px`, display: box.width ? "" : "none" });
            name.classList.toggle("selected", k === this.highlighted);
        });
    }

    /** Shows one pane alone, or all again when it is alone already. */
    focus(k) {
        this.stage.alone = this.stage.alone === k ? null : k;
        this.stage.resize();
    }

    highlight(k) {
        this.highlighted = k;
        this.stage?.draw();
    }

    /** Gives the graphics memory back; the viewer is not used any more. */
    dispose() {
        this.player.stop();
        this.ending?.abort();
        this.stage?.dispose();
    }

    /** The picture as it stands, with marks, scale bar and colour bar, as a PNG. */
    async savePicture() {
        const picture = this.picture();
        const blob = await new Promise((done) => picture.toBlob(done, "image/png"));
        const link = element("a", { href: URL.createObjectURL(blob), download: `${this.content.title}-${this.key}.png` });
        link.click();
        URL.revokeObjectURL(link.href);
    }

    picture() {
        this.stage.paint();
        const ratio = this.canvas.width / this.stage.width;
        const picture = element("canvas", { width: this.canvas.width, height: this.canvas.height });
        const draw = picture.getContext("2d");
        draw.drawImage(this.canvas, 0, 0);
        draw.scale(ratio, ratio);
        const { width, height } = this.stage;
        draw.fillStyle = "#1d2733";
        draw.textAlign = "center";
        draw.textBaseline = "middle";
        draw.font = "600 15px sans-serif";
        [[width / 2, this.captions ? 42 : 18], [width / 2, height - 18], [18, height / 2], [width - 110, height / 2]].forEach(([x, y], k) => draw.fillText(this.sides[k], x, y));
        draw.font = "13px sans-serif";
        draw.fillRect(20, height - 24, this.scale.pixels, 3);
        draw.fillText(`${shown(this.scale.length)} mm`, 20 + this.scale.pixels / 2, height - 36);
        const table = this.table(), top = height / 2 - 90;
        table.forEach((color, k) => {
            draw.fillStyle = `rgb(${color.join(",")})`;
            draw.fillRect(width - 70, top + 180 * (1 - (k + 1) / table.length), 14, 180 / table.length + 1);
        });
        draw.fillStyle = "#1d2733";
        draw.textAlign = "left";
        for (const value of ticks(...this.range, 5)) {
            draw.fillText(shown(value, 3), width - 50, top + 180 * (1 - (value - this.range[0]) / (this.range[1] - this.range[0])));
        }
        draw.textAlign = "right";
        draw.fillText(capital(withUnit(this.scalar().label, this.scalar().unit)), width - 12, top - 16);
        draw.textAlign = "left";
        this.drawNames(draw);
        return picture;
    }

    /** Names of the panes, or the time of the only one. */
    drawNames(draw) {
        draw.textBaseline = "top";
        draw.font = "600 13px sans-serif";
        (this.captions || [this.player.text.textContent]).forEach((name, k) => {
            const box = this.stage.rectangle(k);
            if (box.width) {
                draw.fillText(name, box.x + (this.captions ? 8 : 20), box.y + (this.captions ? 6 : 14), box.width - 16);
            }
        });
    }
}
