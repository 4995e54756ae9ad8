// SPDX-License-Identifier: GPL-3.0-or-later
// The time of the page: output times, where it stands, playing.
import { element } from "./elements.mjs";
import { shown } from "./numbers.mjs";

const secondsPerFrame = 0.55;

/** "t = 0.5, week 30.2", at a place between output times too. */
export function timeText(frames, place) {
    const k = Math.floor(place), share = place - k;
    const next = frames[Math.min(k + 1, frames.length - 1)];
    const between = (key) => frames[k][key] + share * (next[key] - frames[k][key]);
    const week = frames[k].week === null ? "" : `week ${shown(between("week"), 3)}, `;
    return `${week}t = ${shown(between("t"), 3)}`;
}

/** Follows the time of a viewer while an element is on the screen: fifty plots that nobody sees cost nothing. */
export function whenSeen(seen, viewer, follow) {
    let isSeen = false, last = null;
    addEventListener("beforeprint", () => follow(last));
    const observer = new IntersectionObserver((entries) => {
        isSeen = entries.at(-1).isIntersecting;
        if (isSeen) {
            follow(last);
        }
    });
    observer.observe(seen);
    viewer.onTime((t) => {
        last = t;
        if (isSeen) {
            follow(t);
        }
    });
}

/** Output times with a slider; onTime(t, place) is called when the time changes. */
export class Player {
    /** @param frames  [{t, week}], t ascends */
    constructor(frames, onTime) {
        this.frames = frames;
        this.place = frames.length - 1;
        this.onTime = onTime;
        this.slider = element("input", { type: "range", min: 0, max: frames.length - 1, step: 1, value: this.place,
            "aria-label": "Time", class: "slider", oninput: () => { this.stop(); this.go(Number(this.slider.value)); } });
        this.button = element("button", { type: "button", class: "play", "aria-label": "Play", onclick: () => this.toggle() }, "▶");
        this.text = element("output", { class: "time" });
        const ends = element("div", { class: "ends", "aria-hidden": "true" },
            element("span", {}, timeText(frames, 0)), element("span", {}, timeText(frames, frames.length - 1)));
        this.bar = element("div", { class: "player" }, this.button,
            element("div", { class: "track" }, this.slider, ends), this.text);
        this.bar.hidden = frames.length < 2;
        this.say();
    }

    get t() {
        const k = Math.floor(this.place);
        const next = this.frames[Math.min(k + 1, this.frames.length - 1)];
        return this.frames[k].t + (this.place - k) * (next.t - this.frames[k].t);
    }

    say() {
        this.slider.value = Math.round(this.place);
        this.text.textContent = timeText(this.frames, this.place);
        this.slider.setAttribute("aria-valuetext", this.text.textContent);
    }

    /** To a place between 0 and the last output time. */
    go(place) {
        this.place = Math.min(Math.max(place, 0), this.frames.length - 1);
        this.say();
        return this.onTime(this.t, this.place);
    }

    /** To the output time nearest to t. */
    goTo(t) {
        const distances = this.frames.map((frame) => Math.abs(frame.t - t));
        this.stop();
        return this.go(distances.indexOf(Math.min(...distances)));
    }

    step(by) {
        this.stop();
        return this.go(by > 0 ? Math.floor(this.place + 1e-6) + by : Math.ceil(this.place - 1e-6) + by);
    }

    toggle() {
        return this.isPlaying ? this.stop() : this.play();
    }

    stop() {
        this.isPlaying = false;
        this.button.textContent = "▶";
        this.button.setAttribute("aria-label", "Play");
    }

    async play() {
        this.isPlaying = true;
        this.button.textContent = "❚❚";
        this.button.setAttribute("aria-label", "Pause");
        if (this.place >= this.frames.length - 1) {
            this.place = 0;
        }
        let before = performance.now();
        while (this.isPlaying && this.place < this.frames.length - 1) {
            await this.go(this.place);
            const now = await new Promise(requestAnimationFrame);
            this.place += Math.min(Math.max((now - before) / 1000, 0), 0.2) / secondsPerFrame;
            before = now;
        }
        await this.go(this.isPlaying ? this.place : Math.round(this.place));
        this.stop();
    }
}
