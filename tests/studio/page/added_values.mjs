/// What the page writes when a key is added, or a form or a word is chosen, against the program itself: `breccia check`
/// accepts each of these beside the rest of the deck.

import assert from "node:assert/strict";
import {cp, mkdtemp, readFile, rm, writeFile} from "node:fs/promises";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {after, before, test} from "node:test";

import {offeredKeys} from "../../../src/studio/page/add_key.js";
import {changesOfChoice, filesOfChoice, whyNotChoice} from "../../../src/studio/page/choice_changes.js";
import {controlKind} from "../../../src/studio/page/control_kind.js";
import {entry, stagesOf, walk} from "../../../src/studio/page/deck_tree.js";
import {dimensionsChanges} from "../../../src/studio/page/dimensions.js";
import {changesOfForm, whyNotForm} from "../../../src/studio/page/form_changes.js";
import {describe, formsOfKey, sectionOf} from "../../../src/studio/page/key_reference.js";
import {readReference} from "../../../src/studio/page/reference_reader.js";
import {isFile, isFileForm, startingValue} from "../../../src/studio/page/starting_values.js";
import {newFiller, newStage} from "../../../src/studio/page/suited_values.js";
import {Studio} from "./studio_process.mjs";

const root = new URL("../../../", import.meta.url);
let [studio, folder, reference, image] = [];

before(async () => {
  folder = await mkdtemp(join(tmpdir(), "breccia-values-test-"));
  reference = readReference(await readFile(new URL("docs/decks.md", root), "utf8"));
  studio = await Studio.start(process.env.BRECCIA, folder);
  await cp(new URL("examples/image/micrograph.png", root), join(folder, "micrograph.png"));
  image = "micrograph.png";
});

after(async () => {
  await studio.end("SIGKILL");
  await rm(folder, {recursive: true, force: true, maxRetries: 5});
});

async function deckOf(name, example) {
  await studio.ask("api/new", {name, example});
  return studio.ask(`api/deck?name=${name}`);
}

/// What `breccia check` has against a deck with some changes; "" if nothing.
async function complaint(deck, changes) {
  const edited = await studio.ask("api/edit", {text: deck.text, name: deck.name, changes});
  const shown = changes.map(({path, value}) => `${path.join(".")} = ${value}`).join("; ");
  if (edited.error !== undefined) return `${shown}: ${edited.error}`;
  await writeFile(join(folder, "changed.toml"), edited.text);
  const {exit, mistakes} = await studio.ask("api/check", {name: "changed.toml"});
  return exit === 0 ? "" : `${shown}: ${mistakes.map(({message}) => message).join("; ")}`;
}

/// The tables of a deck, which have keys of the reference.
function tablesOf(tree) {
  const tables = [[[], tree]];
  walk(tree, (node, path) => {
    if (node.type === "table" && sectionOf(reference, path) !== null) tables.push([path, node]);
  });
  return tables;
}

/// Changes by the lists of the form, each of which is one gesture: added keys, other forms, other words.
function gesturesOf({tree}) {
  const gestures = [];
  for (const [path, node] of tablesOf(tree)) {
    for (const key of offeredKeys(reference, tree, path, node)) {
      if (isFile(key) || (path.length === 0 && ["measurements", "dimensions"].includes(key.key))) continue;
      gestures.push([{path: [...path, key.key], value: startingValue(reference, key, {tree, path})}]);
    }
    for (const {key: name, value} of node.entries) {
      const at = [...path, name];
      const key = describe(reference, at);
      for (const form of formsOfKey(reference, key).filter((one) => !isFileForm(one))) {
        if (whyNotForm(tree, at, form) === "") gestures.push(changesOfForm(reference, tree, {path: at, key, form}));
      }
      if (controlKind(value, key) !== "choice") continue;
      for (const {source} of key.choices.filter((one) => whyNotChoice(tree, at, one.source) === "")) {
        const files = filesOfChoice(reference, tree, at, source, {tables: [], pictures: [image]});
        if (files?.length === 0) continue;
        gestures.push(changesOfChoice(reference, tree, at, source, files?.[0]));
      }
    }
  }
  return gestures;
}

/// What no value can make sound: another lattice whose particles touch.
const known = [/touch at a regular spacing/];

for (const [name, example] of [["starter.toml", null], ["two.toml", "two-fillers.toml"], ["picture.toml", "image.toml"],
  ["cubes.toml", "cubic-arrays.toml"], ["grains.toml", "pbx9501-grains-quick.toml"]]) {
  test(`what the page writes into ${name} is sound`, {timeout: 300000}, async () => {
    const deck = await deckOf(name, example);
    const complaints = [];
    for (const changes of gesturesOf(deck)) {
      const found = await complaint(deck, changes);
      if (found !== "" && !known.some((pattern) => pattern.test(found))) complaints.push(found);
    }
    assert.deepEqual(complaints, []);
  });
}

test("a filler and a stage more, and three dimensions", {timeout: 120000}, async () => {
  const deck = await deckOf("more.toml", null);
  const {tree} = deck;
  const fillers = `[${deck.text.match(/^filler +=\s(.*)$/m)[1]}, ${newFiller(tree, 0)}]`;
  assert.equal(await complaint(deck, [{path: ["stages", 0, "filler"], value: fillers}]), "");
  assert.equal(await complaint(deck, [{path: ["stages", 1], value: newStage(tree, "mortar")}]), "");
  assert.equal(entry(stagesOf(tree)[0], "name").value, "composite");
  assert.equal(await complaint(deck, [...dimensionsChanges(tree, 3), {path: ["stages", 0, "cells"], value: "24"}]), "");
});
