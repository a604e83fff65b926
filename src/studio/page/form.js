/// The form of a deck: a card for each material, stage and measurement, and one for each other table.

import {element} from "../../page/scripts/elements.js";
import {entry, materialNames, nameOf, stagesOf} from "./deck_tree.js";
import {fieldsOf, nameField, showIn} from "./fields.js";
import {fitPanel} from "./fit_panel.js";
import {labelOf} from "./form_labels.js";
import {takesFiller} from "./packing_change.js";
import {keepingFocus, reconcile} from "./reconcile.js";
import {fileQuestion} from "./file_question.js";
import {orderButtons} from "./order_buttons.js";
import {dimensionsChoice, offersOfTests} from "./study_choices.js";
import {newFiller, newStage} from "./suited_values.js";
import {quoted, sourceOf} from "./toml_source.js";

/// The form. `update()` shows the tree of the deck of the context.
export function deckForm(context) {
  const cards = element("div", {className: "cards"});
  const update = () => keepingFocus(() => reconcile(cards, cardsOf(context)), context.renamedPath);
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
      {above: () => nameField(["materials", key], context), below: () => fitPanel({material: key, context}), isOrdered: true})),
    adder("add material", context, addMaterial),
    ...stagesOf(tree).map((stage, i) => card(`stage ${i}`, ["Stage", nameOf(stage, String(i + 1))], ["stages", i], stage,
      {actions: [{words: "Add another filler", act: () => addFiller(context, i), isPossible: () => takesFiller(context.deck.tree, i)}],
        isOrdered: true})),
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

/// The card of a table. `above` and `below` make further parts of it, `actions` are buttons in its header: {words, act,
/// isPossible}. A card that `isOrdered` can change places with others.
function cardOf({path, context, above = null, below: makeBelow = null, actions = [], removable = true, isOrdered = false,
  except = []}) {
  const heading = element("h3", {});
  const remove = element("button", {type: "button", className: "remove", hidden: !removable,
    onclick: () => context.remove(path)}, "×");
  const complaint = element("p", {className: "mistake", hidden: true});
  const [first, below] = [above?.() ?? null, makeBelow?.() ?? null];
  const order = isOrdered ? orderButtons({path, context}) : null;
  const fields = fieldsOf({path, context, except});
  const buttons = actions.map(({words, act}) => element("button", {type: "button", className: "quiet", onclick: act}, words));
  const card = element("section", {className: `card of-${path[0] ?? "study"}`},
    element("header", {}, heading, ...buttons, ...order === null ? [] : [order.element], remove), complaint,
    ...[first, fields, below].filter((part) => part !== null).map((part) => part.element));
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
    actions.forEach(({isPossible}, i) => { buttons[i].hidden = !isPossible(); });
    first?.update(name);
    below?.update();
    order?.update(name);
    showIn(complaint, path.length === 0 ? [] : context.mistakesAt(path));
  }};
}

/// A button between the cards, with a field for the name of what is added.
function adder(id, context, add) {
  return {id, kind: "adder", value: null, make: () => ({element: add(context), update: () => {}})};
}

function nameForm(table, label, placeholder, act) {
  const input = element("input", {type: "text", ariaLabel: `name of the new ${label}`, placeholder, spellcheck: false,
    autocomplete: "off"});
  input.dataset.focus = JSON.stringify([table, "add"]);
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
  return nameForm("materials", "material", "rubber", (name) => {
    if (materialNames(context.deck.tree).includes(name)) return `there is a material ${name}`;
    context.focusAfterwards(["materials", name, "bulk"]);
    context.edit(["materials", name], '{ density = "1 g/cm^3", bulk = "3 GPa", shear = "1 GPa" }');
    return null;
  });
}

function addStage(context) {
  return nameForm("stages", "stage", "composite", (name) => {
    const stages = stagesOf(context.deck.tree);
    if (stages.some((stage, i) => nameOf(stage, String(i)) === name)) return `there is a stage ${name}`;
    context.focusAfterwards(["stages", stages.length, "matrix"]);
    context.edit(["stages", stages.length], newStage(context.deck.tree, name));
    return null;
  });
}

/// A measurement is made of a file, which is asked for first.
function addMeasurement(context) {
  const question = fileQuestion(context);
  const form = nameForm("measurements", "measurement", "our laboratory", (name) => {
    question.ask({files: context.folder.tables, take: (file) => {
      const count = entry(context.deck.tree, "measurements")?.items?.length ?? 0;
      context.focusAfterwards(["measurements", count, "name"]);
      context.edit(["measurements", count], `{ name = ${quoted(name)}, shear = { measured = ${quoted(file)} } }`);
    }});
    return null;
  });
  form.append(question.element);
  return form;
}

/// A second filler turns the table of the first one into an array.
function addFiller(context, i) {
  const path = ["stages", i, "filler"];
  const filler = entry(stagesOf(context.deck.tree)[i], "filler");
  const another = newFiller(context.deck.tree, i);
  context.focusAfterwards([...path, filler?.items?.length ?? 1], path);
  if (filler === undefined) return context.edit(path, another);
  if (filler.type === "array") return context.edit([...path, filler.items.length], another);
  return context.edit(path, `[${sourceOf(filler)}, ${another}]`);
}
