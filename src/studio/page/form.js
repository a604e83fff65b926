/// The form of a deck: a card for each material, stage and measurement, and one for each other table.

import {element} from "../../page/scripts/elements.js";
import {entry, materialNames, nameOf, stagesOf} from "./deck_tree.js";
import {fieldsOf, showIn} from "./fields.js";
import {fitPanel} from "./fit_panel.js";
import {labelOf} from "./form_labels.js";
import {keepingFocus, reconcile} from "./reconcile.js";
import {newFiller} from "./starting_values.js";
import {dimensionsChoice, offersOfTests} from "./study_choices.js";
import {quoted, sourceOf} from "./toml_source.js";

/// The form. `update()` shows the tree of the deck of the context.
export function deckForm(context) {
  const cards = element("div", {className: "cards"});
  const update = () => keepingFocus(() => reconcile(cards, cardsOf(context)));
  return {element: cards, update};
}

function cardsOf(context) {
  const {tree} = context.deck;
  const tables = tree.entries.filter(({value}) => isTable(value));
  const others = tables.filter(({key}) => !["materials", "stages", "tests", "measurements"].includes(key));
  const card = (id, title, path, value, options = {}) => ({
    id, kind: "card", value: {node: value, title}, make: () => cardOf({path, context, ...options}),
  });
  const materials = entry(tree, "materials")?.entries ?? [];
  const tests = entry(tree, "tests");
  return [
    card("study", "Study", [], {...tree, entries: tree.entries.filter(({key, value}) => !isTable(value) && key !== "dimensions")},
      {removable: false, below: () => dimensionsChoice(context), except: ["materials", "stages", "measurements", "dimensions"]}),
    ...materials.map(({key, value}) => card(`material ${key}`, ["Material", key], ["materials", key], value,
      {below: () => fitPanel({material: key, context})})),
    adder("add material", context, addMaterial),
    ...stagesOf(tree).map((stage, i) => card(`stage ${i}`, ["Stage", nameOf(stage, String(i + 1))], ["stages", i], stage,
      {actions: [["Add another filler", () => addFiller(context, i)]]})),
    adder("add stage", context, addStage),
    ...tests?.type === "table" ? [card("tests", "Tests", ["tests"], tests,
      {removable: false, below: () => offersOfTests(context)})] : [],
    ...(entry(tree, "measurements")?.items ?? []).map((one, i) => card(`measurement ${i}`,
      ["Measurement", nameOf(one, String(i + 1))], ["measurements", i], one)),
    adder("add measurement", context, addMeasurement),
    ...others.map(({key, value}) => card(`other ${key}`, labelOf(key), [key], value)),
  ];
}

/// Whether a value has a card of its own, in place of a field of the study.
function isTable(value) {
  return value.type === "table" || (value.type === "array" && value.items[0]?.type === "table");
}

function cardOf({path, context, below: makeBelow = null, actions = [], removable = true, except = []}) {
  const heading = element("h3", {});
  const remove = element("button", {type: "button", className: "remove", hidden: !removable,
    onclick: () => context.edit(path, null)}, "×");
  const complaint = element("p", {className: "mistake", hidden: true});
  const below = makeBelow?.() ?? null;
  const fields = fieldsOf({path, context, except});
  const buttons = actions.map(([text, act]) => element("button", {type: "button", className: "quiet", onclick: act}, text));
  const card = element("section", {className: `card of-${path[0] ?? "study"}`},
    element("header", {}, heading, ...buttons, remove), complaint, fields.element, ...below === null ? [] : [below.element]);
  card.dataset.path = JSON.stringify(path);
  let shown = "";
  return {element: card, update({node, title}) {
    const [kind, name] = Array.isArray(title) ? title : [title, null];
    if (shown !== JSON.stringify(title)) {
      shown = JSON.stringify(title);
      heading.replaceChildren(...name === null ? [kind] : [element("span", {className: "kind"}, `${kind}: `), name]);
      card.setAttribute("aria-label", name === null ? kind : `${kind} ${name}`);
      remove.ariaLabel = remove.title = `remove ${kind.toLowerCase()} ${name ?? ""}`.trim();
    }
    if (node.type === "table") fields.update(node, path.length === 0 ? context.deck.tree : node);
    below?.update();
    showIn(complaint, path.length === 0 ? [] : context.mistakesAt(path));
  }};
}

/// A button between the cards, with a field for the name of what is added.
function adder(id, context, add) {
  return {id, kind: "adder", value: null, make: () => ({element: add(context), update: () => {}})};
}

function nameForm(label, placeholder, act) {
  const input = element("input", {type: "text", ariaLabel: `name of the new ${label}`, placeholder, spellcheck: false,
    autocomplete: "off"});
  const complaint = element("span", {className: "mistake", role: "alert"});
  const form = element("form", {className: "adder", onsubmit: (event) => {
    event.preventDefault();
    const name = input.value.trim() || placeholder;
    complaint.textContent = act(name) ?? "";
    if (complaint.textContent === "") input.value = "";
  }}, input, element("button", {type: "submit", className: "quiet"}, `Add a ${label}`), complaint);
  return form;
}

function addMaterial(context) {
  return nameForm("material", "rubber", (name) => {
    if (materialNames(context.deck.tree).includes(name)) return `there is a material ${name}`;
    context.focusAfterwards(["materials", name, "bulk"]);
    context.edit(["materials", name], '{ density = "1 g/cm^3", bulk = "3 GPa", shear = "1 GPa" }');
    return null;
  });
}

function addStage(context) {
  return nameForm("stage", "composite", (name) => {
    const stages = stagesOf(context.deck.tree);
    if (stages.some((stage, i) => nameOf(stage, String(i)) === name)) return `there is a stage ${name}`;
    const names = materialNames(context.deck.tree);
    const matrix = stages.length > 0 ? nameOf(stages.at(-1), names[0]) : names[0] ?? "binder";
    context.focusAfterwards(["stages", stages.length, "matrix"]);
    context.edit(["stages", stages.length], `{ name = ${quoted(name)}, matrix = ${quoted(matrix)}, `
      + `filler = ${newFiller(names)}, packing = { method = "random", seed = 1 } }`);
    return null;
  });
}

function addMeasurement(context) {
  return nameForm("measurement", "our laboratory", (name) => {
    const count = entry(context.deck.tree, "measurements")?.items?.length ?? 0;
    const file = context.folder.tables[0] ?? "measured.csv";
    const value = `{ name = ${quoted(name)}, shear = { measured = ${quoted(file)} } }`;
    context.edit(["measurements", count], value);
    return null;
  });
}

/// A second filler turns the table of the first one into an array.
function addFiller(context, i) {
  const path = ["stages", i, "filler"];
  const filler = entry(stagesOf(context.deck.tree)[i], "filler");
  const another = newFiller(materialNames(context.deck.tree));
  if (filler === undefined) return context.edit(path, another);
  if (filler.type === "array") return context.edit([...path, filler.items.length], another);
  return context.edit(path, `[${sourceOf(filler)}, ${another}]`);
}
