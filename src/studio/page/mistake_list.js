/// All mistakes of the deck, each a button that goes to its field.

import {element} from "../../page/scripts/elements.js";
import {placeOf} from "./mistake_places.js";

/// The list. `goToLine(line)` is called where a mistake has no field. What was refused has the path of its field.
export function mistakeList(goToLine) {
  const items = element("ul", {});
  const heading = element("h3", {});
  const list = element("div", {className: "mistakes", role: "status", hidden: true}, heading, items);
  let shown = "";
  return {element: list, update(tree, mistakes) {
    const state = JSON.stringify(mistakes);
    if (state === shown) return;
    shown = state;
    list.hidden = mistakes.length === 0;
    heading.textContent = mistakes.length === 1 ? "One mistake in the deck" : `${mistakes.length} mistakes in the deck`;
    items.replaceChildren(...mistakes.map((mistake) => {
      const where = mistake.line > 0 ? `line ${mistake.line}: ` : "";
      return element("li", {}, element("button", {type: "button", className: "link", onclick: () => {
        if (!goToField(mistake.path ?? placeOf(tree, mistake)) && mistake.line > 0) goToLine(mistake.line);
      }}, where + mistake.message));
    }));
  }};
}

/// Puts the focus into the field at a path, or the closest one around it.
export function goToField(path) {
  for (let at = path; at !== null && at.length > 0; at = at.slice(0, -1)) {
    const place = document.querySelector(`[data-path="${CSS.escape(JSON.stringify(at))}"]`);
    if (place === null) continue;
    const input = place.querySelector(`[data-focus="${CSS.escape(JSON.stringify(path))}"]`)
      ?? place.querySelector("input, select:not(.form), button:not(.remove)") ?? place.querySelector("select, button");
    place.scrollIntoView({block: "center"});
    input?.focus({preventScroll: true});
    return true;
  }
  return false;
}
