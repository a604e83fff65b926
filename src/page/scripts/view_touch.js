/// A finger on a view scrolls the page, as it does on a picture, until the reader taps the view; then it turns the
/// view, until the reader touches the page elsewhere.

import {element} from "./elements.js";

/// Adds this behaviour to a canvas in its frame. Call it after the controls that turn the view have been made.
export function turnAfterTap(canvas, frame) {
  const hint = element("span", {className: "view-hint"}, "tap to turn");
  frame.append(hint);
  let isActive = false;
  const show = (active) => {
    isActive = active;
    canvas.style.touchAction = active ? "none" : "pan-x pan-y pinch-zoom";
    frame.classList.toggle("turnable", active);
  };
  show(false);
  canvas.addEventListener("pointerdown", (event) => {
    if (event.pointerType === "touch" && !isActive) event.stopImmediatePropagation();
  }, {capture: true});
  // A finger that has scrolled the page makes no click.
  canvas.addEventListener("click", () => show(true));
  document.addEventListener("pointerdown", (event) => {
    if (!frame.contains(event.target)) show(false);
  });
}
