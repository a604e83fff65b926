/// The page of a fit.

import {data} from "./data.js";
import {chooser, element} from "./elements.js";
import {keepFigures, saveFigure} from "./figure.js";
import {decadesToReference, lawAt, zeroCelsius} from "./fit_curves.js";
import {blackFigure, celsius, deviationFigure, masterFigure, rawFigure, shiftFigure, spectrumFigure} from
  "./fit_figures.js";
import {fileName, save} from "./files.js";
import {display, percent, shortNumber} from "./numbers.js";
import {extent} from "./sampling.js";
import {table} from "./table.js";
import {shiftedSeries} from "./viscoelasticity.js";

const {fit, sweeps = []} = data;
const shown = {reference_K: fit.reference_K ?? sweeps[0]?.temperature_K, axis: "angular-frequency"};

/// The modulus of the fit at a time.
function fittedAt(time) {
  const {terms, equilibrium_Pa: equilibrium} = fit.series;
  return terms.reduce((sum, term) => sum + term.modulus_Pa * Math.exp(-time / term.relaxation_time_s), equilibrium);
}

/// Shows the result of the fit in sentences.
function showResult() {
  document.getElementById("title").textContent = fit.source;
  const {terms} = fit.series;
  const at = fit.reference_K === undefined ? "" : ` at ${celsius(fit.reference_K)}`;
  const kind = fit.kind === "Young's modulus" ? fit.kind : `The ${fit.kind}`;
  const [from, to] = fit.times_s.map((time) => `${display(fittedAt(time), "Pa")} at ${display(time, "s", 2)}`);
  const by = fit.modulus_law === undefined ? `${terms.length} ${terms.length === 1 ? "term" : "terms"}`
    : `the law ${fit.modulus_law.name}`;
  const first = `${kind}${at} relaxes from ${from} to ${to}, the times of the data, by ${by}.`;
  const sentences = [];
  if (fit.quality !== undefined) {
    const {median, worst, worst_at: place} = fit.quality;
    const where = fit.measured === "dynamic" ? `${shortNumber(place)} rad/s` : display(place, "s");
    sentences.push(`The fit deviates from the data by ${percent(median)} in the median, by ${percent(worst)} at ` +
      `worst, at ${where}.`);
  }
  document.getElementById("summary").append(element("p", {id: "answer"}, element("strong", {}, first),
    ` ${sentences.join(" ")}`));
  document.getElementById("origin").textContent = `breccia ${fit.version}, from ${fit.source}.`;
}

/// The constants of the law at the chosen reference, and the line of a deck that has them.
function showLaw() {
  const place = document.getElementById("law");
  if (sweeps.length < 2) return;
  if (fit.law === undefined) {
    place.textContent = "These shift factors do not determine the constants of a law of Williams, Landel and " +
      "Ferry. material.toml, beside this page, takes them as a table.";
    return;
  }
  if (fit.law.c1_error === 0) {
    place.textContent = `c1 = ${shortNumber(fit.law.c1, 4)} and c2 = ${shortNumber(fit.law.c2_K, 4)} K at ` +
      `${celsius(fit.law.reference_K)} meet both shift factors, as some law of Williams, Landel and Ferry does for any ` +
      "two. material.toml, beside this page, takes them as a table.";
    return;
  }
  const {c1, c2_K: c2} = lawAt(fit.law, shown.reference_K), stored = fit.law;
  const isOfFit = shown.reference_K === fit.law.reference_K;
  const errors = [fit.law.c1_error, fit.law.c2_error_K].map((error) => isOfFit ? ` ± ${shortNumber(error, 2)}` : "");
  const [reference, temperature] = [stored.reference_K, shown.reference_K].map((kelvins) =>
    Number((kelvins - zeroCelsius).toFixed(2)));
  place.replaceChildren(`WLF: c1 = ${shortNumber(c1, 4)}${errors[0]} and c2 = ${shortNumber(c2, 4)}${errors[1]} K at ` +
    `${celsius(shown.reference_K)}; log₁₀ a_T deviates by ${shortNumber(fit.law.worst_deviation, 2)} at worst, at ` +
    `${celsius(fit.law.worst_at_K)}. In a deck, beside the series of the fit (prony.csv), for a study at ` +
    `${celsius(shown.reference_K)}: `,
  element("code", {}, `temperature_shift = { law = "wlf", c1 = ${Number(stored.c1.toPrecision(6))}, ` +
    `c2 = "${Number(stored.c2_K.toPrecision(6))} K", reference = "${reference} degC", ` +
    `temperature = "${temperature} degC" }`));
}

