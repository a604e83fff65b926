/// The controls of single values. Each is made by a function of {path, label, commit(source), context} and has an
/// `element`, an `input` to which the label belongs, and `update(node, key)`.

import {element} from "../../page/scripts/elements.js";
import {changesOfChoice, filesOfChoice, whyNotChoice} from "./choice_changes.js";
import {materialNames, nameOf, stagesOf} from "./deck_tree.js";
import {fileQuestion} from "./file_question.js";
import {filesFor} from "./starting_values.js";
import {quoted, sourceOf, sourceOfList, sourceOfTyped, typedOf} from "./toml_source.js";
import {dropTarget} from "./upload.js";

const pauseOfTyping = 600;

/// Listens to what is typed into an input: `take(text)` is called after a pause, and at once when the input is left.
export function whenTyped(input, take) {
  let [timer, taken] = [0, null];
  const now = () => {
    clearTimeout(timer);
    if (input.value === taken) return;
    taken = input.value;
    take(input.value);
  };
  input.addEventListener("focus", () => { taken = input.value; });
  input.addEventListener("input", () => {
    clearTimeout(timer);
    timer = setTimeout(now, pauseOfTyping);
  });
  input.addEventListener("change", now);
}

/// Shows the value of the deck in an input, unless something else was typed there that the deck does not have yet.
export function showTyped({input, typed, path, context, complain = () => {}}) {
  const isKept = document.activeElement === input || context.deck.keepsTyped(path);
  if (isKept || input.value === typed) return;
  input.value = typed;
  complain(null);
}

