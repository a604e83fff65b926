"use strict";

/// The microstructures, which can be zoomed and moved.
function showPictures() {
  const place = document.getElementById("pictures");
  for (const stage of study.stages) {
    const svg = data.pictures[stage.name];
    if (svg === undefined) continue;
    const image = element("img", {alt: `Microstructure of ${stage.name}`, draggable: false,
      src: `data:image/svg+xml,${encodeURIComponent(svg)}`});
    const frame = element("div", {className: "picture"}, image);
    const zoom = makeZoomable(frame, image);
    place.append(element("figure", {}, frame,
      element("figcaption", {}, `${stage.name}: ${wordsOnStage(stage)}`),
      element("div", {className: "buttons"},
        element("button", {ariaLabel: "larger", onclick: () => zoom.by(1.5)}, "+"),
        element("button", {ariaLabel: "smaller", onclick: () => zoom.by(1 / 1.5)}, "−"),
        element("button", {onclick: () => zoom.reset()}, "All of it"),
        element("button", {onclick: () => save(fileName(`${stage.name} microstructure`, "svg"), svg, "image/svg+xml")},
          "SVG"))));
  }
  document.getElementById("microstructures").hidden = place.childElementCount === 0;
}

function makeZoomable(frame, image) {
  const most = 30;
  let view = {scale: 1, x: 0, y: 0};
  const show = () => {
    // The picture always covers its frame.
    view.x = Math.min(0, Math.max(view.x, frame.clientWidth * (1 - view.scale)));
    view.y = Math.min(0, Math.max(view.y, frame.clientHeight * (1 - view.scale)));
    image.style.transform = `translate(${view.x}px, ${view.y}px) scale(${view.scale})`;
  };
  const zoomAt = (factor, x, y) => {
    const scale = Math.min(most, Math.max(1, view.scale * factor));
    const change = scale / view.scale;
    view = {scale, x: x - change * (x - view.x), y: y - change * (y - view.y)};
    show();
  };
  frame.addEventListener("wheel", (event) => {
    // The wheel alone scrolls the page; with Ctrl it is also what browsers make of a pinch.
    if (!event.ctrlKey) return;
    event.preventDefault();
    const {left, top} = frame.getBoundingClientRect();
    zoomAt(Math.exp(-0.002 * event.deltaY), event.clientX - left, event.clientY - top);
  }, {passive: false});
  image.addEventListener("pointerdown", (event) => {
    if (view.scale > 1) image.setPointerCapture(event.pointerId);
  });
  image.addEventListener("pointermove", (event) => {
    if (!image.hasPointerCapture(event.pointerId)) return;
    view = {...view, x: view.x + event.movementX, y: view.y + event.movementY};
    show();
  });
  return {
    by: (factor) => zoomAt(factor, frame.clientWidth / 2, frame.clientHeight / 2),
    reset: () => {
      view = {scale: 1, x: 0, y: 0};
      show();
    },
  };
}
