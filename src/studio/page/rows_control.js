/// A small table of numbers, such as the terms of a Prony series or a sieve analysis.

import {element} from "../../page/scripts/elements.js";
import {showTyped, whenTyped} from "./controls.js";
import {labelOf} from "./form_labels.js";
import {keySource, sourceOf, sourceOfTyped, typedOf} from "./toml_source.js";

/// The control of an array of small tables: a column for each key, a row for each table.
export function rowsControl({path, label, context}) {
  const head = element("tr", {});
  const body = element("tbody", {});
  const table = element("table", {ariaLabel: label}, element("thead", {}, head), body);
  const add = element("button", {type: "button", className: "quiet"}, "Add a row");
  add.dataset.focus = JSON.stringify([...path, "add"]);
  const whole = element("div", {className: "rows-table"}, table, add);
  let [shape, items] = ["", []];
  add.addEventListener("click", () => {
    context.focusAfterwards([...path, items.length]);
    context.edit([...path, items.length], sourceOf(items.at(-1)));
  });
  return {element: whole, input: null, update(node) {
    items = node.items;
    const keys = [...new Set(items.flatMap(({entries}) => entries.map(({key}) => key)))];
    const newShape = JSON.stringify([keys, items.length]);
    if (shape !== newShape) {
      shape = newShape;
      head.replaceChildren(...keys.map((key) => element("th", {scope: "col"}, labelOf(key))), element("td", {}));
      body.replaceChildren(...items.map((_, i) => rowOf(i, keys)));
    }
    items.forEach((item, i) => keys.forEach((key, j) => {
      const input = body.rows[i].cells[j].firstChild;
      const value = item.entries.find((one) => one.key === key)?.value;
      const typed = value === undefined ? "" : typedOf(value);
      showTyped({input, typed, path: [...path, i, key], context});
    }));
  }};

  function rowOf(i, keys) {
    const inputs = keys.map((key) => {
      const input = element("input", {type: "text", spellcheck: false, ariaLabel: `${labelOf(key)}, row ${i + 1}`});
      input.dataset.focus = JSON.stringify([...path, i, key]);
      whenTyped(input, (typed) => {
        const value = items[i]?.entries.find((one) => one.key === key)?.value;
        if (typed.trim() === "") return context.edit([...path, i, key], null);
        const source = sourceOfTyped(typed, {wasText: value?.type === "text"});
        return value === undefined && keySource(key) !== key ? null : context.edit([...path, i, key], source);
      });
      return element("td", {}, input);
    });
    const remove = element("button", {type: "button", className: "remove", ariaLabel: `remove row ${i + 1}`,
      title: "remove this row", onclick: () => context.remove([...path, i])}, "×");
    const row = element("tr", {}, ...inputs, element("td", {}, remove));
    row.dataset.path = JSON.stringify([...path, i]);
    return row;
  }
}
