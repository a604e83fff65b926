/// The name of a material or a stage. All places of the deck that refer to it follow.

import {element} from "../../page/scripts/elements.js";
import {showTyped} from "./controls.js";

/// The control of the name of what is at a path; the new name is taken once the field is left.
export function renameControl({path, complain, context}) {
  const input = element("input", {type: "text", spellcheck: false, autocomplete: "off"});
  input.dataset.focus = JSON.stringify(path);
  let shown = "";
  input.addEventListener("change", () => {
    const name = input.value.trim();
    complain(name === "" ? "a name is missing" : null);
    if (name !== "" && name !== shown) context.rename(path.slice(0, -1), name);
  });
  return {element: input, input, update(node) {
    shown = String(node.value ?? "");
    showTyped({input, typed: shown, path, context, complain});
  }};
}
