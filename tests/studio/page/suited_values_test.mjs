/// Values that the page writes into a deck, and whether they go with what the deck has.

import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import {test} from "node:test";

import {changesOfChoice, filesOfChoice, whyNotChoice} from "../../../src/studio/page/choice_changes.js";
import {dimensionsChanges, whyNotInSpace} from "../../../src/studio/page/dimensions.js";
import {excludes} from "../../../src/studio/page/key_conflicts.js";
import {lengthOf, lengthText} from "../../../src/studio/page/quantities.js";
import {neighbour, whyNot} from "../../../src/studio/page/order_buttons.js";
import {takesFiller} from "../../../src/studio/page/packing_change.js";
import {readReference} from "../../../src/studio/page/reference_reader.js";
import {describe} from "../../../src/studio/page/key_reference.js";
import {startingValue} from "../../../src/studio/page/starting_values.js";
import {newFiller, newStage} from "../../../src/studio/page/suited_values.js";
import {treeOf} from "./tree_of.mjs";

const reference = readReference(readFileSync(new URL("../../../docs/decks.md", import.meta.url), "utf8"));

const deck = {
  materials: {binder: {bulk: "3 GPa", shear: {measured: "dma.csv", reference_temperature: "25 degC"}}, stone: {bulk: "30 GPa",
    shear: "20 GPa"}},
  stages: [{name: "mastic", matrix: "binder", box: "100 um", cells: [64, 128], packing: {method: "random", seed: 1},
    filler: {material: "stone", fraction: 0.5, sizes: {from: "5 um", to: "10 um"}, gap: "0.5 um"}}],
  tests: {times: ["1 ms", "1 s"]},
};
const tree = treeOf(deck);
const withStage = (changes) => treeOf({...deck, stages: [{...deck.stages[0], ...changes}]});
const shown = (changes) => changes.map(({path, value}) => `${path.join(".")} = ${value}`);

test("lengths", () => {
  assert.deepEqual(["2 mm", "0.5 µm", "4e3 m", "2 kg", "10 %", undefined].map(lengthOf), [2e-3, 0.5e-6, 4e3, null, null, null]);
  assert.deepEqual([2e-3, 0.1e-3, 5e-6, 1, 1234e-9].map(lengthText), ["2 mm", "100 um", "5 um", "1 m", "1.2 um"]);
});

test("another filler and another stage have sizes like those that are there", () => {
  assert.equal(newFiller(tree, 0), '{ material = "stone", fraction = 0.05, sizes = { diameter = "5 um" }, gap = "500 nm" }');
  const ofAmounts = withStage({filler: [{material: "stone", amount: {mass: "60 %"}, sizes: {fuller: "4 mm"}}]});
  assert.equal(newFiller(ofAmounts, 0), '{ material = "stone", amount = { mass = "1 %" }, sizes = { diameter = "4 mm" }, gap = "200 um" }');
  assert.equal(newStage(tree, "mortar"), '{ name = "mortar", matrix = "mastic", filler = { material = "stone", fraction = 0.2, '
    + 'sizes = { diameter = "50 um" }, gap = "2.5 um" }, packing = { method = "random", seed = 1 } }');
});

test("a shift of temperature begins with what changes nothing", () => {
  const value = (key, material) => startingValue(reference, describe(reference, ["materials", material, key]),
    {tree, path: ["materials", material]});
  assert.equal(value("temperature_shift", "binder"), '{ law = "measured", temperature = "25 degC" }');
  assert.equal(value("temperature_shift", "stone"),
    '{ law = "wlf", c1 = 8.86, c2 = "101.6 K", reference = "20 degC", temperature = "20 degC" }');
  assert.equal(value("factors", "binder"), "{ times = 1, modulus = 1 }");
});

test("a part of a picture begins with its largest square", () => {
  const path = ["stages", 0, "packing"];
  assert.equal(startingValue(reference, describe(reference, [...path, "crop"]), {tree, path, picture: {width: 301, height: 512}}),
    "{ left = 0, top = 0, width = 300, height = 300 }");
});

test("keys that the rest of the deck excludes are not offered", () => {
  const filler = ["stages", 0, "filler"];
  assert.deepEqual(["amount", "fraction", "from"].map((key) => excludes(tree, filler, key)), [true, false, false]);
  assert.deepEqual(["particles", "resolution", "bonds", "packing"].map((key) => excludes(tree, ["stages", 0], key)),
    [true, true, true, false]);
  assert.ok(excludes(tree, ["materials", "stone"], "young"));
  assert.deepEqual(["binder", "stone"].map((name) => excludes(tree, ["materials", name], "factors")), [false, true]);
  assert.ok(excludes(tree, ["tests"], "frequencies"));
  assert.ok(excludes(withStage({packing: {method: "regular"}}), filler, "gap"));
});

