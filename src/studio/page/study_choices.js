/// Choices that matter to every study, also where the deck leaves them at their defaults.

import {element} from "../../page/scripts/elements.js";
import {entry, stagesOf} from "./deck_tree.js";

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

/// What the tests may leave to the program, or ask for besides: offers, which go once they are taken.
export function offersOfTests(context) {
  const offers = [moduliOffer(context), accuracyOffer(context)];
  return {element: element("div", {}, ...offers.map((offer) => offer.element)), update() {
    for (const offer of offers) offer.update();
  }};
}

/// An offer with a button; `isOpen()` says whether it is still to be made.
function offer(words, about, isOpen, take) {
  const button = element("button", {type: "button", className: "quiet", onclick: take}, words);
  const line = element("p", {className: "offer"}, button, element("span", {className: "note"}, ` ${about}`));
  return {element: line, update() {
    line.hidden = !isOpen();
  }};
}

/// Shear alone, the default, or also what E and Poisson's ratio follow from.
function moduliOffer(context) {
  return offer("Also E, K and Poisson's ratio", "G alone is computed; the others take a test in bulk, too.",
    () => entry(entry(context.deck.tree, "tests"), "loads") === undefined,
    () => context.edit(["tests", "loads"], '["isotropic", "bulk"]'));
}

/// Boxes and grids that the program chooses for an error, in place of those of the deck.
function accuracyOffer(context) {
  return offer("Choose boxes and grids for an error of 5 %", "In place of box, particles and cells of the stages.",
    () => entry(entry(context.deck.tree, "tests"), "accuracy") === undefined,
    async () => {
      const {length} = stagesOf(context.deck.tree);
      for (let stage = 0; stage < length; ++stage) {
        for (const key of ["box", "particles", "cells", "resolution"]) {
          const isThere = entry(stagesOf(context.deck.tree)[stage], key) !== undefined;
          if (isThere && !await context.edit(["stages", stage, key], null)) return;
        }
      }
      await context.edit(["tests", "accuracy"], '"5 %"');
    });
}
