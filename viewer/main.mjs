// SPDX-License-Identifier: GPL-3.0-or-later
// Starts the page. `corticleReport` is what tests and consoles find.
import { showComparison } from "./comparison.mjs";
import { showSweep } from "./sweep.mjs";
import { showRun } from "./run.mjs";

const pages = { run: showRun, comparison: showComparison, sweep: showSweep };

async function start() {
    const began = performance.now();
    const content = JSON.parse(document.querySelector("#content").textContent);
    const main = document.querySelector("main");
    const shownParts = await pages[content.kind](content, main);
    document.documentElement.dataset.ready = "true";
    Object.assign(window.corticleReport, shownParts, { content, milliseconds: performance.now() - began, sincePageStart: performance.now() });
    await shownParts.viewer.readAhead?.();
    document.documentElement.dataset.complete = "true";
}

if (typeof document !== "undefined") {
    window.corticleReport = {};
    start().catch((error) => {
        document.querySelector("main").append(Object.assign(document.createElement("p"), { className: "warning-line", textContent: `The page could not be shown: ${error.message}` }));
        console.error(error);
    });
}
