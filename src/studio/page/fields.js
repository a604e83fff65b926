/// The fields of the form: one for each key of a table of the deck, those of tables with fields of their own.

import {element} from "../../page/scripts/elements.js";
import {addKey} from "./add_key.js";
import {checkControl, choiceControl, fileControl, manyControl, namesFor, pairControl, typedControl, wordControl}
  from "./controls.js";
import {controlKind, ordered} from "./control_kind.js";
import {nodeAt} from "./deck_tree.js";
import {fileQuestion} from "./file_question.js";
import {changesOfForm, whyNotForm} from "./form_changes.js";
import {hasForm, labelOf, labelOfForm} from "./form_labels.js";
import {helpLine} from "./help_line.js";
import {describe, formsOfKey, sectionOf} from "./key_reference.js";
import {reconcile} from "./reconcile.js";
import {rowsControl} from "./rows_control.js";
import {renameControl} from "./rename_control.js";
import {isFileForm} from "./starting_values.js";
import {newFiller} from "./suited_values.js";

let count = 0;

/// The fields of a table, with a list of keys that it lacks but for those of `except`. `update(node)` takes the table;
/// `whole` has all keys of it where `node` has some alone.
export function fieldsOf({path, context, except = []}) {
  const fields = element("div", {className: "fields"});
  const adding = addKey({path, except, context});
  return {element: element("div", {className: "table-of-fields"}, fields, adding.element), update(node, whole = node) {
    const section = sectionOf(context.reference, path);
    const entries = ordered(node.entries, section);
    reconcile(fields, entries.map(({key: name, value: child}) => {
      const at = [...path, name];
      const key = describe(context.reference, at);
      const kind = controlKind(child, key);
      return {id: name, kind, make: () => fieldOf(kind, {path: at, name, context}), value: {node: child, key}};
    }));
    adding.update({node: whole});
  }};
}

function fieldOf(kind, options) {
  if (kind === "group") return groupField(options);
  return kind === "list" ? listField(options) : singleField(kind, options);
}

/// The name of the material at a path, which is no value of its table but the key of it.
export function nameField(path, context) {
  const field = singleField("rename", {path: [...path, "name"], name: "name", context});
  const key = {section: "materials.*", key: "name", type: "", default: "", meaning: "a new one is written wherever the deck refers to it",
    choices: [], forms: [], example: null};
  return {element: field.element, update: (name) => field.update({node: {type: "text", value: name}, key})};
}

/// A value with its label, its help and its mistakes.
function singleField(kind, {path, name, context}) {
  const label = labelOf(name);
  const complaint = element("p", {className: "mistake", id: `mistake-${++count}`, hidden: true});
  let own = null;
  const complain = (text) => {
    own = text;
    showMistakes();
  };
  const commit = (source) => context.edit(path, source);
  const control = controlOf(kind, {path, label, commit, complain, context});
  const title = element(control.input === null ? "span" : "label", {className: "key"}, label);
  if (control.input !== null) {
    control.input.id = `field-${count}`;
    title.htmlFor = control.input.id;
  }
  const forms = formChoice({path, name, context});
  const help = element("div", {className: "help-place"});
  const value = element("div", {className: "value"}, forms.element, control.element);
  const field = element("div", {className: `field kind-${kind}`}, title, element("div", {className: "content"}, value, help),
    ...kind === "rename" ? [] : [removeButton(path, label, context)], complaint);
  field.dataset.path = JSON.stringify(path);
  function showMistakes() {
    const found = [...own === null ? [] : [own], ...context.mistakesAt(path, kind === "rows")];
    complaint.hidden = found.length === 0;
    if (complaint.textContent !== found.join("\n")) complaint.textContent = found.join("\n");
    field.classList.toggle("wrong", found.length > 0);
    if (control.input === null) return;
    control.input.setAttribute("aria-invalid", String(found.length > 0));
    if (found.length > 0) control.input.setAttribute("aria-describedby", complaint.id);
    else control.input.removeAttribute("aria-describedby");
  }
  return {element: field, update({node, key}) {
    control.update(node, key);
    forms.update(node, key);
    if (help.firstChild === null) help.append(helpLine(key));
    showMistakes();
  }};
}

