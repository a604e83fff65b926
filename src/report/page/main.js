"use strict";

showSummary();
showWholeFiller();
showWarnings();
showComparison();
showPictures();
showFields();
showQuality();
showDeck(study);
showProvenance();

const curvesOfStudy = allCurves();
if (curvesOfStudy.some((curve) => curve.role === "stage")) {
  const figures = [curvesFigure(curvesOfStudy), runsFigure(curvesOfStudy), liveFigure(curvesOfStudy)];
  keepFigures(() => figures.forEach((draw) => draw()));
} else {
  document.getElementById("curves").hidden = true;
}
