/// The reference of keys, as it is read from docs/decks.md.

import assert from "node:assert/strict";
import {readdirSync, readFileSync} from "node:fs";
import {test} from "node:test";
import {fileURLToPath} from "node:url";

import {readExample, sourceWithoutDots} from "../../../src/studio/page/inline_table.js";
import {describe, formsOfKey, sectionOf} from "../../../src/studio/page/key_reference.js";
import {blocksOf, firstSentence, plain} from "../../../src/studio/page/markdown.js";
import {readReference} from "../../../src/studio/page/reference_reader.js";
import {labelOfForm} from "../../../src/studio/page/form_labels.js";
import {isFileForm, valueOfForm} from "../../../src/studio/page/starting_values.js";
import {keyPaths} from "./deck_keys.mjs";

const root = fileURLToPath(new URL("../../../", import.meta.url));
const reference = readReference(readFileSync(`${root}docs/decks.md`, "utf8"));

test("the blocks of a document", () => {
  const document = "# Top\n\nA `key`\nof two lines.\n\n```\n# no heading\n```\n| key | a\\|b |\n|---|---|\n| `x` | 1 |\n| | 2 |\n";
  assert.deepEqual(blocksOf(document), [{kind: "heading", text: "Top"}, {kind: "paragraph", text: "A `key` of two lines."},
    {kind: "table", heads: ["key", "a|b"], rows: [["`x`", "1"], ["", "2"]]}]);
  assert.equal(plain("the **gap** of [`filler`](#filler), *once*"), "the gap of filler, once");
  assert.equal(firstSentence("One, e.g. this. Another one."), "One, e.g. this.");
});

test("examples of values", () => {
  const example = readExample('{ terms = [{ time = "10 ms", modulus = 1 }, ...], ... }');
  assert.deepEqual([...example.table.keys()], ["terms"]);
  assert.equal(sourceWithoutDots(example), '{ terms = [{ time = "10 ms", modulus = 1 }] }');
  assert.equal(readExample("fraction of"), null);
});

test("keys have their type, default and meaning", () => {
  const gap = describe(reference, ["stages", 0, "filler", "gap"]);
  assert.equal(gap.default, '"10 %"');
  assert.match(gap.meaning, /^smallest distance between particles/);
  assert.equal(describe(reference, ["stages", 2, "filler", 1, "gap"]), gap);
  assert.deepEqual(describe(reference, ["tests", "boundaries"]).choices.map(({source}) => source),
    ['"displacement"', '"traction"', '"periodic"']);
  assert.equal(describe(reference, ["tests", "quasistatic", "range"]).section, "tests.quasistatic");
  assert.equal(describe(reference, ["stages", 0, "gap"]), null);
});

test("a row without a key is a further choice of the row above", () => {
  const law = describe(reference, ["materials", "binder", "temperature_shift", "law"]);
  assert.deepEqual(law.choices.map(({source}) => source), ['"wlf"', '"arrhenius"', '"table"', '"measured"']);
  assert.match(law.choices[0].meaning, /^Williams/);
});

test("methods of packing name their keys", () => {
  const {choices} = describe(reference, ["stages", 0, "packing", "method"]);
  const keysOf = (source) => choices.find((one) => one.source === source).keys;
  assert.deepEqual(keysOf('"regular"'), ["columns", "rows"]);
  assert.deepEqual(keysOf('"explicit"'), ["particles", "discs", "polygons", "walls"]);
  assert.deepEqual(describe(reference, ["stages", 0, "packing", "walls"]).choices.map(({source}) => source),
    ["false", "true", '"cut"']);
});

test("the forms of a modulus, and values for them", () => {
  const shear = describe(reference, ["materials", "binder", "shear"]);
  const forms = formsOfKey(reference, shear);
  assert.deepEqual(forms.map(labelOfForm), ["elastic: one value", "Prony series in a file", "Prony series, term by term",
    "measured data, fitted", "2S2P1D (bitumen)", "fractional Zener", "creep by a power law", "logarithmic creep (concrete)"]);
  assert.deepEqual(forms.map(isFileForm), [false, true, false, true, false, false, false, false]);
  assert.equal(valueOfForm(reference, forms[3], "dma.csv"), '{ measured = "dma.csv" }');
  assert.equal(valueOfForm(reference, forms[5]),
    '{ law = "fractional-zener", equilibrium = "1 MPa", unrelaxed = "1 GPa", time = "1 s", exponent = 0.5 }');
  assert.equal(sectionOf(reference, ["materials", "binder", "shear", "terms", 0]), "modulus.terms");
});

test("keys that are named in passing have a few words of their own", () => {
  const words = (...path) => firstSentence(describe(reference, path).meaning);
  const filler = ["stages", 0, "filler"];
  assert.equal(words("materials", "a", "shear", "equilibrium"), "modulus at infinite time.");
  assert.match(describe(reference, ["materials", "a", "shear", "equilibrium"]).meaning, /^modulus at infinite time\. The first two/);
  assert.equal(words("materials", "a", "young", "glassy"), "modulus at time zero, E0");
  assert.equal(words("materials", "a", "factors", "times"), "multiplies all relaxation times");
  assert.equal(words("materials", "a", "stiffness", "symmetry"), "symmetry of the crystal");
  assert.equal(words(...filler, "sizes", "d50"), "half of the volume is smaller");
  assert.equal(words(...filler, "coating", "material"), "material of the layer");
  assert.equal(words("stages", 0, "packing", "method"), "how the particles are placed.");
  assert.match(words("stages", 0, "packing", "walls"), /^false: a periodic box; true: all particles inside; "cut"/);
});

/// Keys of the examples for which the reference has no table: the keys of a sweep are paths.
const exceptions = [/^sweep\./];

test("the reference has every key of the examples", () => {
  const names = readdirSync(`${root}examples`, {recursive: true}).filter((name) => name.endsWith(".toml"));
  assert.ok(names.length > 50);
  const missing = new Set();
  for (const name of names) {
    for (const path of keyPaths(readFileSync(`${root}examples/${name}`, "utf8"))) {
      const isName = path.length === 2 && path[0] === "materials";
      const isVaried = path.length === 4 && path[2] === "vary";
      if (isName || isVaried || exceptions.some((pattern) => pattern.test(path.join(".")))) continue;
      const inDeck = ["stages", "measurements"].includes(path[0]) && path.length > 1 ? path.toSpliced(1, 0, 0) : path;
      if (describe(reference, inDeck) === null) missing.add(`${path.join(".")} (${name})`);
    }
  }
  assert.deepEqual([...missing], []);
});