/// A field into which a value is typed: text, numbers, quantities with their unit, and arrays as TOML.
export function typedControl({path, commit, complain, context}) {
  const input = element("input", {type: "text", spellcheck: false, autocomplete: "off"});
  input.dataset.focus = JSON.stringify(path);
  let [node, key] = [null, null];
  whenTyped(input, (typed) => {
    if (typed.trim() === "") return complain("a value is missing; the cross removes the key");
    complain(null);
    const isList = /increasing|array|as many numbers|pairs/.test(key?.type ?? "") || node?.type === "array";
    const isOneOfThem = !typed.includes(",") && (/integer|word|"/.test(key?.type ?? "") || node?.type !== "array");
    if (isList && !isOneOfThem) return commit(sourceOfList(typed));
    const takesNumber = /number|integer|^2 or 3$/.test(key?.type ?? "") || isNamedNumber(key);
    const wasText = node?.type === "text" && !takesNumber;
    return commit(sourceOfTyped(typed, {isText: key?.type === "text", wasText}));
  });
  return {element: input, input, update(newNode, newKey) {
    [node, key] = [newNode, newKey];
    const typed = typedOf(node);
    showTyped({input, typed, path, context, complain});
    input.inputMode = ["integer", "number"].includes(node.type) ? "decimal" : "text";
    input.classList.toggle("wide", typed.length > 17);
  }};
}

/// The two ends of a range, such as the first and the last time.
export function pairControl({path, label, commit, complain, context}) {
  const inputs = ["from", "to"].map((end, i) => element("input", {type: "text", spellcheck: false, autocomplete: "off",
    ariaLabel: i === 0 ? "" : `${label}, ${end}`}));
  inputs[0].removeAttribute("aria-label");
  inputs.forEach((input, i) => {
    input.dataset.focus = JSON.stringify(i === 0 ? path : [...path, i]);
    whenTyped(input, () => {
      if (inputs.some(({value}) => value.trim() === "")) return complain("both ends are needed");
      complain(null);
      return commit(`[${inputs.map(({value}) => sourceOfTyped(value)).join(", ")}]`);
    });
  });
  const whole = element("div", {className: "pair"}, inputs[0], element("span", {className: "note"}, "to"), inputs[1]);
  return {element: whole, input: inputs[0], update(node) {
    inputs.forEach((input, i) => showTyped({input, typed: typedOf(node.items[i]), path, context, complain}));
  }};
}

/// Values for which a number and a word or a share may stand: "otsu" or 115.
function isNamedNumber(key) {
  return ["threshold", "fraction", "debonded", "accuracy", "smooth"].includes(key?.key);
}

/// A box to tick.
export function checkControl({path, commit}) {
  const input = element("input", {type: "checkbox", onchange: () => commit(String(input.checked))});
  input.dataset.focus = JSON.stringify(path);
  return {element: input, input, update: (node) => { input.checked = node.value; }};
}

/// A list to choose from: words of the reference, names of materials and stages, files. A value that is not in the list
/// is added to it. `optionsOf` lists [source, text, why it cannot be chosen].
export function choiceControl({path, commit, context}, optionsOf) {
  const input = element("select", {onchange: () => commit(input.value)});
  input.dataset.focus = JSON.stringify(path);
  let shown = "";
  return {element: input, input, update(node, key) {
    const source = sourceOf(node);
    const options = optionsOf(key, context, path);
    const all = options.some(([value]) => value === source) ? options : [...options, [source, typedOf(node)]];
    const state = JSON.stringify([all, source]);
    if (state === shown) return;
    shown = state;
    input.replaceChildren(...all.map(([value, text, whyNot = ""]) => element("option",
      {value, disabled: whyNot !== "" && value !== source}, whyNot === "" ? text : `${text} (${whyNot})`)));
    input.value = source;
  }};
}

/// The words that a key may be.
function wordsOf(key, {deck}, path) {
  return key.choices.map(({source}) => [source, source.replaceAll('"', ""), whyNotChoice(deck.tree, path, source)]);
}

/// A list of words to choose from, with what a word asks for besides; of one that needs a file the file is asked for
/// first.
export function wordControl(options) {
  const {path, context} = options;
  const question = fileQuestion(context);
  const change = (source, file) => context.change(changesOfChoice(context.reference, context.deck.tree, path, source, file), path);
  let node = null;
  const list = choiceControl({...options, commit: (source) => {
    const files = filesOfChoice(context.reference, context.deck.tree, path, source, context.folder);
    if (files === null) return change(source, null);
    list.input.value = sourceOf(node);
    return question.ask({files, take: (file) => change(source, file)});
  }}, wordsOf);
  const whole = element("div", {className: "form-choice"}, list.element, question.element);
  return {element: whole, input: list.input, update(newNode, key) {
    node = newNode;
    list.update(newNode, key);
  }};
}

/// The names that `material`, `matrix` and `stage` may be.
export function namesFor(key, {deck}, path) {
  const stages = stagesOf(deck.tree).map((stage, i) => nameOf(stage, String(i)));
  if (key.key === "stage") return stages.map((name) => [quoted(name), name]);
  const earlier = key.key === "matrix" ? stages.slice(0, path[1]) : [];
  const voids = /void/.test(key.type) ? [['"void"', "void: no material"]] : [];
  return [...materialNames(deck.tree).map((name) => [quoted(name), name]),
    ...earlier.map((name) => [quoted(name), `${name} (an earlier stage)`]), ...voids];
}

/// A file of the folder, or one that is dropped here.
export function fileControl(options) {
  const list = choiceControl(options, (key, context) => filesFor(key, context.folder).map((name) => [quoted(name), name]));
  const target = dropTarget({label: "or drop a file here", context: options.context,
    taken: (name) => options.commit(quoted(name))});
  return {element: element("div", {className: "file-choice"}, list.element, target), input: list.input, update: list.update};
}

/// Several words of a list, such as the loads of the tests, as switches.
export function manyControl({path, label, commit}) {
  const set = element("div", {className: "switches", role: "group", ariaLabel: label});
  let shown = "";
  return {element: set, input: null, update(node, key) {
    const chosen = (node.type === "array" ? node.items : [node]).map(sourceOf);
    const sources = [...new Set([...key.choices.map(({source}) => source), ...chosen])];
    if (shown !== JSON.stringify(sources)) {
      shown = JSON.stringify(sources);
      set.replaceChildren(...sources.map((source) => {
        const box = element("input", {type: "checkbox", value: source, onchange: () => {
          const all = [...set.querySelectorAll("input")].filter((one) => one.checked).map((one) => one.value);
          if (all.length > 0) commit(`[${all.join(", ")}]`);
          else box.checked = true;
        }});
        box.dataset.focus = JSON.stringify([...path, source]);
        return element("label", {className: "chip"}, box, element("span", {}, source.replaceAll('"', "")));
      }));
    }
    for (const box of set.querySelectorAll("input")) box.checked = chosen.includes(box.value);
  }};
}
