/// What the choice of a word asks for in its table besides: keys of the other words go, those of the chosen one come.

import {entry, nodeAt} from "./deck_tree.js";
import {describe, sectionOf} from "./key_reference.js";
import {methodsOfFiles, packingChanges, whyNotMethod} from "./packing_change.js";
import {filesFor, isFile, startingValue} from "./starting_values.js";

/// Whether a key is that of a packing's method.
const isMethod = (path) => path[0] === "stages" && path.at(-2) === "packing" && path.at(-1) === "method";

/// Whether a key goes with one of the words of another key of its table: the reference begins its meaning with
/// 'of "wlf": …', 'with "spring": …' or 'not of "measured": …', or names it beside the word.
export function goesWith(key, choice, allChoices) {
  if (choice.keys.length > 0 || allChoices.some(({keys}) => keys.includes(key.key))) return choice.keys.includes(key.key);
  const [, not, words] = /^(not )?(?:of|with) ((?:"[\w-]+"(?: or |, )?)+):/.exec(key.meaning) ?? [];
  if (words === undefined) return true;
  return words.includes(choice.source) === (not === undefined);
}

/// The files of the folder one of which the choice of a word needs, such as an image; null if it needs none.
export function filesOfChoice(reference, tree, path, source, folder) {
  const method = source.replaceAll('"', "");
  if (isMethod(path)) return methodsOfFiles.includes(method) ? filesOfMethod(tree, method, folder) : null;
  const missing = missingOfChoice(reference, tree, path, source).find((key) => isFile(key));
  return missing === undefined ? null : filesFor(missing, folder);
}

/// A PNG is one picture, no stack of them, which a cube takes.
function filesOfMethod(tree, method, {tables, pictures}) {
  if (method !== "image") return tables;
  return entry(tree, "dimensions")?.value === 3 ? pictures.filter((name) => !/\.png$/i.test(name)) : pictures;
}

/// The keys that a table lacks once one of its keys is another word: those without a default that go with the word
/// alone.
function missingOfChoice(reference, tree, path, source) {
  const key = describe(reference, path);
  const choice = key?.choices.find((one) => one.source === source);
  if (choice === undefined || key.section.startsWith("tests")) return [];
  const table = nodeAt(tree, path.slice(0, -1));
  const keys = [...reference.get(sectionOf(reference, path.slice(0, -1))).values()];
  const others = key.choices.filter((one) => one !== choice);
  return keys.filter((one) => one.key !== key.key && one.default === "" && goesWith(one, choice, key.choices)
    && others.some((other) => !goesWith(one, other, key.choices)) && entry(table, one.key) === undefined);
}

/// The changes with which the key at a path has another of its words; `file` is the name of one that the word needs.
export function changesOfChoice(reference, tree, path, source, file = null) {
  if (isMethod(path)) return packingChanges(tree, path[1], source.replaceAll('"', ""), file);
  const key = describe(reference, path);
  const choice = key?.choices.find((one) => one.source === source);
  const changes = [{path, value: source}];
  if (choice === undefined || key.section.startsWith("tests")) return changes;
  const around = path.slice(0, -1);
  const section = reference.get(sectionOf(reference, around));
  for (const {key: name} of nodeAt(tree, around).entries) {
    const known = section.get(name);
    if (name === key.key || known === undefined || goesWith(known, choice, key.choices)) continue;
    changes.push({path: [...around, name], value: null});
  }
  for (const missing of missingOfChoice(reference, tree, path, source)) {
    changes.push({path: [...around, missing.key], value: startingValue(reference, missing, {tree, path: around, file})});
  }
  return changes;
}

/// Why a word cannot be chosen, or "".
export function whyNotChoice(tree, path, source) {
  if (isMethod(path)) return whyNotMethod(tree, path[1], source.replaceAll('"', ""));
  const isLawOfData = path.at(-2) === "temperature_shift" && source === '"measured"';
  const moduli = isLawOfData ? nodeAt(tree, path.slice(0, -2)).entries : [];
  const hasData = moduli.some(({value}) => entry(value, "measured") !== undefined && entry(value, "reference_temperature"));
  return isLawOfData && !hasData ? "takes measured data at several temperatures" : "";
}
