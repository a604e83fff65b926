/// What the page makes of a deck and of what the program says: values, places of mistakes, plans.

import assert from "node:assert/strict";
import {test} from "node:test";

import {controlKind, ordered} from "../../../src/studio/page/control_kind.js";
import {highlights, mostParticles} from "../../../src/studio/page/check_output.js";
import {columnsOf, entriesOfFit, kindOfFit} from "../../../src/studio/page/measured_source.js";
import {mistakesByPlace, placeOf} from "../../../src/studio/page/mistake_places.js";
import {moduliOf, textOfModulus} from "../../../src/studio/page/result_moduli.js";
import {TextsHistory} from "../../../src/studio/page/texts_history.js";
import {sourceOf, sourceOfTyped, typedOf} from "../../../src/studio/page/toml_source.js";

const text = (value, line) => ({type: "text", line, value});
const table = (line, entries, inline = false) => ({type: "table", line, inline,
  entries: Object.entries(entries).map(([key, value]) => ({key, value}))});

const tree = table(1, {
  title: text("A", 1),
  materials: table(3, {binder: table(3, {bulk: text("1 um", 4), shear: text("1 MPa", 5)})}),
  stages: {type: "array", line: 7, items: [table(7, {
    name: text("HB-1", 8), boxx: text("20 mm", 9),
    filler: table(10, {material: text("stone", 10), fraction: {type: "number", line: 10, value: 2}}, true),
  })]},
});

test("mistakes are shown at their fields", () => {
  const place = (line, message) => placeOf(tree, {line, message});
  assert.deepEqual(place(4, 'materials.binder.bulk: expected a pressure, got "1 um"'), ["materials", "binder", "bulk"]);
  // A key that is not known is named in the message; the line has it.
  assert.deepEqual(place(9, 'stages.HB-1: unknown key "boxx", did you mean "box"?'), ["stages", 0, "boxx"]);
  // A key that is missing has the place of its table.
  assert.deepEqual(place(7, "stages.HB-1.packing: missing"), ["stages", 0]);
  // Of several values of one line the path of the message says which.
  assert.deepEqual(place(10, "stages.HB-1.filler.fraction: expected a number between 0 and 1"),
    ["stages", 0, "filler", "fraction"]);
  assert.deepEqual(place(10, "stages.0.filler: nothing"), ["stages", 0, "filler"]);
  assert.deepEqual(place(5, "without a path"), ["materials", "binder", "shear"]);
  assert.equal(place(0, "the file is empty"), null);
  assert.equal(placeOf(null, {line: 3, message: "no TOML"}), null);
  const places = mistakesByPlace(tree, [{line: 4, message: "a"}, {line: 4, message: "b"}, {line: 0, message: "c"}]);
  assert.deepEqual([...places].map(([path, found]) => [path, found.length]), [['["materials","binder","bulk"]', 2], ["null", 1]]);
});

const plan = `stages
  composite
    filler   particle, 0.5 of the box
plan, with an estimate of the composite's modulus (a run computes it and may need less)
  composite periodic, quasi-static: 128 x 128 cells, 52429 unknowns, about 145 MB, some 4 s
  composite: 13 cells across the smallest disc, the error of the grid is up to about 3.9 % by a rule; cells = 100 for 5 %
  composite: 64 particles, the error of the packing is up to about 7.5 % by a rule; 146 would have 5 %
warning: composite: the smallest gap is narrow
composite: filler of the whole: 50.3 % by volume, 60.3 % by mass
together about 5.4 s on one core, at most 145 MB of memory
`;

test("a plan by what matters first", () => {
  assert.deepEqual(highlights(plan).map(({kind, text: words}) => `${kind}: ${words.slice(0, 60)}`), [
    "cost: together about 5.4 s on one core, at most 145 MB",
    "grid: composite: 13 cells across the smallest disc, the error of t",
    "packing: composite: 64 particles, the error of the packing is up to a",
    "filler: composite: filler of the whole: 50.3 % by volume, 60.3 % by ",
    "warning: composite: the smallest gap is narrow"]);
  assert.equal(mostParticles(plan), 64);
  assert.deepEqual([highlights(""), mostParticles("")], [[], 0]);
});

