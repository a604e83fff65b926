/// The line below a table of the form with which keys are added that the deck lacks.

import {element} from "../../page/scripts/elements.js";
import {goesWith} from "./choice_changes.js";
import {entry, nodeAt} from "./deck_tree.js";
import {fileQuestion} from "./file_question.js";
import {hasForm, labelOf} from "./form_labels.js";
import {excludes} from "./key_conflicts.js";
import {describe, isModulus, sectionOf} from "./key_reference.js";
import {firstSentence} from "./markdown.js";
import {pictureSize} from "./picture_size.js";
import {filesFor, isFile, startingValue} from "./starting_values.js";

let count = 0;

/// A list of keys with a button. `except` names keys that have buttons of their own.
export function addKey({path, except, context}) {
  const id = `add-${++count}`;
  const list = element("select", {id});
  list.dataset.focus = JSON.stringify([...path, "add"]);
  const question = fileQuestion(context);
  const button = element("button", {type: "button", className: "quiet", onclick: () => {
    const key = keys.find((one) => one.key === list.value);
    if (key === undefined) return;
    const write = async (file) => {
      const {tree} = context.deck;
      const picture = key.key === "crop" ? await pictureSize(entry(nodeAt(tree, path), "file")?.value ?? "") : null;
      context.focusAfterwards([...path, key.key]);
      context.edit([...path, key.key], startingValue(context.reference, key, {tree, path, file, picture}));
    };
    if (isFile(key)) question.ask({files: filesFor(key, context.folder), take: write});
    else write(null);
  }}, "Add");
  const line = element("div", {className: "add"}, element("label", {htmlFor: id}, titleOf(path)), list, button,
    question.element);
  let [keys, shown] = [[], ""];
  return {element: line, update({node}) {
    keys = offeredKeys(context.reference, context.deck.tree, path, node).filter(({key}) => !except.includes(key));
    line.hidden = keys.length === 0;
    const state = keys.map(({key}) => key).join(" ");
    if (state === shown) return;
    shown = state;
    list.replaceChildren(...keys.map((key) => {
      const short = firstSentence(key.meaning);
      return element("option", {value: key.key}, short === "" ? key.key : `${key.key} – ${short.slice(0, 70)}`);
    }));
  }};
}

function titleOf(path) {
  if (path.length === 0) return "Add to the study";
  const name = path.findLast((part) => typeof part === "string");
  return `Add to ${name === "stages" ? "the stage" : name === "measurements" ? "it" : labelOf(name)}`;
}

/// The keys that can be added to the table at a path of a deck, as the reference and the rest of the deck have it.
export function offeredKeys(reference, tree, path, node) {
  const forms = path.length === 0 ? [] : describe(reference, path)?.forms ?? [];
  return missingKeys(reference, sectionOf(reference, path), node)
    .filter((key) => suitsForm(forms, node, key.key) && suitsWords(reference, path, node, key) && !excludes(tree, path, key.key));
}

/// Whether a key goes with the words that other keys of the table have, such as `law = "wlf"`.
function suitsWords(reference, path, node, key) {
  const decisive = path[0] === "tests" ? [] : node.entries.map((one) => [describe(reference, [...path, one.key]), one.value]);
  return decisive.filter(([known]) => known !== null && known.section === key.section).every(([{choices}, {value}]) => {
    const chosen = choices.find(({source}) => source === `"${value}"`);
    return chosen === undefined || goesWith(key, chosen, choices);
  });
}

/// The keys that a table can have besides those that it has; of a packing, or of a law, those that belong to it.
function missingKeys(reference, section, node) {
  const keys = section === null ? [] : [...reference.get(section).values()];
  const has = new Set(node.entries.map(({key}) => key));
  const missing = keys.filter(({key}) => !has.has(key));
  const kept = section === "modulus" ? missing.filter(({key}) => belongsToForm(reference, node, key)) : missing;
  const decisive = keys.find(({key, choices}) => has.has(key) && choices.some((choice) => choice.keys.length > 0));
  if (decisive === undefined || isModulus(decisive)) return kept;
  const value = node.entries.find(({key}) => key === decisive.key).value.value;
  const chosen = decisive.choices.find(({source}) => source === `"${value}"`);
  const ofOthers = new Set(decisive.choices.flatMap((choice) => choice.keys));
  const ofChosen = new Set([...chosen?.keys ?? [], ...value === "regular" ? ["lattice", "repeats"] : []]);
  if (value === "random") ["walls", "seed"].forEach((key) => ofChosen.add(key));
  return kept.filter(({key}) => ofChosen.has(key) || (!ofOthers.has(key) && decisive.key !== "method"));
}

/// Whether a key goes with the form that a value has, such as `counts` with a list of sizes.
function suitsForm(forms, node, key) {
  const form = forms.find((one) => one.example.table !== null && hasForm(node, one));
  if (form === undefined) return true;
  if (form.example.table.has(key)) return true;
  const isOfOther = forms.some(({example, meaning}) => example.table?.has(key) || new RegExp(`\\b${key} =`).test(meaning));
  return !isOfOther || new RegExp(`\\b${key} =`).test(form.meaning);
}

function belongsToForm(reference, node, key) {
  const has = (name) => node.entries.some((one) => one.key === name);
  if (has("measured")) return key === "reference_temperature";
  if (has("prony") || has("terms")) return key === "equilibrium";
  const law = node.entries.find((one) => one.key === "law")?.value.value;
  const choice = reference.get("modulus").get("law").choices.find(({source}) => source === `"${law}"`);
  return choice?.keys.includes(key) ?? false;
}
