/// The text of the deck with the numbers of its lines, as it can be typed; lines with mistakes are marked.

import {element} from "../../page/scripts/elements.js";

/// The pane. `typed(text)` is called with every text that is typed.
export function textPane(typed) {
  const numbers = element("div", {className: "line-numbers", ariaHidden: "true"});
  const area = element("textarea", {spellcheck: false, wrap: "off", id: "deck-text", ariaLabel: "text of the deck, TOML"});
  let lineEnd = "\n";   // of the deck; a text area has none but this
  area.addEventListener("input", () => typed(area.value.replaceAll("\n", lineEnd)));
  area.addEventListener("scroll", () => { numbers.scrollTop = area.scrollTop; });
  let [shown, mistakes] = ["", []];
  function number() {
    const count = area.value.split("\n").length;
    const lines = new Map(mistakes.map(({line, message}) => [line, message]));
    const state = `${count} ${[...lines.keys()]}`;
    if (state === shown) return;
    shown = state;
    numbers.replaceChildren(...Array.from({length: count}, (_, i) => element("div",
      lines.has(i + 1) ? {className: "wrong", title: lines.get(i + 1)} : {}, String(i + 1))));
  }
  return {
    element: element("div", {className: "text-pane"}, numbers, area),
    /// Shows a text; the caret stays at its place.
    show(deckText, newMistakes) {
      mistakes = newMistakes;
      lineEnd = deckText.includes("\r\n") ? "\r\n" : "\n";
      const text = deckText.replaceAll("\r\n", "\n");
      if (area.value !== text) {
        const [start, end, top] = [area.selectionStart, area.selectionEnd, area.scrollTop];
        area.value = text;
        area.setSelectionRange(start, end);
        area.scrollTop = top;
      }
      number();
      numbers.scrollTop = area.scrollTop;
    },
    /// Puts the caret at the beginning of a line.
    goTo(line) {
      const lines = area.value.split("\n");
      const at = lines.slice(0, line - 1).reduce((sum, one) => sum + one.length + 1, 0);
      area.focus();
      area.setSelectionRange(at, at + (lines[line - 1]?.length ?? 0));
      area.scrollTop = Math.max(0, (line - 6) * area.scrollHeight / Math.max(lines.length, 1));
    },
  };
}
