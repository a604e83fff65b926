/// The pictures of microstructures, stress and strain.

import {data, study} from "./data.js";
import {element} from "./elements.js";
import {fileName, save} from "./files.js";
import {methodNames, stateOfBonds, textOnStage} from "./names.js";
import {display, percentOfWhole} from "./numbers.js";
import {colourOf, debondedColour, phasesOf} from "./phase_colours.js";
import {own} from "./records.js";

/// Shows the microstructure of each stage.
export function showPictures() {
  const place = document.getElementById("pictures");
  for (const stage of study.stages) {
    const svg = own(data.pictures, stage.name);
    if (svg === undefined) continue;
    place.append(zoomableFigure(svg, `${stage.name} microstructure`, `${stage.name}: ${textOnStage(stage)}`,
      ...legendOf(stage, {showsDebonded: true})));
  }
  document.getElementById("microstructures").hidden = place.childElementCount === 0;
}

/// The legend of a microstructure: the colours of its materials, the sizes of its particles, and films that are debonded
/// where the picture shows them.
export function legendOf({matrix, filler, fillers = [], microstructure}, {showsDebonded}) {
  const entry = (kind, text) => element("li", {}, element("span", {className: `swatch ${kind}`}), text);
  const sizesOf = ({smallest_diameter_m: smallest, largest_diameter_m: largest}) =>
    [...new Set([smallest, largest].filter(Number.isFinite).map((size) => display(size, "m")))];
  const described = (material, sizes) => (sizes.length > 0 ? `${material}, diameter ${sizes.join(" to ")}` : material);
  const shapeOf = ({shape} = {}) => (shape === undefined ? "" : `, ${shape}`);
  const entries = [entry("matrix", matrix)];
  const phases = phasesOf(fillers);
  if (filler !== null && phases.length < 2) {
    entries.push(entry("filler", described(filler, sizesOf(microstructure)) + shapeOf(fillers[0])));
  } else {
    const coloured = (material, text) => {
      const place = entry("filler", text);
      place.firstChild.style.background = colourOf(material, phases);
      return place;
    };
    for (const one of fillers) {
      const particles = one.particles === null ? "" : `${one.particles} particles, `;
      const share = `${particles}${percentOfWhole(one.fraction)}`;
      entries.push(coloured(one.material, `${described(one.material, sizesOf(one))}${shapeOf(one)} (${share})`));
      if (one.coating === null) continue;
      const thickness = display(one.coating.thickness_m, "m");
      entries.push(coloured(one.coating.material, `${one.coating.material}, coating of ${thickness}`));
    }
  }
  if (showsDebonded && microstructure?.debonding !== undefined) {
    const place = entry("filler", `film, ${stateOfBonds(microstructure.debonding)}`);
    place.firstChild.style.background = debondedColour;
    entries.push(place);
  }
  return [element("ul", {className: "legend"}, ...entries)];
}

/// Shows maps of stress and strain of each stage, and of films that of work, for one test and time that the reader
/// chooses.
export function showFields() {
  const place = document.getElementById("field-pictures");
  for (const stage of study.stages) {
    const fields = stage.tests.flatMap((test) => (test.fields ?? []).map((field) => ({test, ...field})));
    const pictures = own(data.fields, stage.name) ?? {};
    const shown = fields.filter((field) => own(pictures, field.stress_picture) !== undefined);
    if (shown.length === 0) continue;
    const maps = element("div", {className: "pictures"});
    const show = (field) => {
      const words = textOnField(field);
      const quantities = ["stress", "strain", "work"].filter((quantity) => field[`${quantity}_picture`] !== undefined);
      maps.replaceChildren(...quantities.map((quantity) => zoomableFigure(
        pictures[field[`${quantity}_picture`]], `${stage.name} ${quantity}`,
        `${stage.name}, ${quantity}: ${words}`)));
    };
    const choice = element("select", {ariaLabel: `Test and time of ${stage.name}`, className: "field-choice",
      onchange: () => show(shown[choice.selectedIndex])},
    ...shown.map((field) => element("option", {}, textOnField(field))));
    place.append(element("h3", {}, stage.name), choice, maps);
    choice.selectedIndex = Math.max(0, shown.findIndex((field) => field.file === "fields.vtkhdf"));
    show(shown[choice.selectedIndex]);
  }
  document.getElementById("fields").hidden = place.childElementCount === 0;
}

export function textOnField({test, time_s}) {
  return `${test.boundary}, ${methodNames[test.method]}, ${display(time_s, "s")}`;
}

/// A picture that the reader can zoom, move and save; `below` are the elements below its caption.
function zoomableFigure(svg, name, caption, ...below) {
  const image = element("img", {alt: caption, draggable: false,
    src: `data:image/svg+xml,${encodeURIComponent(svg)}`});
  const frame = element("div", {className: "picture"}, image);
  const zoom = makeZoomable(frame, image);
  return element("figure", {}, frame,
    element("figcaption", {}, caption, ...below),
    element("div", {className: "buttons"},
      element("button", {ariaLabel: "larger", onclick: () => zoom.by(1.5)}, "+"),
      element("button", {ariaLabel: "smaller", onclick: () => zoom.by(1 / 1.5)}, "−"),
      element("button", {onclick: () => zoom.reset()}, "All of it"),
      element("button", {onclick: () => save(fileName(name, "svg"), svg, "image/svg+xml")}, "SVG")));
}

/// Lets the reader zoom and move the image in its frame; returns the actions of the buttons.
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
    // The wheel alone scrolls the page. Browsers report a pinch as the wheel with Ctrl.
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
