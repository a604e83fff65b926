/// The commands that do in a shell what the page has done.

import {element} from "../../page/scripts/elements.js";

/// A command with a button that copies it. `show(text)` changes it; without a text it is hidden.
export function commandLine() {
  const code = element("code", {});
  const copy = element("button", {type: "button", className: "quiet", ariaLabel: "copy the command"}, "copy");
  copy.addEventListener("click", async () => {
    try {
      await navigator.clipboard.writeText(code.textContent);
      copy.textContent = "copied";
    } catch {
      getSelection().selectAllChildren(code);
      copy.textContent = "selected";
    }
    setTimeout(() => { copy.textContent = "copy"; }, 1500);
  });
  const line = element("div", {className: "command", hidden: true}, element("span", {ariaHidden: "true"}, "$ "), code, copy);
  return {element: line, show(text) {
    line.hidden = text === "";
    if (code.textContent !== text) code.textContent = text;
  }};
}

/// The last command at the foot of the page, and those before it.
export function commandLog() {
  const last = commandLine();
  const earlier = element("ol", {className: "earlier"});
  const what = element("span", {className: "note"});
  const details = element("details", {}, element("summary", {}, "all of this session"), earlier);
  const log = element("footer", {className: "log", hidden: true},
    element("div", {className: "last"}, element("span", {className: "note"}, "the same in a shell"), last.element, what),
    details);
  let shown = "";
  return {element: log, add(command, about = "") {
    log.hidden = false;
    what.textContent = about;
    if (command === shown) return;
    shown = command;
    last.show(command);
    earlier.append(element("li", {}, element("code", {}, command), about === "" ? "" : `  # ${about}`));
  }};
}
