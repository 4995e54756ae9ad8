// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a run.
import { Body } from "./body.mjs";
import { element } from "./elements.mjs";
import { grouped } from "./numbers.mjs";
import { Picker } from "./pick.mjs";
import { caseSection, methodsSection, timingSection, warningsSection } from "./facts.mjs";
import { energyPlot, headline, measuresSection } from "./measures.mjs";
import { Viewer } from "./viewer.mjs";
import { reasonForNoWebGL } from "./stage.mjs";

/** The pictures in place of the viewer, and why. */
export function withoutViewer(pictures, reason) {
    return element("section", { class: "card" }, element("p", { class: "warning-line" }, `The surface cannot be turned here: ${reason}. The pictures and plots below do not need it.`),
        element("div", { class: "stills" }, pictures.map((picture) => element("figure", {}, element("img", { src: picture.source, alt: `${picture.caption} at the end of the run` }),
            element("figcaption", {}, picture.caption)))));
}

/** A viewer where the browser can draw one: {viewer, parts}. Without one, times are listened to by nobody. */
export function viewerOrPictures(content, bodies, options) {
    const reason = reasonForNoWebGL();
    if (!reason) {
        const viewer = new Viewer(content, bodies, options);
        return { viewer, lead: [viewer.element] };
    }
    const silent = { onTime: (listener) => listener(bodies[0].times.at(-1)), player: { goTo: () => {} } };
    return { viewer: silent, lead: [withoutViewer(content.pictures || [], reason)] };
}

export async function showRun(content, main) {
    const bodies = content.bodies.map((body) => new Body(body));
    const { viewer, lead } = viewerOrPictures(content, bodies, {});
    const isDrawn = viewer instanceof Viewer;
    const picker = isDrawn ? new Picker(viewer) : null;
    const facts = content.facts;
    const particles = facts.timing.find((entry) => entry.key === "particles")?.value;
    document.querySelector("#lead").textContent = [facts.status, particles ? `${grouped(particles)} particles` : "",
        `${bodies[0].frames.length} output times`, `${grouped(bodies[0].content.vertices)} vertices`].filter(Boolean).join(" · ");
    main.append(
        headline(viewer, content.measures),
        element("div", { class: isDrawn ? "look" : "" }, lead, isDrawn ? element("aside", { class: "side" }, viewer.controls, picker.panel) : null),
        ...[warningsSection(facts, content.notes), measuresSection(viewer, content.measures), energyPlot(viewer, content.measures),
            methodsSection(facts), caseSection(facts), timingSection(facts)].filter(Boolean));
    if (isDrawn) {
        await viewer.start();
    }
    return { viewer, picker, bodies };
}