/// The law that was fitted in place of a spectrum.
function showModulusLaw() {
  if (fit.modulus_law === undefined) return;
  const {name, deck, parameters} = fit.modulus_law;
  document.getElementById("modulus-law").hidden = false;
  document.getElementById("modulus-law-deck").textContent = deck;
  document.getElementById("modulus-law-table").append(table([name, "value", "standard error"],
    parameters.map((row) => row.map((text) => text.replace("+-", "±").replaceAll("`", "")))));
}

function showTables() {
  if (sweeps.length > 1) {
    document.getElementById("shift-table").append(table(["temperature", "log₁₀ a_T", "standard error"],
      sweeps.map((sweep) => [celsius(sweep.temperature_K), shortNumber(sweep.log10_shift_factor, 4),
        shortNumber(sweep.standard_error, 2)])));
  }
  const {terms, equilibrium_Pa: equilibrium} = fit.series;
  document.getElementById("spectrum-table").append(table(["relaxation time", "modulus"],
    [...terms.map((term) => [display(term.relaxation_time_s, "s", 4), display(term.modulus_Pa, "Pa", 4)]),
      ["∞", display(equilibrium, "Pa", 4)]]));
}

/// The series at the chosen reference, as a deck reads it.
function seriesAsCsv() {
  const {terms, equilibrium_Pa: equilibrium} =
    shiftedSeries(fit.series, 10 ** decadesToReference(fit, shown.reference_K));
  const rows = terms.map((term) => `${term.relaxation_time_s},${term.modulus_Pa}`);
  const kind = {"shear modulus": "shear_", "Young's modulus": "youngs_", "bulk modulus": "bulk_"}[fit.kind] ?? "";
  const place = shown.reference_K === undefined ? [] : [`# at the reference temperature ${celsius(shown.reference_K)}`];
  return [...place, `relaxation_time_s,${kind}modulus_Pa`, ...rows, ...(equilibrium > 0 ? [`inf,${equilibrium}`] : []), ""]
    .join("\n");
}

showResult();
showModulusLaw();
showTables();
const master = masterFigure(shown);
const figures = [master.draw, deviationFigure(shown), shiftFigure(shown), blackFigure(), rawFigure(shown),
  spectrumFigure(shown)];
const drawAll = () => {
  showLaw();
  figures.forEach((draw) => draw());
};

/// The choice of the axis, and of the reference temperature where a law is known.
function choices() {
  if (sweeps.length === 0) return [];
  const axis = chooser("axis", "axis", [["angular-frequency", "over angular frequency in rad/s"],
    ["frequency", "over frequency in Hz"]], (value) => {
    shown.axis = value;
    drawAll();
  });
  if (fit.law === undefined) return [axis];
  const [coldest, hottest] = extent(sweeps.map((sweep) => sweep.temperature_K - zeroCelsius));
  const reading = element("output", {}, celsius(shown.reference_K));
  const slider = element("input", {type: "range", id: "reference", ariaLabel: "reference temperature", step: 0.5,
    min: Math.ceil(coldest), max: Math.floor(hottest), oninput: () => {
      shown.reference_K = Number(slider.value) + zeroCelsius;
      reading.textContent = celsius(shown.reference_K);
      drawAll();
    }});
  slider.value = shown.reference_K - zeroCelsius;
  return [axis, element("label", {}, "Reference temperature ", slider, " ", reading)];
}

document.getElementById("master-choices").append(...choices());
document.getElementById("master-note").textContent = sweeps.length > 0
  ? "Filled: storage modulus, open: loss modulus; colours: temperature. Lines: the fit."
  : "Points: measured. Line: the fit.";
document.getElementById("master-buttons").append(element("button", {onclick: () =>
  saveFigure(master.plot, `${fit.source} fit`, master.draw)}, "This figure as SVG"));
document.getElementById("spectrum-buttons").append(element("button", {onclick: () =>
  save(fileName(`${fit.source} prony ${shown.reference_K === undefined ? "" : celsius(shown.reference_K)}`, "csv"),
    seriesAsCsv(), "text/csv")}, "This series as CSV"));
keepFigures(drawAll);
