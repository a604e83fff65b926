/// A deck that is open: its form and its text, its packing, its plan and its run.

import {element} from "../../page/scripts/elements.js";
import * as api from "./api.js";
import {deckForm} from "./form.js";
import {mistakeList} from "./mistake_list.js";
import {packingPanel} from "./packing_panel.js";
import {planPanel} from "./plan_panel.js";
import {mistakesByPlace} from "./mistake_places.js";
import {textPane} from "./text_pane.js";

/// The view of the deck of the context; `run` is the panel of runs. `update(what)` is called after each change of it.
export function composeView(context, run) {
  const title = element("h2", {id: "deck-title"});
  const state = element("span", {className: "note", role: "status"});
  const step = (text, keys, by) => element("button", {type: "button", title: `${keys} outside of fields`,
    onclick: () => context.deck.step(by)}, text);
  const [undo, redo] = [step("Undo", "Ctrl+Z", -1), step("Redo", "Ctrl+Shift+Z", 1)];
  const conflict = element("div", {className: "notice", role: "alert", hidden: true});
  const failure = element("div", {className: "notice", role: "alert", hidden: true});
  const form = deckForm(context);
  const text = textPane((typed) => context.deck.type(typed));
  const goToLine = (line) => {
    textDetails.open = true;
    text.goTo(line);
  };
  const mistakes = mistakeList(goToLine);
  const toMistakes = element("a", {href: "#side", className: "mistake", hidden: true});
  const plan = planPanel();
  const packing = packingPanel(context);
  const textDetails = element("details", {className: "deck-text", id: "text"},
    element("summary", {}, "Deck as text"), text.element);
  const noForm = element("p", {className: "notice", hidden: true},
    "The text is not TOML at the moment, so that the form shows the last one that was. Mend the text of the deck.");
  const view = element("section", {className: "view compose", ariaLabel: "deck"},
    element("header", {className: "deck-header"}, title, state, element("div", {className: "buttons"}, undo, redo)), conflict, failure,
    element("nav", {className: "jump", ariaLabel: "parts of this view"}, ...[["#form", "Form"],
      ["#side", "Packing, plan and run"], ["#text", "Text"]].map(([href, words]) => element("a", {href}, words)), toMistakes),
    element("div", {className: "columns"},
      element("div", {className: "left", id: "form"}, noForm, form.element),
      element("div", {className: "right", id: "side"}, mistakes.element, packing.element, plan.element, run.element,
        textDetails)));
  let [timer, call, checked, answer] = [0, 0, null, null];
  let places = new Map();
  context.mistakesAt = (path, isDeep = false) => {
    const at = JSON.stringify(path);
    return [...places].filter(([place]) => place === at || (isDeep && place.startsWith(`${at.slice(0, -1)},`)))
      .flatMap(([, found]) => found.map(({message}) => withoutPath(message)));
  };

  function allMistakes() {
    const {deck} = context;
    const ofCheck = answer !== null && checked === deck.text ? answer.mistakes : [];
    return deck.isSaved && ofCheck.length > 0 ? [...ofCheck, ...deck.refusals.values()] : deck.allMistakes;
  }

  function showMistakes() {
    const {deck} = context;
    const all = allMistakes();
    places = mistakesByPlace(deck.tree, all);
    for (const [path, refusal] of deck.refusals) places.set(path, [refusal]);
    mistakes.update(deck.tree, all);
    toMistakes.hidden = all.length === 0;
    toMistakes.textContent = all.length === 1 ? "one mistake" : `${all.length} mistakes`;
    text.show(deck.text, all);
  }

  function update(what) {
    const {deck} = context;
    title.textContent = deck.tree?.entries?.find(({key}) => key === "title")?.value.value ?? deck.name;
    state.textContent = deck.isSaved ? `${deck.name}, saved` : `${deck.name}, not yet saved`;
    undo.disabled = !deck.history.canUndo;
    redo.disabled = !deck.history.canRedo;
    noForm.hidden = deck.isToml;
    showConflict();
    showFailure();
    showMistakes();
    if (what === "text") packing.changed();
    if (what !== "text" && deck.tree !== null) form.update();
    if (["made", "tree", "saved"].includes(what)) planCheck();
    run.update();
  }

  function planCheck() {
    clearTimeout(timer);
    if (!context.deck.isSaved) return;
    if (checked !== context.deck.savedText) {
      timer = setTimeout(check, 250);
    } else if (answer !== null) {
      ++call;  // a check of a text between is of no use any more
      showPlan();
    }
  }

  async function check() {
    const {deck} = context;
    const [number, text] = [++call, deck.savedText];
    plan.wait();
    try {
      const found = await api.check(deck.name);
      if (number !== call || context.deck !== deck) return;
      if (text !== deck.savedText) return;
      [checked, answer] = [text, found];
      showPlan();
      showMistakes();
      if (deck.tree !== null) form.update();
    } catch (error) {
      // Another window may have checked the same deck meanwhile.
      if (number === call && error.status === 409) timer = setTimeout(check, 1000);
      else if (number === call) plan.complain(error.message);
    }
  }

  function showPlan() {
    plan.element.classList.remove("old");
    plan.show(answer);
    if (answer.exit === 0) packing.sound(answer.output);
  }

  /// A text that could not be saved is tried again by the button, or with the next change.
  function showFailure() {
    const {deck} = context;
    const words = deck.failure === null ? "" : `${deck.name} could not be saved: ${deck.failure}. `
      + "What you have typed is on this page alone.";
    if (failure.dataset.words === words) return;
    failure.dataset.words = words;
    failure.hidden = words === "";
    failure.replaceChildren(element("p", {}, words), element("div", {className: "buttons"},
      element("button", {type: "button", onclick: () => deck.save()}, "Try again")));
  }

  function showConflict() {
    const {deck} = context;
    if (conflict.hidden === (deck.conflict === null)) return;
    conflict.hidden = deck.conflict === null;
    const words = "has changed on the disk since this page has read it, as by an editor or another tab. Nothing of "
      + "either is lost yet.";
    conflict.replaceChildren(element("p", {}, `${deck.name} ${words}`),
      element("div", {className: "buttons"},
        element("button", {type: "button", onclick: () => deck.takeTheirs()}, "Load what is on the disk"),
        element("button", {type: "button", onclick: () => deck.keepMine()}, "Keep what is on this page")));
  }

  return {element: view, update};
}

function withoutPath(message) {
  return message.replace(/^(?:"[^"]*"|[\w.*-])+: /, "");
}
