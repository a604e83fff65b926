"use strict";

/// What the particles of all stages make up of the whole, for each stage that no other builds on.
function showWholeFiller() {
  const isMatrix = (stage) => study.stages.some((other) => other.matrix === stage.name);
  const sentences = study.stages.filter((stage) => stage.filler_of_the_whole && !isMatrix(stage)).map((stage) => {
    const {fraction, mass_fraction: massFraction, materials} = stage.filler_of_the_whole;
    const shares = materials.map((one) => `${one.material} ${percentOfBox(one.mass_fraction)}`);
    const parts = shares.length > 1 ? ` (${listed(shares)})` : "";
    return `Filler of the whole of ${stage.name}: ${percentOfBox(fraction)} by volume, ` +
      `${percentOfBox(massFraction)} by mass${parts}.`;
  });
  if (sentences.length > 0) document.getElementById("summary").append(element("p", {}, sentences.join(" ")));
}
