/// The reference of the keys of a deck, as reference_reader.js reads it from docs/decks.md.
///
/// Each table of a deck has a section of the reference, named by a pattern such as "materials.*" or
/// "stages.*.filler"; the forms of a modulus, which many keys take, are in "modulus", and those of a number that is
/// uncertain in "uncertain". A section is a map of its keys: {section, key, type, default, meaning, choices, forms,
/// example}, where a choice is {source, meaning, keys} and a form {example, meaning}.

import {readExample} from "./inline_table.js";

/// The first key of an example that is a table, by which it is told from the others.
export function firstKey(example) {
  return example.table?.keys().next().value ?? "";
}

const formLists = new WeakMap();

/// The forms of the values of a section that several keys share, such as those of a modulus.
export function formsOf(sections, section) {
  if (!formLists.has(sections)) formLists.set(sections, new Map());
  const lists = formLists.get(sections);
  if (!lists.has(section)) lists.set(section, []);
  return lists.get(section);
}

/// The pattern of the section that describes the table at a path of a deck, or null. Elements of arrays have that of
/// their array.
export function sectionOf(sections, path) {
  let pattern = "";
  for (const part of path) {
    if (sections.has(`${pattern}.*`)) {
      pattern = `${pattern}.*`;
      continue;
    }
    if (typeof part === "number") continue;
    const key = sections.get(pattern)?.get(part);
    if (isModulus(key)) pattern = "modulus";
    else pattern = pattern === "" ? part : `${pattern}.${part}`;
  }
  return sections.has(pattern) ? pattern : null;
}

/// Whether a key takes the forms of a modulus.
export function isModulus(key) {
  return key !== undefined && key !== null && (key.type === "modulus" || key.type.includes("in one of the forms"));
}

/// What the reference has of the key at a path, or null. A table in place of a number may be an uncertain one.
export function describe(sections, path) {
  const section = sectionOf(sections, path.slice(0, -1));
  const name = path.at(-1);
  const found = section === null ? null : sections.get(section).get(name) ?? null;
  if (found !== null) return found;
  const parent = path.length > 1 ? sectionOf(sections, path.slice(0, -2)) : null;
  const isOfNumber = parent !== null && sections.get(parent).has(path.at(-2));
  return isOfNumber ? sections.get("uncertain")?.get(name) ?? null : null;
}

/// The forms that the value of a key may have: [{example, meaning}], none where there is one alone.
export function formsOfKey(sections, key) {
  if (key === null) return [];
  const forms = isModulus(key) ? formsOf(sections, "modulus") : key.forms;
  const ofKey = isModulus(key) ? forms.filter(({example}) => key.section.startsWith("materials") ? !example.table?.has("curve")
    : ["measured", "curve", "prony", "law"].includes(firstKey(example))) : forms;
  return ofKey.flatMap((form) => form.example.table?.has("law") ? formsOfLaws(sections) : [form]);
}

function formsOfLaws(sections) {
  const laws = sections.get("modulus").get("law").choices;
  return laws.map(({source, meaning, keys}) => ({example: readExample(`{ law = ${source}, ... }`), meaning, keys}));
}
