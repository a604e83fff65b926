/// The page of a run.

import {allCurves} from "./curves.js";
import {curvesFigure} from "./curves_figure.js";
import {study} from "./data.js";
import {keepFigures} from "./figure.js";
import {liveFigure} from "./live_figure.js";
import {showFields, showPictures} from "./pictures.js";
import {runsFigure} from "./runs_figure.js";
import {showDeck} from "./table.js";
import {showComparison, showProvenance, showQuality, showSummary, showWarnings} from "./tables.js";
import {showWholeFiller} from "./whole_filler.js";

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
