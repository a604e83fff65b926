"use strict";

showSummary();
showWarnings();
showComparison();
showPictures();
showQuality();
showDeck();
showProvenance();

const curvesOfStudy = allCurves();
const figures = [];

function drawAll() {
  for (const draw of figures) draw();
}

if (curvesOfStudy.some((curve) => curve.role === "stage")) {
  figures.push(curvesFigure(curvesOfStudy));
  figures.push(liveFigure(curvesOfStudy));
  drawAll();
} else {
  document.getElementById("curves").hidden = true;
}

matchMedia("(prefers-color-scheme: dark)").addEventListener("change", drawAll);
addEventListener("beforeprint", () => {
  printing.now = true;
  drawAll();
});
addEventListener("afterprint", () => {
  printing.now = false;
  drawAll();
});