test("values as they are typed and as a deck has them", () => {
  assert.equal(sourceOfTyped(" 2 mm "), '"2 mm"');
  assert.equal(sourceOfTyped("0.65"), "0.65");
  assert.equal(sourceOfTyped("65 %"), '"65 %"');
  assert.equal(sourceOfTyped("2", {isText: true}), '"2"');
  assert.equal(sourceOfTyped("3", {wasText: true}), '"3"');
  assert.equal(sourceOfTyped("[64, 128]", {wasText: true}), "[64, 128]");
  assert.equal(sourceOfTyped('say "a\\b"', {isText: true}), '"say \\"a\\\\b\\""');
  const node = table(1, {value: {type: "number", value: 0.5}, "a b": {type: "array", items: [text("x")]}}, true);
  assert.equal(sourceOf(node), '{ value = 0.5, "a b" = ["x"] }');
  assert.equal(typedOf(text("2 mm")), "2 mm");
});

test("controls suit the values", () => {
  const key = {section: "tests", key: "solver", type: '"reduced" or "stepping"', choices: [{source: '"reduced"'}]};
  assert.equal(controlKind(text("reduced"), key), "choice");
  assert.equal(controlKind(text("isotropic"), {...key, key: "loads", type: '"isotropic", or an array of "shear"'}), "many");
  assert.equal(controlKind(text("otsu"), {...key, key: "threshold", type: '"otsu" or a number'}), "typed");
  assert.equal(controlKind({type: "boolean", value: true}, null), "check");
  assert.equal(controlKind(text("a.csv"), {...key, key: "prony", choices: [], type: ""}), "file");
  assert.equal(controlKind(tree.entries[2].value, null), "list");
  assert.deepEqual(ordered([{key: "gap"}, {key: "new"}, {key: "material"}], "stages.*.filler").map((one) => one.key),
    ["material", "gap", "new"]);
});

test("undo takes what is typed in one place as one step", () => {
  const history = new TextsHistory("a");
  history.add("ab", "place", 1000);
  history.add("abc", "place", 1500);
  history.add("abcd", "other", 1600);
  assert.deepEqual([history.step(-1), history.step(-1), history.canUndo], ["abc", "a", false]);
  assert.equal(history.step(1), "abc");
  history.add("x", "place", 1700);
  assert.deepEqual([history.canRedo, history.step(-1)], [false, "abc"]);
});

test("what a deck takes from a fit", () => {
  const fit = {page: "files/results/dma-fit/report.html", output: 'For a material of a deck:\ntemperature_shift = { law = "wlf" }\n'};
  assert.deepEqual(entriesOfFit("young", "dma.csv", {reference_temperature: "20 degC"}, fit),
    [["young", '{ measured = "dma.csv", reference_temperature = "20 degC" }']]);
  assert.deepEqual(entriesOfFit("shear", "dma.csv", {columns: columnsOf("storage=A\n\n loss=B")}, fit),
    [["shear", '{ prony = "results/dma-fit/prony.csv" }'], ["temperature_shift", '{ law = "wlf" }']]);
  assert.equal(kindOfFit('  storage modulus   "E\' [MPa]" [MPa], 1 to 2'), "young");
  assert.equal(kindOfFit("it is taken for G; --modulus young or bulk says otherwise"), "");
});

test("moduli of a result", () => {
  const curves = "stage,load,boundary,method,cells,time_s,modulus_Pa\nA,shear,periodic,quasistatic,64,0.001,9e5\n"
    + "A,shear,periodic,quasistatic,64,1,5e4\nA,isotropic,periodic,quasistatic,64,0.001,8e5\n"
    + "A,isotropic,periodic,quasistatic,64,1,4e4\nA,isotropic,periodic,quasistatic,128,0.001,7e5\n"
    + "A,isotropic,periodic,quasistatic,128,1,3e4\n";
  assert.deepEqual(moduliOf(null, curves), {symbol: "G", boundary: "periodic", first: {time: 0.001, modulus: 7e5, error: null},
    last: {time: 1, modulus: 3e4, error: null}});
  const errors = "stage,load,boundary,method,cells,time_s,modulus_Pa,error\nA,shear,periodic,quasistatic,extrapolated,0.001,9e5,0.064\n";
  assert.equal(textOfModulus(moduliOf(errors, curves).first), "900 kPa ± 6.4 % at 1 ms");
  assert.equal(moduliOf(null, null), null);
});
