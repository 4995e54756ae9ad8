// SPDX-License-Identifier: GPL-3.0-or-later
// Elements of the page. Text goes in as text, never as HTML.

/** An element with attributes, listeners (on...) and children (elements or text). */
export function element(name, attributes = {}, ...children) {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) {
        if (key.startsWith("on")) {
            made.addEventListener(key.slice(2), value);
        } else if (value === true) {
            made.setAttribute(key, "");
        } else if (value !== false && value !== undefined && value !== null) {
            made.setAttribute(key, value);
        }
    }
    made.append(...children.flat().filter((child) => child !== null && child !== undefined));
    return made;
}

/** A labelled control. */
export function field(label, control) {
    return element("label", { class: "field" }, element("span", {}, label), control);
}

/** A list to choose from: options are [value, text]. */
export function choice(options, chosen, onChoice, attributes = {}) {
    return element("select", { ...attributes, onchange: (event) => onChoice(event.target.value) },
        options.map(([value, text]) => element("option", { value, selected: value === chosen }, text)));
}

/** A table with a head. */
export function table(head, rows, attributes = {}) {
    const cell = (name) => (content) => element(name, { class: typeof content === "number" ? "number" : undefined }, content);
    return element("table", attributes, element("thead", {}, element("tr", {}, head.map(cell("th")))),
        element("tbody", {}, rows.map((row) => element("tr", {}, row.map(cell("td"))))));
}

/** Text with a button that copies it. */
export function copyable(paragraphs) {
    const body = element("div", { class: "copyable" }, paragraphs.map((text) => element("p", {}, text)));
    const button = element("button", { type: "button", class: "copy" }, "Copy text");
    button.addEventListener("click", async () => {
        try {
            await navigator.clipboard.writeText(paragraphs.join("\n\n"));
            button.textContent = "Copied";
        } catch {
            getSelection().selectAllChildren(body);
            button.textContent = "Selected: press Ctrl+C";
        }
        setTimeout(() => { button.textContent = "Copy text"; }, 2500);
    });
    return element("div", {}, button, body);
}

/** Names of curves with their colours. */
export function legend(labels) {
    return element("div", { class: "legend" }, labels.map((label, k) => element("span", {}, element("i", { class: `swatch line-${k}` }), label)));
}

/** A section with a heading. */
export function section(title, ...children) {
    return element("section", { class: "card" }, element("h2", {}, title), ...children);
}
