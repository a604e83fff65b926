/// The style of the curves of a study.

import {currentInks, isDark} from "./colours.js";
import {bestGrid} from "./curves.js";
import {study} from "./data.js";
import {shearOf} from "./loads.js";

const dashes = {quasistatic: "solid", dynamic: "dash"};

/// Hues by boundary, as in modulus.svg: displacement is blue, traction red, between them green.
const hues = {displacement: 205, traction: 18, periodic: 160};

/// The colour of a curve. Later stages have more contrast to the background than earlier ones.
export function colourOf(curve) {
  if (curve.role === "measured") return currentInks().ink;
  if (curve.role === "matrix") return currentInks().faint;
  const stages = study.stages.map((stage) => stage.name);
  const rank = stages.length === 1 ? 1 : stages.indexOf(curve.stage) / (stages.length - 1);
  const isMain = ["bulk", shearOf(study.stages.find(({name}) => name === curve.stage))].includes(curve.load);
  const hue = hues[curve.boundary] + (isMain ? 0 : 70);
  const lightness = isDark() ? 45 + 25 * rank : 70 - 32 * rank;
  return `hsl(${hue}, 85%, ${lightness}%)`;
}

/// Curves of the Prony series have no grid: they are those of the best one.
export function isOfBestGrid(curve) {
  return curve.cells === undefined || curve.cells === bestGrid(curve.stage);
}

/// The line of a curve. Stages that are the matrix of another one are thinner.
export function lineOf(curve) {
  const color = colourOf(curve);
  if (curve.role === "matrix") return {color, dash: "dot", width: 1.6};
  if (curve.role === "measured") return {color, width: 2.8};
  const isMatrix = study.stages.some((stage) => stage.matrix === curve.stage);
  const width = !isOfBestGrid(curve) ? 1 : isMatrix ? 1.5 : 2.4;
  return {color, width, dash: curve.part === "loss" ? "dash" : dashes[curve.method] ?? "solid"};
}

/// The colour of the area between displacement and traction.
export function colourBetween() {
  return isDark() ? "rgba(150, 165, 190, 0.2)" : "rgba(90, 110, 145, 0.15)";
}
