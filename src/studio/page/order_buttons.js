/// Buttons by which a material or a stage changes places with the one before or behind it.

import {element} from "../../page/scripts/elements.js";
import {entry, materialNames, nameOf, stagesOf} from "./deck_tree.js";

/// The buttons of what is at a path, ["materials", NAME] or ["stages", INDEX].
export function orderButtons({path, context}) {
  const [up, down] = [["up", "↑", -1], ["down", "↓", 1]].map(([word, sign, by]) => {
    const button = element("button", {type: "button", className: "order", onclick: () => move(word, by)}, sign);
    button.dataset.focus = JSON.stringify([...path, word]);
    return button;
  });
  const group = element("span", {className: "order-buttons"}, up, down);

  function move(word, by) {
    const other = neighbour(context.deck.tree, path, by);
    const moved = path[0] === "stages" ? other : path;
    context.focusAfterwards([...moved, word], [...moved, word === "up" ? "down" : "up"]);
    context.change([{path, exchange: other}]);
  }

  return {element: group, update(name) {
    const {tree} = context.deck;
    group.hidden = neighbour(tree, path, -1) === null && neighbour(tree, path, 1) === null;
    for (const [button, word, by] of [[up, "up", -1], [down, "down", 1]]) {
      const other = neighbour(tree, path, by);
      const reason = other === null || path[0] !== "stages" ? "" : whyNot(stagesOf(tree), Math.min(path[1], other[1]));
      button.disabled = other === null || reason !== "";
      button.ariaLabel = `move ${name} ${word}`;
      button.title = reason === "" ? button.ariaLabel : reason;
    }
  }};
}

/// The path of the material or the stage before (-1) or behind (1) a path, or null.
export function neighbour(tree, path, by) {
  const [table, part] = path;
  const parts = table === "stages" ? stagesOf(tree).map((_, i) => i) : materialNames(tree);
  const other = parts[parts.indexOf(part) + by];
  return other === undefined ? null : [table, other];
}

/// Why a stage cannot change places with the one behind it, or "".
export function whyNot(stages, first) {
  const matrix = entry(stages[first + 1], "matrix")?.value;
  return matrix === nameOf(stages[first], null)
    ? `${nameOf(stages[first + 1], "the later stage")} has ${matrix} as its matrix, so that it stands behind it` : "";
}
