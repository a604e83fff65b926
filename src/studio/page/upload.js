/// Files of the user's computer: dropped on a place of the page or chosen, and copied into the folder.

import {element} from "../../page/scripts/elements.js";
import * as api from "./api.js";

let count = 0;

/// A place on which a file may be dropped, and which is a button to choose one. Calls taken(name) once the file is in
/// the folder of the studio.
export function dropTarget({label, context, taken}) {
  const input = element("input", {type: "file", className: "of-target", id: `upload-${++count}`, ariaLabel: label});
  const words = element("span", {}, label);
  const target = element("label", {className: "drop"}, input, words);
  const take = async (file) => {
    if (file === undefined) return;
    words.textContent = `copying ${file.name} …`;
    try {
      const {name, command} = await api.upload(file);
      context.showCommand(command, `copied ${name} into the folder`);
      await context.refreshFolder();
      words.textContent = label;
      taken(name);
    } catch (error) {
      words.textContent = `${error.message}. ${label}`;
    }
    input.value = "";
  };
  input.addEventListener("change", () => take(input.files[0]));
  target.addEventListener("dragover", (event) => {
    event.preventDefault();
    target.classList.add("over");
  });
  target.addEventListener("dragleave", () => target.classList.remove("over"));
  target.addEventListener("drop", (event) => {
    event.preventDefault();
    target.classList.remove("over");
    take(event.dataTransfer.files[0]);
  });
  return target;
}
