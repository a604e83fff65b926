/// The names that the pages use for the entries of the results.

import {display, percent, percentOfWhole} from "./numbers.js";

/// The boundary conditions, in the order in which figures offer them.
export const boundaryNames = ["displacement", "traction", "periodic"];
export const methodNames = {quasistatic: "quasi-static", dynamic: "dynamic"};

/// The unit of thermal expansions in figures.
export const perMillionAndKelvin = "10⁻⁶/K";

/// The quantities that a figure can show, in the order in which the page offers them.
export const quantities = [
  {name: "shear", title: "Relaxation modulus G(t)", x: "time", xUnit: "s", unit: "Pa"},
  {name: "bulk", title: "Bulk modulus K(t); of a plane box K(t) + G(t)/3", x: "time", xUnit: "s", unit: "Pa"},
  {name: "young", title: "Young's modulus E(t)", x: "time", xUnit: "s", unit: "Pa"},
  {name: "poisson", title: "Poisson's ratio", x: "time", xUnit: "s", unit: ""},
  {name: "tensile-compliance", title: "Creep compliance in tension D(t)", x: "time", xUnit: "s", unit: "1/Pa"},
  {name: "thermal-expansion", title: "Linear thermal expansion", x: "time", xUnit: "s",
    unit: perMillionAndKelvin},
  {name: "compliance", title: "Creep compliance", x: "time", xUnit: "s", unit: "1/Pa"},
  {name: "dynamic", title: "Storage and loss modulus G′, G″", x: "angular frequency", xUnit: "rad/s", unit: "Pa"},
  {name: "absolute", title: "Absolute value |G*|", x: "angular frequency", xUnit: "rad/s", unit: "Pa"},
  {name: "phase", title: "Phase of G*", x: "angular frequency", xUnit: "rad/s", unit: "°"},
  {name: "loss-factor", title: "Loss factor tan δ = G″/G′", x: "angular frequency", xUnit: "rad/s", unit: ""},
  {name: "young-dynamic", title: "Storage and loss modulus E′, E″", x: "angular frequency", xUnit: "rad/s", unit: "Pa"},
  {name: "young-loss-factor", title: "Loss factor tan δ = E″/E′", x: "angular frequency", xUnit: "rad/s", unit: ""},
];

/// The abscissas against which a quantity over time or over frequency can be shown.
export const axes = {
  time: {x: "time", xUnit: "s"},
  frequency: {x: "frequency", xUnit: "Hz"},
  "angular-frequency": {x: "angular frequency", xUnit: "rad/s"},
  temperature: {x: "temperature", xUnit: "°C"},
};

/// The name of a grid: its number of cells along a side of the box, or "extrapolated" for the result of all grids (the
/// limit of vanishing cells with points, the finest grid with mixed cells, and the band of both); "films" has none.
export function gridName(cells) {
  if (cells === "films") return cells;
  return cells === "extrapolated" ? "all grids" : `${cells} cells`;
}

/// The cells of a table that name a test.
export function nameOfTest(stage, test) {
  return [stage.name, test.load, test.boundary, methodNames[test.method]];
}

/// Whether a stage was computed by the model of grains and films, without cells.
export function hasFilms({cells}) {
  return cells[0] === "films";
}

/// The modulus of a bulk test of a stage: in the plane it has a part of the shear modulus.
export function bulkSymbolOf({dimensions}) {
  return dimensions === 3 ? "K" : "K + G/3";
}

/// What films are that are not bonded as the others are.
export function stateOfBonds({kind}) {
  return kind === "spring" ? "on springs" : "debonded";
}

/// A description of the microstructure of a stage.
export function textOnStage(stage) {
  const box = `a box of ${display(stage.box_m, "m")}`;
  if (stage.filler === null) return `${box} of ${stage.matrix} alone`;
  const {particles, pixels, fraction, film_m: film, debonding} = stage.microstructure;
  if (pixels !== undefined) {
    const image = `an image of ${pixels.join(" x ")} pixels: ${stage.filler}, ${percentOfWhole(fraction)}`;
    const {threshold} = stage.microstructure;
    return `${image} of ${box}, in ${stage.matrix}${threshold === undefined ? "" : `; ${threshold.words}`}`;
  }
  const debonded = debonding === undefined ? "" : `, of which ${percent(debonding.share)} are ${stateOfBonds(debonding)}`;
  const kind = film === undefined ? "particles" : `grains, with films of ${display(film, "m")} between them${debonded},`;
  return `${particles} ${kind} of ${stage.filler} fill ${percentOfWhole(fraction)} of ${box} of ${stage.matrix}`;
}

/// A time of a study [s] as text or, where its deck gives frequencies, the frequency that belongs to it.
export function instantText(study, time, digits) {
  return study.frequencies_Hz === undefined ? display(time, "s", digits)
    : display(1 / (2 * Math.PI * time), "Hz", digits);
}

/// "a", "a and b", "a, b and c".
export function listed(words) {
  return words.length < 2 ? words.join("") : `${words.slice(0, -1).join(", ")} and ${words.at(-1)}`;
}

/// The symbol of the modulus that a load gives, one of the loads of its stage.
export function symbolOf(load, loads = []) {
  if (load === "bulk") return "The bulk modulus K(t)";
  if (load === "shear" && loads.some((other) => other.startsWith("shear-"))) return "G(t) in shear xy, one of several shears,";
  return ["isotropic", "shear"].includes(load) ? "G(t)" : `G(t) in ${load.replace("-", " ")}`;
}
