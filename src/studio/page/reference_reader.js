/// Reads the reference of the keys of a deck from docs/decks.md: the tables under its headings, and the keys that its
/// paragraphs name in passing.

import {readExample} from "./inline_table.js";
import {firstKey, formsOf} from "./key_reference.js";
import {blocksOf, codesIn, plain} from "./markdown.js";

const sectionOfHeading = new Map([["Top", ""], ["Materials", "materials.*"], ["Crystals", "materials.*"],
  ["Uncertain numbers", "uncertain"], ["Stages", "stages.*"], ["Three dimensions", "stages.*"],
  ["filler", "stages.*.filler"], ["packing", "stages.*.packing"], ["bonds", "stages.*.bonds"],
  ["Images", "stages.*.packing"], ["Tests", "tests"], ["Measurements", "measurements.*"], ["Sweeps", "sweep"]]);

/// Reads the document. The result maps the pattern of each section to a Map of its keys.
export function readReference(document) {
  const sections = new Map();
  let [heading, section, table] = ["", null, null];
  for (const block of blocksOf(document)) {
    if (block.kind === "heading") {
      heading = block.text;
      section = sectionOfHeading.get(heading) ?? null;
      table = section;
    } else if (section !== null && block.kind === "paragraph") {
      table = tableOfParagraph(sections, section, block.text) ?? table;
    } else if (section !== null) {
      readTable(sections, {section, table: table ?? section, heading}, block);
    }
  }
  return sections;
}

/// The key of a section, which is made if it is not there.
function keyOf(sections, section, name) {
  if (!sections.has(section)) sections.set(section, new Map());
  const keys = sections.get(section);
  if (!keys.has(name)) {
    keys.set(name, {section, key: name, type: "", default: "", meaning: "", choices: [], forms: [], example: null});
  }
  return keys.get(name);
}

