/// A measured file for a material: it is fitted, what was understood is shown, and the deck can use it.

import {element} from "../../page/scripts/elements.js";
import * as api from "./api.js";
import {commandLine} from "./command_line.js";
import {entry} from "./deck_tree.js";
import {columnsOf, entriesOfFit, kindOfFit} from "./measured_source.js";
import {dropTarget} from "./upload.js";

const kinds = [["", "as the file says"], ["shear", "shear modulus"], ["young", "Young's modulus"],
  ["bulk", "bulk modulus"]];
const moduli = ["shear", "young", "bulk"];
let count = 0;

/// The panel of a material.
export function fitPanel({material, context}) {
  const id = `fit-${++count}`;
  const file = element("select", {id: `${id}-file`, onchange: () => fit()});
  const kind = element("select", {id: `${id}-kind`}, ...kinds.map(([value, text]) => element("option", {value}, text)));
  const reference = element("input", {type: "text", id: `${id}-reference`, placeholder: "of one sweep", spellcheck: false});
  const columns = element("textarea", {id: `${id}-columns`, rows: 2, spellcheck: false, placeholder: "storage=E1 [MPa]"});
  const line = commandLine();
  const output = element("pre", {hidden: true});
  const state = element("p", {className: "note", role: "status"});
  const frame = element("iframe", {title: `fit for ${material}`, hidden: true});
  frame.setAttribute("sandbox", "allow-scripts allow-downloads allow-popups");
  const page = element("details", {hidden: true}, element("summary", {}, "curves of the fit"), frame);
  const again = element("button", {type: "button", onclick: () => fit()}, "Fit");
  const use = moduli.map((key) => element("button", {type: "button", onclick: () => take(key)},
    `Use it as ${key} of ${material}`));
  const buttons = element("div", {className: "buttons", hidden: true}, ...use, element("span", {className: "note"},
    "The other modulus of the material stays: check that it belongs to it."));
  const field = (label, input) => element("div", {}, element("label", {htmlFor: input.id}, label), input);
  const options = element("div", {className: "fit-options"}, field("modulus", kind), field("reference temperature", reference),
    field("columns, one a line", columns), again);
  const target = dropTarget({label: "or drop a file here, or click to choose one", context, taken: (name) => {
    showFiles();
    file.value = name;
    fit();
  }});
  const body = element("div", {},
    element("div", {className: "fit-file"}, field("file", file), target),
    options, state, output, page, buttons, line.element);
  const panel = element("details", {className: "fit"}, element("summary", {}, "from a measured file"), body);
  // What was fitted is used, not what is chosen since.
  for (const option of [kind, reference, columns]) option.addEventListener("input", () => { buttons.hidden = true; });
  page.addEventListener("toggle", () => { frame.hidden = !page.open; });
  let [shownFiles, call, fitted] = ["", 0, null];

  function showFiles() {
    const names = context.folder.tables;
    if (shownFiles === names.join("\n")) return;
    shownFiles = names.join("\n");
    const chosen = file.value;
    file.replaceChildren(element("option", {value: ""}, names.length === 0 ? "no tables in the folder" : "choose …"),
      ...names.map((name) => element("option", {value: name}, name)));
    file.value = names.includes(chosen) ? chosen : "";
  }

  const chosenOptions = () => ({
    ...kind.value === "" ? {} : {modulus: kind.value},
    ...reference.value.trim() === "" ? {} : {reference_temperature: reference.value.trim()},
    ...columns.value.trim() === "" ? {} : {columns: columnsOf(columns.value)},
  });

  async function fit() {
    buttons.hidden = true;
    if (file.value === "") return;
    const number = ++call;
    const asked = {file: file.value, options: chosenOptions()};
    state.textContent = `fitting ${file.value} …`;
    line.show("");
    try {
      const answer = await api.fit(asked.file, asked.options);
      if (number === call) show({...answer, ...asked});
    } catch (error) {
      if (number !== call) return;
      // Another window may have fitted the same file meanwhile.
      if (error.status === 409) setTimeout(() => number === call && fit(), 1000);
      else state.textContent = error.message;
    }
  }

  function show(answer) {
    const {command, exit, output: words, page: address, failure} = answer;
    fitted = answer;
    context.showCommand(command, "the fit");
    line.show(command);
    state.textContent = exit === 0 ? "Does it say what the file has? If not, correct modulus, temperature or columns above."
      : `${failure || "It was not understood"}. The options above say what the file does not.`;
    output.textContent = words;
    output.hidden = false;
    buttons.hidden = exit !== 0;
    page.hidden = address === null || address === undefined;
    if (!page.hidden) frame.src = `${address}?${call}`;
    // The kind that was recognised comes first, since the deck refuses the others.
    const likely = kind.value || kindOfFit(words) || "shear";
    use.forEach((button, i) => button.classList.toggle("main", moduli[i] === likely));
  }

  function take(key) {
    const entries = entriesOfFit(key, fitted.file, fitted.options, fitted);
    const table = entry(entry(context.deck.tree, "materials"), material);
    // Two of the moduli define a material: the other one of G and E gives way.
    const other = {shear: "young", young: "shear"}[key];
    if (entry(table, other) !== undefined) entries.push([other, null]);
    context.focusAfterwards(["materials", material, key, "form"]);
    context.change(entries.map(([name, value]) => ({path: ["materials", material, name], value})));
  }

  return {element: panel, update: showFiles};
}
