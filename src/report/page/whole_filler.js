import {study} from "./data.js";
import {element} from "./elements.js";
import {listed} from "./names.js";
import {percentOfWhole} from "./numbers.js";
import {stagesOfInterest} from "./stages.js";

/// Shows the fractions of all particles of a chain of stages, for each stage that is no other's matrix.
export function showWholeFiller() {
  const sentences = stagesOfInterest(study).filter((stage) => stage.filler_of_the_whole).map((stage) => {
    const {fraction, mass_fraction: massFraction, materials} = stage.filler_of_the_whole;
    const shares = materials.map((one) => `${one.material} ${percentOfWhole(one.mass_fraction)}`);
    const parts = shares.length > 1 ? ` (${listed(shares)})` : "";
    return `Filler of the whole of ${stage.name}: ${percentOfWhole(fraction)} by volume, ` +
      `${percentOfWhole(massFraction)} by mass${parts}.`;
  });
  if (sentences.length > 0) document.getElementById("stages").append(element("p", {}, sentences.join(" ")));
}