/// A paragraph may say which table of a deck the next table of the document describes, as "`[tests.dynamic]` has …" and
/// "`temperature_shift` is …" do, and may name keys in passing. Returns the pattern of the section, or null.
function tableOfParagraph(sections, section, text) {
  const named = /^`\[([\w.-]+)\]`/.exec(text);
  if (named !== null) return named[1].replace("NAME", "*");
  const [, key] = /^`(\w+)` (?:is|of|has)\b/.exec(text) ?? [];
  const taken = /\bforms of a Prony series take `(\w+) = ([^`]+)`/.exec(text);
  if (taken !== null && sections.has("modulus")) {
    Object.assign(keyOf(sections, "modulus", taken[1]), {meaning: plain(text), example: readExample(taken[2])});
  }
  if (section === "uncertain") codesIn(text).forEach((code) => addShape(sections, section, readExample(code)));
  if (key === undefined) return null;
  const example = codesIn(text).map((code) => new RegExp(`^${key} = (\\{.*\\})$`).exec(code)).find((one) => one !== null);
  if (example !== undefined) {
    const made = keyOf(sections, section, key);
    if (made.meaning === "") Object.assign(made, {type: "table", meaning: plain(text)});
    addShape(sections, `${section}.${key}`, readExample(example[1]));
  }
  return sections.get(section)?.has(key) ? `${section}.${key}` : null;
}

function readTable(sections, {section, table, heading}, {heads, rows}) {
  const [first] = heads.map(plain);
  const code = codesIn(heads[0])[0];
  if (heading === "Three dimensions") readCube(sections, rows);
  else if (first.startsWith("key of ")) readMeanings(sections, code === "modulus" ? code : section, rows);
  else if (code !== undefined) readChoices(sections, {section, table, key: code}, heads, rows);
  else if (first === "key") readKeys(sections, table, heads.map(plain), rows);
  else if (first === "value" || first === "form") readForms(sections, section === "uncertain" ? section : "modulus", rows);
}

/// A table of keys: | key | type | default | meaning |. A row without a key is a further choice of the row above it.
function readKeys(sections, section, heads, rows) {
  const column = (row, head) => row[heads.indexOf(head)] ?? "";
  let above = null;
  for (const row of rows) {
    const [type, meaning] = [column(row, "type"), column(row, "meaning")];
    const names = codesIn(row[0]);
    if (names.length === 0 && above !== null) addChoices(above, type, meaning);
    for (const name of names) {
      above = keyOf(sections, section, name);
      Object.assign(above, {type: plain(type), default: plain(column(row, "default")), meaning: plain(meaning)});
      addChoices(above, type, names.length === 1 && codesIn(type).length === 1 ? meaning : "");
      const mentioned = [...codesIn(type), ...codesIn(meaning)];
      for (const code of mentioned.filter((one) => one.startsWith("{"))) {
        const example = readExample(code);
        addShape(sections, `${section}.${name}${type.startsWith("a table for each") ? ".*" : ""}`,
          type.startsWith("a table for each") ? example?.table?.values().next().value : example);
        if (codesIn(type).includes(code) && example !== null) above.forms.push({example, meaning: ""});
      }
      for (const key of namedInPassing(type, meaning)) {
        const child = keyOf(sections, `${section}.${name}${type.startsWith("a table for each") ? ".*" : ""}`, key);
        if (child.meaning === "") child.meaning = sentencesWith(meaning, key);
      }
    }
  }
}

/// A table of what keys mean in a few words that the tables above name in passing: | key of `filler` | meaning |. A key
/// may be that of a table within, `sizes.diameter`. What is said elsewhere stands behind these words.
function readMeanings(sections, section, rows) {
  for (const [cell, meaning] of rows) {
    for (const path of codesIn(cell).map((code) => code.split("."))) {
      const key = keyOf(sections, [section, ...path.slice(0, -1)].join("."), path.at(-1));
      const elsewhere = key.meaning.charAt(0).toUpperCase() + key.meaning.slice(1);
      key.meaning = [plain(meaning), elsewhere].filter((text) => text !== "").join(". ");
    }
  }
}

/// Keys of a table that the row of the table itself names: "`layers`, from 1 to 16, …", "with `angle`", "also `lowest`,
/// … and `depth`", "the `material` of each `value`", "`shear`, `bulk` or both".
function namedInPassing(type, meaning) {
  const patterns = [[type, /with `(\w+)`/g]];
  if (type.includes("table")) {
    patterns.push([meaning, /`(\w+)`(?=, from \d)/g], [meaning, /also `(\w+)`/g], [meaning, /and `(\w+)`$/g],
      [meaning, /the `(\w+)` of each `(\w+)`/g], [meaning, /`(\w+)`, `(\w+)` or both/g]);
  }
  return patterns.flatMap(([text, pattern]) => [...text.matchAll(pattern)].flatMap((match) => match.slice(1)));
}

/// Adds the words in quotes of a cell as choices of a key: `"open"`, `"sealed"` or `true`.
function addChoices(key, cell, meaning) {
  for (const code of codesIn(cell)) {
    if (/^"[A-Za-z0-9][\w-]*"$/.test(code) && !/^"\d+(-\d+)+"$/.test(code)) addChoice(key, code, plain(meaning));
  }
}

function addChoice(key, source, meaning) {
  if (!key.choices.some((one) => one.source === source)) key.choices.push({source, meaning, keys: []});
}

/// A table of the values of one key, whose name is its first head. Those with further keys name them in the second
/// column: keys of the same table (`method` of a packing) or of the table that the value begins (`law`).
function readChoices(sections, {section, table, key: name}, heads, rows) {
  const isLaw = name === "law";
  const ofTable = isLaw ? "modulus" : name === "symmetry" ? `${section}.stiffness`
    : name === "orientations" ? "stages.*.filler" : table.endsWith(`.${name}`) ? section : table;
  const key = keyOf(sections, ofTable, name);
  let keysAbove = [];
  for (const row of rows) {
    const meaning = plain(row.at(-1));
    const further = row.length === 3 ? furtherKeys(row[1]) : name === "symmetry" ? codesIn(row[1]) : [];
    const names = /^(the same|those)/.test(plain(row[1])) ? [...new Set([...keysAbove, ...further])] : further;
    keysAbove = names;
    for (const code of codesIn(row[0])) {
      const example = readExample(code);
      if (/^"[\w-]+"$/.test(code)) {
        addChoice(key, code, meaning);
        key.choices.find((one) => one.source === code).keys = names;
      } else if (example !== null) {
        const found = key.forms.find((one) => firstKey(one.example) === firstKey(example));
        if (found === undefined) key.forms.push({example, meaning});
        else found.meaning ||= meaning;
      }
      addShape(sections, `${ofTable}.${name}`, example);
    }
    if (key.forms.length > 0) addMentioned(sections, `${ofTable}.${name}`, row.at(-1));
    for (const one of names) {
      const further = keyOf(sections, ofTable, one);
      if (further.meaning === "") further.meaning = isLaw || name === "symmetry" ? "" : sentencesWith(row.at(-1), one);
      for (const source of valuesOf(row.at(-1), one)) addChoice(further, source, "");
    }
  }
}

/// The keys that a cell names: "`walls`, `seed` (`1`) or `sites`", "`particles` (or `discs`)".
function furtherKeys(cell) {
  const named = cell.replace(/\((?!or )[^)]*\)/g, "");
  return codesIn(named).filter((code) => /^[A-Za-z]\w*$/.test(code));
}

/// Examples of values of a key in a text: `walls = false`, `walls = "cut"`.
function valuesOf(markdown, key) {
  return codesIn(markdown).map((code) => new RegExp(`^${key} = (true|false|"[a-z-]+")$`).exec(code)?.[1])
    .filter((source) => source !== undefined);
}

/// The forms of a modulus, or of an uncertain number.
function readForms(sections, section, rows) {
  for (const [cell, meaning] of rows) {
    for (const code of codesIn(cell)) {
      const example = readExample(code);
      if (example === null) continue;
      addShape(sections, section, example);
      const forms = formsOf(sections, section);
      if (!forms.some((one) => firstKey(one.example) === firstKey(example))) forms.push({example, meaning: plain(meaning)});
    }
    addMentioned(sections, section, meaning);
  }
}

/// Adds keys that a meaning names with a value: "need `reference_temperature = "19 degC"`".
function addMentioned(sections, section, markdown) {
  for (const code of codesIn(markdown)) {
    const [, name, value] = /^(\w+) = (\[.*\]|"[^"]*"|[\w.]+)$/.exec(code) ?? [];
    const belongs = new RegExp(`(with|need|;) \`${name} = |\`${name} = [^\`]+\` gives`).test(markdown);
    if (name === undefined || !belongs) continue;
    const key = keyOf(sections, section, name);
    if (key.meaning === "") Object.assign(key, {meaning: sentencesWith(markdown, name), example: readExample(value)});
  }
}

/// The keys that differ in a cube: some are new there, such as the lattices of a packing.
function readCube(sections, rows) {
  for (const [cell, meaning] of rows) {
    for (const [, parent, name] of cell.matchAll(/`(packing)\.(\w+)`/g)) {
      const key = keyOf(sections, `stages.*.${parent}`, name);
      key.meaning = [key.meaning, `In three dimensions: ${plain(meaning)}`].filter((text) => text !== "").join(" ");
      if (name === "lattice") addChoices(key, meaning, "");
    }
  }
}

/// Adds the keys of an example, with those of the tables in it, to a section.
function addShape(sections, section, example) {
  if (!example?.table) return;
  for (const [name, value] of example.table) {
    const key = keyOf(sections, section, name);
    key.example ??= value;
    addShape(sections, `${section}.${name}`, value);
    value.items?.forEach((item) => addShape(sections, `${section}.${name}`, item));
  }
}

function sentencesWith(markdown, name) {
  const sentences = markdown.split(/(?<=[.;])\s+(?=[A-Z`"])/);
  return plain(sentences.filter((one) => one.includes(`\`${name}\``) || one.includes(`\`${name} = `)).join(" "));
}
