/// Tables, and the text of the deck.

import {element} from "./elements.js";

/// A table, from its column heads and its rows of texts. Columns of numbers are aligned right, long texts may wrap.
export function table(heads, rows) {
  const isNumber = heads.map((_, i) => rows.every((row) => /^[-−–<]?[\d.]|^$|^–$|^∞/.test(row[i])));
  const kind = (i, text) => ({className: isNumber[i] ? "number" : text.length > 40 ? "long" : ""});
  const head = element("tr", {}, ...heads.map((text, i) => element("th", kind(i, ""), text)));
  const body = rows.map((row) => element("tr", {}, ...row.map((text, i) => element("td", kind(i, text), text))));
  return element("div", {className: "table"}, element("table", {}, element("thead", {}, head),
    element("tbody", {}, ...body)));
}

/// Shows the deck of a run or a sweep, given its study.json or sweep.json.
export function showDeck({overrides, deck_text}) {
  const place = document.getElementById("deck-text");
  if (overrides.length > 0) {
    place.append(element("p", {}, "With these values in place of those of the deck:"), element("pre", {}, overrides.join("\n")));
  }
  place.append(element("pre", {}, deck_text));
}
