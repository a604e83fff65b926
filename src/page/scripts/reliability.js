/// The reliability of the results, from the error estimates of the run, and the meaning of the terms on the page.

import {study} from "./data.js";
import {element} from "./elements.js";
import {distinct} from "./records.js";
import {stagesOfInterest} from "./stages.js";
import {sentencesOnReliability} from "./reliability_sentences.js";

/// Shows the sentences on the last stage.
export function showReliability() {
  const [stage] = stagesOfInterest(study).slice(-1);
  if (stage === undefined) return;
  document.getElementById("trust").append(...sentencesOnReliability(study, stage).map((text) => element("li", {}, text)));
}

/// The words with their meaning and, where not every page has them, the method, solver or grid that brings them in.
const words = [
  ["G(t)", "The relaxation modulus in shear: stress over strain, at the time t after the strain was applied and held."],
  ["G′, G″, tan δ", "Storage modulus, loss modulus and their ratio: the same material under a harmonic strain."],
  ["displacement, traction", "Apparent moduli: of the box with displacements, or with tractions, prescribed on its sides " +
    "(KUBC and SUBC in the literature). They bound the modulus of the material, on the average over boxes, where the box " +
    "is a window in a larger body."],
  ["binder, matrix", "The soft material between the particles. The matrix of a stage is the binder, or an earlier " +
    "stage."],
  ["stage", "A box with particles and its tests. Its result may be the matrix of the next stage, of larger particles."],
  ["gap", "The smallest distance between two particles, which a film of matrix fills."],
  ["Prony series", "A sum of exponentials that is the relaxation modulus."],
  ["cells", "The grid divides each side of the box into so many. All grids: what several grids tell together.",
    "cells"],
  ["quasi-static", "Without inertia: equilibrium at every time.", "quasistatic"],
  ["reduced basis, snapshots", "The relaxation of the box, as a combination of a few elastic solutions (snapshots), " +
    "each with another stiffness of the matrix. Its error is estimated from the equilibrium that is missing.", "reduced"],
  ["dynamic, mass scaling factor", "Stress waves run through the box until it is at rest. All densities are multiplied by " +
    "the mass scaling factor so that long times need fewer steps; each run counts in its time domain.", "dynamic"],
];

/// Shows the words that the page uses.
export function showGlossary() {
  const tests = study.stages.flatMap((stage) => stage.tests);
  const used = new Set([...distinct(tests, "method"), ...distinct(tests, "solver"),
    ...(tests.some(({cells}) => cells !== "films") ? ["cells"] : [])]);
  document.getElementById("glossary").append(...words.filter(([, , of]) => of === undefined || used.has(of))
    .flatMap(([word, meaning]) => [element("dt", {}, word), element("dd", {}, meaning)]));
}
