/// A text on the fraction of all particles of a chain of stages.

import {listed} from "./names.js";
import {percentOfWhole} from "./numbers.js";

/// The fractions of the particles of a stage and of all stages in its matrix; undefined where it has no such stage.
export function sentenceOnWholeFiller(stage) {
  if (!stage.filler_of_the_whole) return undefined;
  const {fraction, mass_fraction: massFraction, materials, porosity} = stage.filler_of_the_whole;
  const voids = porosity === undefined ? "" : `${percentOfWhole(porosity)} by volume`;
  if (!(fraction > 0)) return `Voids of ${stage.name}: ${voids}.`;
  const shares = materials.map((one) => `${one.material} ${percentOfWhole(one.mass_fraction)}`);
  const parts = shares.length > 1 ? ` (${listed(shares)})` : "";
  return `Filler of the whole of ${stage.name}: ${percentOfWhole(fraction)} by volume, ` +
    `${percentOfWhole(massFraction)} by mass${parts}${voids ? `; voids ${voids}` : ""}.`;
}
