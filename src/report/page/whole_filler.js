import {study} from "./data.js";
import {element} from "./elements.js";
import {listed} from "./names.js";
import {percentOfWhole} from "./numbers.js";

/// Shows the fractions of all particles of a chain of stages, for each stage that is no other's matrix.
export function showWholeFiller() {
  const isMatrix = (stage) => study.stages.some((other) => other.matrix === stage.name);
  const sentences = study.stages.filter((stage) => stage.filler_of_the_whole && !isMatrix(stage)).map((stage) => {
    const {fraction, mass_fraction: massFraction, materials} = stage.filler_of_the_whole;
    const shares = materials.map((one) => `${one.material} ${percentOfWhole(one.mass_fraction)}`);
    const parts = shares.length > 1 ? ` (${listed(shares)})` : "";
    return `Filler of the whole of ${stage.name}: ${percentOfWhole(fraction)} by volume, ` +
      `${percentOfWhole(massFraction)} by mass${parts}.`;
  });
  if (sentences.length > 0) document.getElementById("summary").append(element("p", {}, sentences.join(" ")));
}
