"use strict";

/// Words in a row, tables, and the deck.

function listed(words) {
  return words.length < 2 ? words.join("") : `${words.slice(0, -1).join(", ")} and ${words.at(-1)}`;
}

/// A table; columns of numbers are set to the right, long texts may break.
function table(heads, rows) {
  const isNumber = heads.map((_, i) => rows.every((row) => /^[-−–<]?[\d.]|^$|^∞/.test(row[i])));
  const kind = (i, text) => ({className: isNumber[i] ? "number" : text.length > 40 ? "long" : ""});
  const head = element("tr", {}, ...heads.map((text, i) => element("th", kind(i, ""), text)));
  const body = rows.map((row) => element("tr", {}, ...row.map((text, i) => element("td", kind(i, text), text))));
  return element("div", {className: "table"}, element("table", {}, element("thead", {}, head),
    element("tbody", {}, ...body)));
}

/// The deck of a record, study.json or sweep.json.
function showDeck({overrides, deck_text}) {
  const place = document.getElementById("deck-text");
  if (overrides.length > 0) {
    place.append(element("p", {}, "Overridden on the command line:"), element("pre", {}, overrides.join("\n")));
  }
  place.append(element("pre", {}, deck_text));
}
