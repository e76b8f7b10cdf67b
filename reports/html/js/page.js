"use strict";
// Elements of the page. Text of users reaches it as text nodes alone: nothing here reads a string as markup.

const DATA = JSON.parse(document.getElementById("data").textContent);
const TOLD = DATA.told;

/** An element with attributes and children; strings become text, null and false are left out. */
function make(tag, attributes, ...children) {
  const element = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes || {})) {
    if (value === null || value === undefined || value === false) continue;
    if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
    else if (key === "class") element.className = value;
    else element.setAttribute(key, value === true ? "" : String(value));
  }
  return fill(element, children);
}

function fill(element, children) {
  for (const child of children.flat(Infinity)) {
    if (child === null || child === undefined || child === false || child === "") continue;
    element.append(child instanceof Node ? child : document.createTextNode(String(child)));
  }
  return element;
}

function byId(id) {
  return document.getElementById(id);
}

/** A section of the overview, under a heading that the navigation leads to; nothing where it has no content. */
function section(id, title, ...content) {
  const filled = content.flat(Infinity).filter(Boolean);
  if (filled.length === 0) return;
  byId("overview").append(make("section", { id, "aria-label": title }, make("h2", {}, title), filled));
  byId("sections").append(make("a", { href: `#${id}` }, title));
}

const VERDICTS = {
  trackworthy: ["badge", "✓ TRACKWORTHY"],
  "not-trackworthy": ["badge bad-badge", "✗ NOT TRACKWORTHY"],
  error: ["badge error-badge", "! FAILED TO RUN"],
};

function badge(verdict) {
  const [style, words] = VERDICTS[verdict] || VERDICTS.error;
  return make("span", { class: style }, words);
}

/** A table from heads [text, "number" or ""] and rows of cells; a cell is text, nodes, or {class, content}. */
function table(heads, rows, attributes) {
  const cell = (tag, content, style) => make(tag, { class: style, scope: tag === "th" ? "col" : null }, content);
  const body = rows.map((row) => {
    const cells = Array.isArray(row) ? row : row.cells;
    const columns = cells.map((one, i) => {
      const given = one !== null && typeof one === "object" && "content" in one && !(one instanceof Node);
      const style = [heads[i] && heads[i][1], given && one.style].filter(Boolean).join(" ");
      return cell("td", given ? one.content : one, style || null);
    });
    return make("tr", { class: row.style }, columns);
  });
  const head = make("tr", {}, heads.map(([words, style]) => cell("th", words, style || null)));
  return make("div", { class: "scroll" }, make("table", attributes, make("thead", {}, head), make("tbody", {}, body)));
}

/** A command, with a button that copies it. */
function command(words) {
  const code = make("code", {}, words);
  const button = make("button", { class: "button", type: "button", "aria-label": `Copy the command: ${words}` }, "Copy");
  button.addEventListener("click", async () => {
    try {
      await navigator.clipboard.writeText(words);
      button.textContent = "Copied";
    } catch {
      getSelection().selectAllChildren(code); // no clipboard here: Ctrl-C does the rest
      button.textContent = "Selected";
    }
    setTimeout(() => { button.textContent = "Copy"; }, 1500);
  });
  return make("div", { class: "command" }, code, button);
}

function trouble(words) {
  byId("trouble").textContent = words;
  byId("trouble").hidden = false;
}
