// SPDX-License-Identifier: GPL-3.0-or-later
// What a page tells in words: warnings, methods, case, timing, versions.
import { capital, shown } from "./numbers.mjs";
import { copyable, element, section, table } from "./elements.mjs";

const units = { wall_s: "s", internal_forces_s: "s", contact_s: "s", measures_s: "s", output_s: "s", peak_memory_mb: "MB", us_per_particle_step: "µs" };
const names = { internal_forces_s: "forces of the tissue", contact_s: "contact", measures_s: "measures", output_s: "output", wall_s: "wall time, all",
    us_per_particle_step: "time for a particle and step", peak_memory_mb: "peak memory", rejected_steps: "rejected steps" };

export function warningsSection(facts, notes) {
    const lines = [...(facts.reason ? [`The run did not complete: ${facts.reason}`] : []), ...facts.warnings, ...notes];
    if (lines.length === 0) {
        return null;
    }
    return element("section", { class: "card warnings" }, element("h2", {}, facts.warnings.length ? "Warnings" : "Notes"),
        element("ul", {}, lines.map((line) => element("li", {}, line))));
}

export function methodsSection(facts) {
    if (!facts.methods) {
        return null;
    }
    const references = facts.methods.references.map((work, k) => `[${k + 1}] ${work}`);
    return section("Methods, ready to copy", copyable([...facts.methods.paragraphs, ...references]));
}

export function caseSection(facts) {
    const groups = new Map();
    for (const row of facts.case) {
        groups.set(row.section, [...(groups.get(row.section) || []), row]);
    }
    const tables = [...groups].map(([name, rows]) => element("details", { open: rows.some((row) => row.changed) },
        element("summary", {}, `[${name}]`),
        element("table", { class: "case" }, element("tbody", {}, rows.map((row) => element("tr", { class: row.changed ? "changed" : undefined },
            element("td", {}, element("code", {}, row.key)), element("td", {}, element("code", {}, row.value || "not given"), row.unit ? ` ${row.unit}` : ""),
            element("td", { class: "hint" }, row.sentence)))))));
    const inputs = facts.inputs.length ? [element("h3", {}, "Input files"), element("div", { class: "scroll" }, table(["key", "file", "SHA-256"],
        facts.inputs.map((input) => [input.key, input.file, element("code", { class: "hash" }, input.sha256)])))] : [];
    return section("Case", element("p", { class: "hint" }, "Every key with its value; those that differ from the default stand out."), tables, inputs);
}

export function timingSection(facts) {
    const rows = facts.timing.map(({ key, label, value }) => [capital(names[key] || label), shown(value) + (units[key] ? ` ${units[key]}` : "")]);
    const parts = ["internal_forces_s", "contact_s", "measures_s", "output_s"].map((key) => facts.timing.find((entry) => entry.key === key)).filter(Boolean);
    const sum = parts.reduce((total, part) => total + part.value, 0) || 1;
    const bar = element("div", { class: "share-bar", role: "img", "aria-label": parts.map((part) => `${names[part.key]} ${Math.round((100 * part.value) / sum)} %`).join(", ") },
        parts.map((part, k) => element("i", { class: `fill-${k}`, style: `flex: ${part.value}`, title: `${names[part.key]}: ${shown(part.value, 3)} s` })));
    const keys = element("div", { class: "legend" }, parts.map((part, k) => element("span", {}, element("i", { class: `swatch fill-${k}` }), `${names[part.key]} ${Math.round((100 * part.value) / sum)} %`)));
    return section("Timing and version", bar, keys, table(["", ""], rows, { class: "values" }),
        element("p", {}, `Corticle ${facts.version}`, facts.versions && facts.versions !== facts.version ? `; earlier parts of the run: ${facts.versions}` : ""));
}
