/// The page of `breccia studio`.

import {element} from "../../page/scripts/elements.js";
import * as api from "./api.js";
import {commandLog} from "./command_line.js";
import {composeView} from "./compose_view.js";
import {dottedPath} from "./deck_tree.js";
import {readReference} from "./reference_reader.js";
import {OpenDeck} from "./open_deck.js";
import {resultsView} from "./results_view.js";
import {runPanel} from "./run_panel.js";
import {overrideCommand} from "./shell_command.js";
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
  focusPath: null,
  showCommand: (command, about) => log.add(command, about),
  focusAfterwards(path) {
    context.focusPath = path;
  },
  async edit(path, source) {
    const {deck} = context;
    const shellPath = dottedPath(deck.tree, path);
    const isDone = await deck.edit(path, source);
    const about = "this change alone, without writing it into the deck";
    if (isDone) log.add(overrideCommand(deck.name, shellPath, source), about);
    return isDone;
  },
  async refreshFolder() {
    context.folder = {...context.folder, ...await api.getState()};
    // A run that another window has started.
    if (context.folder.job !== null) run.show(context.folder.job);
    showFolder();
  },
};

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
  const taken = new OpenDeck(deck, (what) => {
    if (context.deck === taken) changed(what);
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

function changed(what) {
  compose.update(what);
  if (what === "saved") results.update();
  if (context.focusPath !== null && what === "tree") {
    const name = CSS.escape(JSON.stringify(context.focusPath));
    const found = document.querySelector(`[data-focus="${name}"]`)
      ?? document.querySelector(`[data-path="${name}"]`)?.querySelector("[data-focus]:not([hidden])");
    if (found) {
      found.focus();
      found.select?.();
      context.focusPath = null;
    }
  }
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

/// Shows whether the studio answers; while it does not, it is asked again, and what was typed is then saved.
function showReached(isReached) {
  at("ended").hidden = isReached;
  clearTimeout(retry);
  if (!isReached) retry = setTimeout(() => api.getState().catch(() => {}), 3000);
  else if (context.deck?.isSaved === false && context.deck.conflict === null) retry = setTimeout(() => context.deck.save(), 800);
}

function say(message) {
  at("message").hidden = false;
  const close = element("button", {type: "button", onclick: () => { at("message").hidden = true; }}, "Close");
  at("message").replaceChildren(message, " ", close);
}
