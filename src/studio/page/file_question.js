/// Asks for the file that a value is to name, before anything is written: one of the folder, or one that is dropped.

import {element} from "../../page/scripts/elements.js";
import {dropTarget} from "./upload.js";

/// The question, which is hidden until `ask({files, take})` is called: `take(name)` gets the answer.
export function fileQuestion(context) {
  let take = () => {};
  const list = element("select", {ariaLabel: "which file", onchange: () => answer(list.value)});
  const target = dropTarget({label: "or drop a file here", context, taken: answer});
  const cancel = element("button", {type: "button", className: "quiet", onclick: () => close()}, "Cancel");
  const question = element("div", {className: "file-choice question", hidden: true, role: "group", ariaLabel: "which file"},
    list, target, cancel);
  let origin = null;

  function close() {
    question.hidden = true;
    origin?.focus();
  }

  function answer(name) {
    if (name === "") return;
    question.hidden = true;
    take(name);
  }

  return {element: question, ask({files, take: newTake}) {
    take = newTake;
    origin = document.activeElement;
    list.replaceChildren(element("option", {value: ""}, files.length === 0 ? "no such file in the folder" : "which file?"),
      ...files.map((name) => element("option", {value: name}, name)));
    question.hidden = false;
    list.focus();
  }};
}