test("another method of packing asks for all that it needs", () => {
  const method = ["stages", 0, "packing", "method"];
  const changes = (source, file, of = tree) => shown(changesOfChoice(reference, of, method, source, file));
  assert.deepEqual(changes('"random-sequential"'), ['stages.0.packing.method = "random-sequential"']);
  assert.deepEqual(changes('"image"', "scan.png"), ['stages.0.packing.method = "image"', "stages.0.packing.seed = null",
    "stages.0.filler = null", 'stages.0.packing.file = "scan.png"', 'stages.0.packing.threshold = "otsu"',
    'stages.0.packing.labels = { dark = "binder", bright = "stone" }']);
  assert.deepEqual(changes('"regular"'), ['stages.0.packing.method = "regular"', "stages.0.packing.seed = null",
    "stages.0.filler.fraction = null", "stages.0.filler.gap = null", 'stages.0.filler.sizes = { diameter = "5 um" }',
    "stages.0.packing.columns = 16", "stages.0.packing.rows = 16"]);
  const image = withStage({filler: {}, packing: {method: "image", file: "a.png", labels: {}}});
  image.entries[1].value.items[0].entries = image.entries[1].value.items[0].entries.filter(({key}) => key !== "filler");
  assert.deepEqual(changes('"random"', null, image).slice(0, 4), ['stages.0.packing.method = "random"',
    "stages.0.packing.file = null", "stages.0.packing.labels = null",
    'stages.0.filler = { material = "stone", fraction = 0.2, sizes = { diameter = "10 um" }, gap = "500 nm" }']);
  const folder = {tables: ["a.csv"], pictures: ["b.png"]};
  assert.deepEqual(['"random"', '"explicit"', '"image"'].map((source) => filesOfChoice(reference, tree, method, source, folder)),
    [null, ["a.csv"], ["b.png"]]);
  assert.equal(whyNotChoice(withStage({filler: [{}, {}]}), method, '"regular"'), "for one filler alone");
  assert.deepEqual([tree, image, withStage({packing: {method: "laguerre"}})].map((one) => takesFiller(one, 0)), [true, false, false]);
});

test("another law of temperatures brings its constants, and takes those of the other one", () => {
  const shift = {law: "wlf", c1: 6.5, c2: "120 K", reference: "19 degC", temperature: "40 degC"};
  const shifted = treeOf({...deck, materials: {binder: {temperature_shift: shift}}});
  const path = ["materials", "binder", "temperature_shift", "law"];
  const at = "materials.binder.temperature_shift";
  assert.deepEqual(shown(changesOfChoice(reference, shifted, path, '"arrhenius"')), [`${at}.law = "arrhenius"`, `${at}.c1 = null`,
    `${at}.c2 = null`, `${at}.activation_energy = "120 kJ/mol"`]);
  assert.deepEqual(shown(changesOfChoice(reference, shifted, path, '"table"', "shift.csv")), [`${at}.law = "table"`,
    `${at}.c1 = null`, `${at}.c2 = null`, `${at}.table = "shift.csv"`]);
  assert.deepEqual(filesOfChoice(reference, shifted, path, '"table"', {tables: ["shift.csv"]}), ["shift.csv"]);
  assert.deepEqual(shown(changesOfChoice(reference, shifted, path, '"measured"')), [`${at}.law = "measured"`, `${at}.c1 = null`,
    `${at}.c2 = null`, `${at}.reference = null`]);
});

test("three dimensions where the deck can have them", () => {
  const image = (file) => withStage({packing: {method: "image", file, page: 2}});
  assert.equal(whyNotInSpace(tree), "");
  assert.match(whyNotInSpace(image("scan.png")), /^A PNG is one picture/);
  assert.equal(whyNotInSpace(image("scan.tif")), "");
  assert.match(whyNotInSpace(withStage({filler: {shape: {polygon: "a.csv"}}})), /no polygons/);
  assert.deepEqual(shown(dimensionsChanges(image("scan.tif"), 3)), ["dimensions = 3", "stages.0.packing.page = null"]);
  assert.deepEqual(shown(dimensionsChanges(image("scan.tif"), 2)), ["dimensions = null", "stages.0.packing.page = 1"]);
  const regular = withStage({packing: {method: "regular", columns: 4, rows: 4}});
  assert.deepEqual(shown(dimensionsChanges(regular, 3)), ["dimensions = 3", "stages.0.packing.columns = null",
    "stages.0.packing.rows = null", 'stages.0.packing.lattice = "sc"', "stages.0.packing.repeats = 4"]);
  const loads = treeOf({...deck, tests: {loads: ["shear", "shear-yz"]}});
  assert.deepEqual(shown(dimensionsChanges(loads, 2)), ["dimensions = null", 'tests.loads = ["shear"]']);
});

test("what can change places", () => {
  const chain = treeOf({...deck, stages: [{name: "a"}, {name: "b", matrix: "a"}, {name: "c"}]});
  assert.deepEqual([neighbour(chain, ["stages", 0], -1), neighbour(chain, ["stages", 0], 1)], [null, ["stages", 1]]);
  assert.deepEqual(neighbour(chain, ["materials", "binder"], 1), ["materials", "stone"]);
  const stages = chain.entries[1].value.items;
  assert.equal(whyNot(stages, 0), "b has a as its matrix, so that it stands behind it");
  assert.equal(whyNot(stages, 1), "");
});
