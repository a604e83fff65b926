/// Choices that matter to every study, also where the deck leaves them at their defaults.

import {element} from "../../page/scripts/elements.js";
import {entry} from "./deck_tree.js";

let count = 0;

/// Discs in two dimensions, the default, or spheres in three.
export function dimensionsChoice(context) {
  const id = `dimensions-${++count}`;
  const list = element("select", {id, onchange: () => context.edit(["dimensions"], list.value === "3" ? "3" : null)},
    element("option", {value: "2"}, "in two dimensions: discs, cross-sections of cylinders"),
    element("option", {value: "3"}, "in three dimensions: spheres, ellipsoids, grains"));
  list.dataset.focus = JSON.stringify(["dimensions"]);
  const note = element("span", {className: "note"});
  const field = element("div", {className: "field"}, element("label", {className: "key", htmlFor: id}, "model"),
    element("div", {className: "content"}, element("div", {className: "value"}, list), note));
  field.dataset.path = JSON.stringify(["dimensions"]);
  return {element: field, update() {
    const isSpace = entry(context.deck.tree, "dimensions")?.value === 3;
    list.value = isSpace ? "3" : "2";
    note.textContent = isSpace ? "takes longer, and is what a composite of particles is"
      : "quick; spheres of the same fraction are stiffer, and the result says by how much where a rule is known";
  }};
}

/// Shear alone, the default, or also what E and Poisson's ratio follow from.
export function moduliChoice(context) {
  const button = element("button", {type: "button", className: "quiet",
    onclick: () => context.edit(["tests", "loads"], '["isotropic", "bulk"]')}, "Also E, K and Poisson's ratio");
  const note = element("span", {className: "note"}, " G alone is computed; the others take a test in bulk, too.");
  const line = element("p", {className: "offer"}, button, note);
  return {element: line, update() {
    line.hidden = entry(entry(context.deck.tree, "tests"), "loads") !== undefined;
  }};
}
