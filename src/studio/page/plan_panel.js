/// What `breccia check` says of the deck: cost and errors to be expected first, then all of it.

import {element} from "../../page/scripts/elements.js";
import {withMicroSign} from "../../page/scripts/numbers.js";
import {highlights} from "./check_output.js";
import {commandLine} from "./command_line.js";

const kinds = {cost: "time and memory", grid: "grid", packing: "packing", filler: "filler", accuracy: "accuracy",
  warning: "warning"};

/// The panel. `show(CHECK)` takes an answer of the server.
export function planPanel() {
  const items = element("dl", {className: "highlights"});
  const text = element("pre", {});
  const line = commandLine();
  const details = element("details", {hidden: true}, element("summary", {}, "all of the plan"), text);
  const state = element("p", {className: "note", role: "status"}, "not yet checked");
  const panel = element("section", {className: "panel", ariaLabel: "plan"}, element("h3", {}, "Plan"), state, items, details,
    line.element);
  return {
    element: panel,
    show({command, exit, output}) {
      state.textContent = exit === 0 ? "" : "The deck has mistakes; the plan follows once they are mended.";
      state.hidden = exit === 0;
      panel.classList.toggle("old", exit !== 0);
      line.show(command);
      if (exit !== 0) return;
      items.replaceChildren(...highlights(output).flatMap(({kind, text: words}) => [
        element("dt", {className: kind}, kinds[kind]), element("dd", {className: kind}, withMicroSign(words))]));
      text.textContent = output;
      details.hidden = false;
    },
    wait() {
      panel.classList.add("old");
      state.hidden = false;
      state.textContent = "checking …";
    },
    complain(message) {
      state.hidden = false;
      state.textContent = message;
    },
  };
}
