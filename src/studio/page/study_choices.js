/// Choices that matter to every study, also where the deck leaves them at their defaults.

import {element} from "../../page/scripts/elements.js";
import {entry, stagesOf} from "./deck_tree.js";
import {dimensionsChanges, dimensionsWords, isInSpace, whyNotInSpace} from "./dimensions.js";

let count = 0;

/// A cross-section in two dimensions, the default, or the body itself in three, where the deck can be either.
export function dimensionsChoice(context) {
  const id = `dimensions-${++count}`;
  const list = element("select", {id,
    onchange: () => context.change(dimensionsChanges(context.deck.tree, Number(list.value)), ["dimensions"])},
  element("option", {value: "2"}), element("option", {value: "3"}));
  list.dataset.focus = JSON.stringify(["dimensions"]);
  const note = element("span", {className: "note"});
  const field = element("div", {className: "field"}, element("label", {className: "key", htmlFor: id}, "model"),
    element("div", {className: "content"}, element("div", {className: "value"}, list), note));
  field.dataset.path = JSON.stringify(["dimensions"]);
  return {element: field, update() {
    const {tree} = context.deck;
    const reason = whyNotInSpace(tree);
    const words = dimensionsWords(tree);
    const texts = [words.plane, words.space];
    [...list.options].forEach((option, i) => {
      if (option.textContent !== texts[i]) option.textContent = texts[i];
    });
    list.value = isInSpace(tree) ? "3" : "2";
    list.disabled = reason !== "" && !isInSpace(tree);
    note.textContent = reason !== "" ? reason : isInSpace(tree) ? words.ofSpace : words.ofPlane;
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
    () => {
      const given = stagesOf(context.deck.tree).flatMap((stage, i) => ["box", "particles", "cells", "resolution"]
        .filter((key) => entry(stage, key) !== undefined).map((key) => ({path: ["stages", i, key], value: null})));
      return context.change([...given, {path: ["tests", "accuracy"], value: '"5 %"'}], ["tests", "accuracy"]);
    });
}
