// Prints what the page of a study shows first, as JSON: its answer, its warnings and its table of moduli.
//
//   node first_screen.mjs REPORT.html

import {readFileSync} from "node:fs";

/// An element that keeps its children and its text, which is all that the first screen takes of a browser.
class Element {
  constructor(id) {
    Object.assign(this, {id, children: [], own: "", hidden: false, href: "", className: "", style: {}});
  }

  set textContent(text) { this.own = text; }
  get textContent() { return this.own + this.children.map((child) => child.textContent ?? child).join(""); }
  append(...children) { this.children.push(...children); }
  prepend(...children) { this.children.unshift(...children); }
  setAttribute() {}
  addEventListener() {}
  get parentElement() { return new Element(""); }
  /// The elements of a tag below this one.
  all(tag) {
    return this.children.filter((child) => child instanceof Element)
      .flatMap((child) => [...(child.tag === tag ? [child] : []), ...child.all(tag)]);
  }
}

const elements = new Map();
const found = (id) => {
  if (!elements.has(id)) elements.set(id, new Element(id));
  return elements.get(id);
};
globalThis.document = {
  getElementById: found,
  querySelector: found,
  createElement: (tag) => Object.assign(new Element(""), {tag}),
};
const page = readFileSync(process.argv[2], "utf8");
found("data").textContent = page.match(/<script type="application\/json" id="data">(.*?)<\/script>/s)[1];

const scripts = new URL("../../src/page/scripts/", import.meta.url);
const {allCurves} = await import(new URL("curves.js", scripts));
const {showResult, showWarnings, showModuli} = await import(new URL("first_screen.js", scripts));
const curves = allCurves();
showResult(curves);
showWarnings();
showModuli(curves);
const rows = found("moduli").all("tr").map((row) => row.children.map((cell) => cell.textContent));
console.log(JSON.stringify({answer: found("summary").textContent, rows,
  warnings: found("all-warnings").children.map((line) => line.textContent)}));
