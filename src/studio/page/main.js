/// The page of `breccia studio`.

import {element} from "../../page/scripts/elements.js";
import * as api from "./api.js";
import {commandLog} from "./command_line.js";
import {composeView} from "./compose_view.js";
import {FocusAfterChange} from "./focus_after_change.js";
import {readReference} from "./reference_reader.js";
import {OpenDeck} from "./open_deck.js";
import {resultsView} from "./results_view.js";
import {runPanel} from "./run_panel.js";
import {startView} from "./start_view.js";

const at = (id) => document.getElementById(id);
const log = commandLog();
document.body.append(log.element);

/// What all parts of the page share.
const context = {
  deck: null,
  folder: {decks: [], tables: [], pictures: [], examples: [], results: [], folder: "", version: ""},
  reference: new Map(),
  mistakesAt: () => [],
  showCommand: (command, about) => log.add(command, about),
  /// Replaces the value at a path by a source of TOML, as it is typed or chosen; null removes it.
  edit: (path, source) => changing(path, context.deck.edit(path, source)),
  /// Makes several changes as one step of undo.
  change: (changes, path = changes[0].path) => changing(path, context.deck.change(changes, path)),
  /// Removes the value at a path; the focus goes to what takes its place.
  remove(path) {
    focus.afterRemovalOf(path);
    return context.change([{path, value: null}]);
  },
  /// Gives the material or the stage at a path another name; a material has another path by it.
  rename(path, name) {
    const renamed = [path[0], name];
    if (path[0] === "materials") {
      context.renamedPath = (one) => one[0] === path[0] && one[1] === path[1] ? [...renamed, ...one.slice(2)] : one;
    }
    return context.change([{path, name}], [...path, "name"]);
  },
  /// The path, after the last renaming, of what had another path before.
  renamedPath: (path) => path,
  /// The places to one of which the focus goes after the next change: the first that is there.
  focusAfterwards: (...paths) => focus.goesTo(paths),
  async refreshFolder() {
    context.folder = {...context.folder, ...await api.getState()};
    // A run that another window has started.
    if (context.folder.job !== null) run.show(context.folder.job);
    showFolder();
  },
};

const focus = new FocusAfterChange();

/// Waits for a change of the deck at a path, and shows the command that does the same. Resolves to whether it was made.
async function changing(path, change) {
  focus.waitsFor(path);
  const answer = await change;
  if (answer === null) focus.stays();
  else if (answer.command) log.add(answer.command, "this change alone, without writing it into the deck");
  return answer !== null;
}

const start = startView(context, {openDeck, take});
const run = runPanel(context, {
  openResult: async (path) => {
    await context.refreshFolder();
    show("results");
    results.open(path);
  },
  finished: () => context.refreshFolder(),
});
const results = resultsView(context);
let compose = null;
at("start").append(start.element);
at("results").append(results.element);
for (const name of ["start", "compose", "results"]) at(`to-${name}`).addEventListener("click", () => show(name));
addEventListener("keydown", undoByKey);
// A file that is dropped beside its target would take the place of the page.
for (const name of ["dragover", "drop"]) addEventListener(name, (event) => event.preventDefault());
addEventListener("beforeunload", (event) => {
  if ([...opened.values()].some((deck) => !deck.isSaved)) event.preventDefault();
});
api.whenReached(showReached);
begin();

async function begin() {
  try {
    const reference = await fetch("decks.md").then((response) => response.text());
    context.reference = readReference(reference);
    await context.refreshFolder();
    const {opened, job} = context.folder;
    if (job !== null) run.show(job);
    if (opened !== null) await openDeck(opened);
    else show(location.hash === "#results" ? "results" : "start");
  } catch (error) {
    say(error.message);
  }
}

function showFolder() {
  const {folder, version, results: found} = context.folder;
  at("folder").textContent = folder;
  at("version").textContent = version;
  at("result-count").textContent = found.length === 0 ? "" : ` ${found.length}`;
  start.update();
  results.update();
  if (context.deck !== null) compose.update("folder");
}

/// The decks that were open in this window, by name: what of them is not saved is not lost when another one is opened.
const opened = new Map();

async function openDeck(name) {
  const known = opened.get(name);
  if (known !== undefined && !known.isSaved) return showDeck(known);
  try {
    take(await api.getDeck(name));
  } catch (error) {
    say(error.message);
    show("start");
  }
}

function take(deck) {
  const taken = new OpenDeck(deck, (what, path) => {
    if (context.deck === taken) changed(what, path);
  });
  opened.set(deck.name, taken);
  showDeck(taken);
}

function showDeck(deck) {
  context.deck = deck;
  compose = composeView(context, run);
  at("compose").replaceChildren(compose.element);
  at("to-compose").hidden = false;
  at("to-compose").textContent = deck.name;
  changed("tree");
  context.refreshFolder().catch(() => {});
  show("compose");
}

function changed(what, path = null) {
  compose.update(what);
  if (what === "saved") results.update();
  if (what === "made") focus.goAfter(path);
}

function show(name) {
  for (const one of ["start", "compose", "results"]) {
    at(one).hidden = one !== name;
    at(`to-${one}`).setAttribute("aria-current", one === name ? "page" : "false");
  }
  scrollTo(0, 0);
  if (name !== "compose") context.refreshFolder().catch(() => {});
}

function undoByKey(event) {
  const isField = document.activeElement?.matches("input:not([type=checkbox]), textarea");
  if (!(event.ctrlKey || event.metaKey) || isField || context.deck === null || at("compose").hidden) return;
  const key = event.key.toLowerCase();
  const by = key === "y" || (key === "z" && event.shiftKey) ? 1 : key === "z" ? -1 : 0;
  if (by === 0) return;
  event.preventDefault();
  context.deck.step(by);
}

let retry = 0;

/// Shows whether the studio answers; while it does not, it is asked again, and what was typed is then saved. A text that
/// the studio has refused to save is not sent again.
function showReached(isReached) {
  at("ended").hidden = isReached;
  clearTimeout(retry);
  const {deck} = context;
  const isToSave = () => deck !== null && !deck.isSaved && deck.conflict === null && deck.failure === null;
  if (!isReached) retry = setTimeout(() => api.getState().catch(() => {}), 3000);
  // Asked again after the pause: the call that has been answered may be the one that refuses to save.
  else if (isToSave()) retry = setTimeout(() => isToSave() && deck.save(), 800);
}

function say(message) {
  at("message").hidden = false;
  const close = element("button", {type: "button", onclick: () => { at("message").hidden = true; }}, "Close");
  at("message").replaceChildren(message, " ", close);
}
