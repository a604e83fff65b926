/// The answer, its figure, its moduli and its error on one page of paper, for a report: the button prints it, and so does
/// a browser that is given the address with "#one-page".

import {study} from "./data.js";
import {element} from "./elements.js";

/// Where the page comes from, in a line.
function source() {
  const date = study.date ? `, ${study.date.slice(0, 10)}` : "";
  return `${study.program} ${study.version}, ${study.deck}, hash ${study.hash}${date}.`;
}

/// Adds the button to the head of the page. In a frame, as that of the studio, a page cannot print itself.
export function offerOnePage() {
  const {classList} = document.documentElement;
  if (location.hash === "#one-page") classList.add("one-page");
  document.querySelector("main").append(element("p", {className: "note source"}, source()));
  if (window.parent !== window) return;
  addEventListener("afterprint", () => classList.remove("one-page"));
  document.getElementById("summary").append(element("button", {className: "screen-only", onclick: () => {
    classList.add("one-page");
    print();
  }}, "Print one page"));
}
