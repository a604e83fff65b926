/// Rotatable views of the stages of three dimensions, beside their pictures.

import {data, study} from "./data.js";
import {element} from "./elements.js";
import {hasFilms, textOnStage} from "./names.js";
import {shortNumber} from "./numbers.js";
import {particleModel} from "./particle_model.js";
import {channelsOf, colourOf, coloursOfPhases, debondedColour, phasesOf} from "./phase_colours.js";
import {legendOf, textOnField} from "./pictures.js";
import {own} from "./records.js";
import {rotatableView} from "./rotatable_view.js";
import {evenTicks, logarithmicTicks} from "./ticks.js";
import {drawsViews} from "./view_renderer.js";
import {volumeModel} from "./volume_model.js";

const coloursOfFields = data.views.colours.match(/.{6}/g);

/// The fillers as the particles show them.
function drawnFillers({fillers}) {
  const phases = phasesOf(fillers);
  return fillers.map(({material, coating}) => ({
    colour: colourOf(material, phases),
    coatingColour: colourOf(coating === null ? material : coating.material, phases),
    coatingThickness: coating === null ? 0 : coating.thickness_m,
  }));
}

/// The model of a volume of phases; the number after those of the phases is that of films that are debonded.
function phaseModel(stage, volume) {
  return volumeModel(volume, [...coloursOfPhases(stage.fillers), debondedColour].map(channelsOf));
}

/// The phases of a stage of grains and films in the view of one of its fields, which shows the films that are debonded,
/// too; undefined for other stages, and without fields.
function phasesOfFilms(stage, {fields}) {
  const files = stage.tests.flatMap((test) => test.fields ?? []);
  const shown = files.map(({file}) => own(fields, file)).find((field) => field !== undefined);
  if (!hasFilms(stage) || shown === undefined) return undefined;
  return {cells: [shown.cells, shown.cells, shown.cells], values: shown.material.values};
}

function showMicrostructure(stage, views) {
  const {microstructure} = views;
  if (microstructure === null) return;
  const {particles, phases} = microstructure;
  const isPart = particles !== undefined && particles.count < particles.listed;
  const note = isPart ? `, the ${particles.count} largest of them shown` : "";
  const ofFilms = phasesOfFilms(stage, views);
  document.getElementById("microstructure-views").append(rotatableView({
    name: `${stage.name} microstructure view`,
    caption: `${stage.name}: ${textOnStage(stage)}${note}`,
    side: stage.box_m,
    build: () => particles === undefined ? phaseModel(stage, ofFilms ?? phases)
      : particleModel(particles, stage.box_m, drawnFillers(stage)),
    below: legendOf(stage, {showsDebonded: ofFilms !== undefined}),
  }).figure);
}

/// The colour bar of a quantity with its values.
function colourBar({words, unit_size: unit, scale, from, to}) {
  const [first, last] = [from / unit, to / unit];
  const ticks = scale === "logarithmic"
    ? logarithmicTicks(Math.log10(first), Math.log10(last), 6, shortNumber).filter(({text}) => text !== "")
    : evenTicks(first, last, 5);
  const shareOf = (value) => scale === "logarithmic" ? Math.log(value / first) / Math.log(last / first)
    : (value - first) / (last - first);
  const stops = coloursOfFields.filter((_, i) => i % 15 === 0).map((colour) => `#${colour}`);
  return element("div", {className: "colour-bar"},
    element("div", {className: "colour-words"}, words),
    element("div", {className: "colour-scale", style: `background: linear-gradient(to right, ${stops.join(", ")})`}),
    element("div", {className: "colour-ticks"},
      ...ticks.map(({at, text}) => element("span", {style: `left: ${100 * shareOf(at)}%`}, text))));
}

/// The quantities of a field that a reader can choose.
const quantities = {stress: "stress", strain: "strain", material: "materials"};

function showFields(stage, views) {
  const fields = stage.tests.flatMap((test) => (test.fields ?? []).map((field) => ({test, ...field})))
    .filter(({file}) => own(views.fields, file) !== undefined);
  if (fields.length === 0) return;
  const bar = element("div", {});
  const choose = (label, className, texts) => element("select", {ariaLabel: label, className, onchange: () => show()},
    ...texts.map((text) => element("option", {}, text)));
  const field = choose(`Test and time of the view of ${stage.name}`, "view-field", fields.map(textOnField));
  const quantity = choose(`Quantity of the view of ${stage.name}`, "view-quantity", Object.values(quantities));
  field.selectedIndex = Math.max(0, fields.findIndex(({file}) => file === "fields.vtkhdf"));
  const captionOf = () => `${stage.name}, ${quantity.value}: ${textOnField(fields[field.selectedIndex])}`;
  const build = () => {
    const one = views.fields[fields[field.selectedIndex].file];
    const name = Object.keys(quantities)[quantity.selectedIndex];
    const cells = [one.cells, one.cells, one.cells];
    if (name === "material") return phaseModel(stage, {cells, values: one.material.values});
    return volumeModel({cells, values: one[name].values}, coloursOfFields.map(channelsOf));
  };
  const showLegend = () => {
    const shown = views.fields[fields[field.selectedIndex].file][Object.keys(quantities)[quantity.selectedIndex]];
    bar.replaceChildren(...(shown.words === undefined ? legendOf(stage, {showsDebonded: true}) : [colourBar(shown)]));
  };
  const view = rotatableView({name: `${stage.name} field view`, caption: captionOf(), side: stage.box_m, build,
    choices: [quantity, field], below: [bar]});
  const show = () => {
    showLegend();
    view.show(() => build(), captionOf());
  };
  showLegend();
  document.getElementById("field-views").append(view.figure);
}

if (drawsViews()) {
  for (const stage of study.stages) {
    const views = own(data.views.stages, stage.name);
    if (views === undefined) continue;
    showMicrostructure(stage, views);
    showFields(stage, views);
  }
  for (const note of document.querySelectorAll(".views-note")) note.hidden = false;
} else {
  document.getElementById("no-views").hidden = false;
}
