/// The page of a sweep.

import {sweep} from "./data.js";
import {keepFigures} from "./figure.js";
import {keyFigure} from "./key_figure.js";
import {sweepCurves} from "./sweep_curves.js";
import {sweepChoice, sweepFigure} from "./sweep_figure.js";
import {showSpread, showSweepProvenance, showSweepSummary, showTasks} from "./sweep_tables.js";
import {showDeck} from "./table.js";

const curvesOfSweep = sweepCurves();
showSweepSummary(curvesOfSweep);
showTasks(curvesOfSweep);
showSpread();
showDeck(sweep);
showSweepProvenance();

if (curvesOfSweep.length > 0) {
  const choice = sweepChoice(curvesOfSweep);
  const drawAll = () => figures.forEach((draw) => draw());
  const figures = [];
  figures.push(sweepFigure(curvesOfSweep, choice, drawAll), keyFigure(curvesOfSweep, choice));
  keepFigures(drawAll);
} else {
  for (const id of ["curves", "key"]) document.getElementById(id).hidden = true;
}