function controlOf(kind, options) {
  switch (kind) {
    case "check": return checkControl(options);
    case "many": return manyControl(options);
    case "choice": return wordControl(options);
    case "name": return choiceControl(options, namesFor);
    case "file": return fileControl(options);
    case "rows": return rowsControl(options);
    case "rename": return renameControl(options);
    case "pair": return pairControl(options);
    default: return typedControl(options);
  }
}

/// A table within a table, such as `sizes`, with fields of its own.
function groupField({path, name, context, title = labelOf(name), hasHelp = true}) {
  const forms = formChoice({path, name, context});
  const help = element("div", {className: "help-place"});
  const complaint = element("p", {className: "mistake", hidden: true});
  const fields = fieldsOf({path, context});
  const heading = element("div", {className: "group-heading"}, element("span", {className: "key"}, title), forms.element,
    removeButton(path, title, context));
  const group = element("div", {className: `group of-${name}`, role: "group", ariaLabel: title}, heading, help, complaint,
    fields.element);
  group.dataset.path = JSON.stringify(path);
  return {element: group, update({node, key}) {
    forms.update(node, key);
    if (hasHelp && help.firstChild === null && key !== null) help.append(helpLine(key));
    fields.update(node);
    showIn(complaint, context.mistakesAt(path));
  }};
}

/// Tables that follow one another, such as the fillers of a stage.
function listField({path, name, context}) {
  const items = element("div", {});
  const add = element("button", {type: "button", className: "quiet", onclick: () => {
    const node = nodeAt(context.deck.tree, path);
    context.focusAfterwards([...path, node.items.length]);
    context.edit([...path, node.items.length], newFiller(context.deck.tree, path[1]));
  }}, "Add another filler");
  add.dataset.focus = JSON.stringify([...path, "add"]);
  const list = element("div", {className: "list"}, items, name === "filler" ? add : "");
  return {element: list, update({node, key}) {
    reconcile(items, node.items.map((item, i) => ({
      id: i, kind: "group", value: {node: item, key},
      make: () => groupField({path: [...path, i], name, context, title: `${labelOf(name)} ${i + 1}`, hasHelp: false}),
    })));
  }};
}

/// Which form a value has, where it may have several: one number, a series, a law. Of a form that is a file the file is
/// asked for first.
function formChoice({path, name, context}) {
  const list = element("select", {className: "form", ariaLabel: `how ${labelOf(name)} is given`});
  list.dataset.focus = JSON.stringify([...path, "form"]);
  const question = fileQuestion(context);
  const whole = element("div", {className: "form-choice"}, list, question.element);
  let [forms, ofKey, shown] = [[], null, "other"];
  list.addEventListener("change", () => {
    const form = forms[Number(list.value)];
    const write = (file) => {
      context.focusAfterwards([...path, "form"]);
      context.change(changesOfForm(context.reference, context.deck.tree, {path, key: ofKey, form, file}), path);
    };
    if (!isFileForm(form)) return write(null);
    list.value = shown;
    return question.ask({files: context.folder.tables, take: write});
  });
  return {element: whole, update(node, key) {
    if (forms.length === 0) {
      forms = formsOfKey(context.reference, key);
      ofKey = key;
      list.replaceChildren(...forms.map((form, i) => element("option", {value: String(i)}, labelOfForm(form))),
        element("option", {value: "other", hidden: true}, "otherwise"));
    }
    whole.hidden = forms.length < 2;
    forms.forEach((form, i) => {
      const reason = whyNotForm(context.deck.tree, path, form);
      list.options[i].disabled = reason !== "";
      list.options[i].title = reason;
    });
    const at = forms.findIndex((form) => hasForm(node, form));
    shown = at < 0 ? "other" : String(at);
    list.value = shown;
  }};
}

/// A small cross that removes a key or a table.
function removeButton(path, label, context) {
  return element("button", {type: "button", className: "remove", ariaLabel: `remove ${label}`, title: `remove ${label}`,
    onclick: () => context.remove(path)}, "×");
}

/// Shows messages in a paragraph, which is hidden without any.
export function showIn(paragraph, messages) {
  paragraph.hidden = messages.length === 0;
  if (paragraph.textContent !== messages.join("\n")) paragraph.textContent = messages.join("\n");
}
