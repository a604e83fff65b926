/// The page of a run.

import {allCurves} from "./curves.js";
import {curvesFigure} from "./curves_figure.js";
import {study} from "./data.js";
import {keepFigures} from "./figure.js";
import {showResult, showModuli, showResultPicture, showWarnings} from "./first_screen.js";
import {liveFigure} from "./live_figure.js";
import {offerOnePage} from "./one_page.js";
import {showFields, showPictures} from "./pictures.js";
import {runsFigure} from "./runs_figure.js";
import {showStiffness} from "./stiffness.js";
import {showDeck} from "./table.js";
import {showComparison, showProvenance, showQuality, showStages} from "./tables.js";
import {showGlossary, showReliability} from "./reliability.js";

const curvesOfStudy = allCurves();
showResult(curvesOfStudy);
showWarnings();
showResultPicture();
showModuli(curvesOfStudy);
showStiffness();
showStages();
showComparison();
showPictures();
showFields();
showReliability();
showQuality();
showGlossary();
showDeck(study);
showProvenance();
offerOnePage();

if (curvesOfStudy.some((curve) => curve.role === "stage")) {
  const figures = [curvesFigure(curvesOfStudy), runsFigure(curvesOfStudy), liveFigure(curvesOfStudy)];
  keepFigures(() => figures.forEach((draw) => draw()));
} else {
  document.getElementById("curves").hidden = true;
}
