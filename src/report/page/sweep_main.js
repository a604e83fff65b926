"use strict";

showSweepSummary();
showTasks();
showSpread();
showDeck(sweep);
showSweepProvenance();

const curvesOfSweep = sweepCurves();
if (curvesOfSweep.length > 0) {
  const choice = sweepChoice(curvesOfSweep);
  const drawAll = () => figures.forEach((draw) => draw());
  const figures = [];
  figures.push(sweepFigure(curvesOfSweep, choice, drawAll), keyFigure(curvesOfSweep, choice));
  keepFigures(drawAll);
} else {
  for (const id of ["curves", "key"]) document.getElementById(id).hidden = true;
}
