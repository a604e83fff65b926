"use strict";

/// The section that recomputes G(t) for another temperature or another spectrum of a matrix.

const zeroCelsius = 273.15;

function liveFigure(curves) {
  const stages = Object.keys(data.responses);
  const candidates = materialsInUse();
  if (stages.length === 0 || candidates.length === 0) return () => {};
  document.getElementById("live").hidden = false;
  const plot = document.getElementById("live-plot");
  const quantity = quantities[0];
  const state = {material: candidates[0], spectrum: undefined, decades: 0};
  let results = [];

  const stored = (result) => curves.find((curve) => curve.quantity === "shear" && curve.load === "shear" &&
    curve.stage === result.stage && curve.boundary === result.boundary && curve.method === "quasistatic" &&
    curve.cells === bestGrid(curve.stage));

  const draw = () => {
    const liveCurves = curvesOfResults(results);
    const curvesOfRun = results.map(stored).filter((curve) => curve !== undefined);
    const traces = liveCurves.flatMap((curve) => tracesOf(curve, quantity));
    traces.push(...curvesOfRun.flatMap(({band, ...curve}) => tracesOf({...curve, label: `${curve.label}, of the run`},
      quantity, {dash: "dot", width: 1.3}).map((trace) => ({...trace, showlegend: false}))));
    return Plotly.react(plot, traces, layoutOf(quantity, [...liveCurves, ...curvesOfRun]), plotOptions);
  };

  const compute = () => {
    results = respond(Object.fromEntries(study.materials.map((material) =>
      [material.name, material === state.material ? changedMaterial(state) : material])));
    showRefusals(results);
    return draw();
  };

  const name = () => `${study.title} live`;
  document.getElementById("live-buttons").append(
    element("button", {onclick: () => save(fileName(name(), "csv"), csvOf(curvesOfResults(results), quantity),
      "text/csv")}, "These curves as CSV"),
    element("button", {onclick: () => saveFigure(plot, name(), draw)}, "This figure as SVG"));
  document.getElementById("live-choices").append(...liveChoices(candidates, state, compute));
  spectrumButtons(state, compute);
  compute();
  showAgreement(results, stored);
  return draw;
}

/// A material with its new spectrum, its relaxation times shifted by 10^decades.
function changedMaterial({material, spectrum, decades}) {
  const factor = Math.pow(10, decades);
  return {shear: shiftedSeries(spectrum ?? material.shear, factor), bulk: shiftedSeries(material.bulk, factor)};
}

function curvesOfResults(results) {
  return results.flatMap((result) => {
    const [begin, end] = result.window;
    if (!(begin < end)) return [];
    const x = logarithmic(begin, end, 20);
    return [{quantity: "shear", role: "stage", stage: result.stage, boundary: result.boundary, load: "shear",
      label: `${result.stage}, ${boundNames[result.boundary]}`, x, y: x.map((t) => result.modulus(t))}];
  });
}

function showRefusals(results) {
  const list = document.getElementById("live-refusals");
  const isCut = ({window: [begin, end]}) => begin > study.times_s[0] || end < study.times_s[1];
  const texts = results.filter((result) => result.refusal !== undefined || isCut(result)).map((result) => {
    const [begin, end] = result.window;
    const left = begin < end ? `shown from ${display(begin, "s", 2)} to ${display(end, "s", 2)} only` : "not shown";
    if (result.refusal === undefined) {
      return `${result.stage}, ${boundNames[result.boundary]}: ${left}, as far as ${result.matrix} is known.`;
    }
    const {name, value, range} = result.refusal;
    return `${result.stage}, ${boundNames[result.boundary]}: ${left}. There ${result.matrix} would have a ${name} ` +
      `modulus of ${display(value, "Pa", 3)}, outside the range from ${display(range[0], "Pa", 3)} to ` +
      `${display(range[1], "Pa", 3)} in which the run has sampled the boxes; run the study with wider times.`;
  });
  list.replaceChildren(...texts.map((text) => element("li", {}, text)));
  list.hidden = texts.length === 0;
}

/// The largest relative difference between what the page computes for the matrix of the run and what the run found.
function showAgreement(results, stored) {
  let worst = 0;
  for (const result of results) {
    const curve = stored(result);
    curve?.x.forEach((t, i) => {
      if (t > result.window[1] || t < result.window[0]) return;
      worst = Math.max(worst, Math.abs(result.modulus(t) / curve.y[i] - 1));
    });
  }
  const note = document.getElementById("live-note");
  note.dataset.agreement = worst;
  note.textContent = `Dotted: the run itself. For its own matrix the page gives the curves of the run within ` +
    `${percent(worst)}.`;
}

function liveChoices(candidates, state, compute) {
  const rows = [];
  const temperature = element("div", {className: "temperature"});
  const offer = () => temperature.replaceChildren(...temperatureChoice(state, compute));
  if (candidates.length > 1) {
    const select = element("select", {ariaLabel: "material", onchange: () => {
      Object.assign(state, {material: candidates[select.selectedIndex], spectrum: undefined, decades: 0});
      offer();
      compute();
    }}, ...candidates.map((material) => element("option", {}, material.name)));
    rows.push(select);
  }
  offer();
  return [...rows, temperature];
}

/// The slider, and the constants of the law where the deck has none.
function temperatureChoice(state, compute) {
  const known = state.material.temperature_shift;
  const law = {...known};
  const slider = element("input", {type: "range", id: "temperature", ariaLabel: "temperature", step: 0.5});
  const reading = element("output", {id: "temperature-reading"});
  const show = () => {
    const excess = law.temperature_K - law.reference_K + law.c2_K;
    const isKnown = [law.c1, law.c2_K, law.reference_K].every(Number.isFinite) && law.c2_K > 0 && excess > 0;
    slider.disabled = !isKnown;
    if (!isKnown) return void (reading.textContent = "give the three constants of the WLF law to move it");
    const kelvin = Number(slider.value) + zeroCelsius;
    state.decades = decadesOfShift(law, kelvin) - decadesOfShift(law, law.temperature_K);
    reading.textContent = `${Number(slider.value)} °C, relaxation times × ${Number((10 ** state.decades).toPrecision(3))}`;
    compute();
  };
  const range = () => {
    const own = law.temperature_K - zeroCelsius;
    const least = law.reference_K - law.c2_K - zeroCelsius;
    slider.min = Math.ceil(Math.max(own - 40, least + 10));
    slider.max = Math.floor(own + 60);
    slider.value = own;
  };
  slider.addEventListener("input", show);
  if (known !== undefined) {
    range();
    reading.textContent = `${slider.value} °C, as in the run`;
    return [`Temperature of ${state.material.name}`, slider, reading];
  }
  const field = (label, take) => {
    const input = element("input", {type: "number", step: "any", ariaLabel: label, oninput: () => {
      take(input.value === "" ? NaN : Number(input.value));
      if (Number.isFinite(law.reference_K) && Number.isFinite(law.c2_K)) range();
      show();
    }});
    return element("label", {}, `${label} `, input, " ");
  };
  slider.disabled = true;
  reading.textContent = "give the three constants of the WLF law to move it";
  const constants = element("div", {},
    field("c1", (value) => { law.c1 = value; }), field("c2 / K", (value) => { law.c2_K = value; }),
    field("temperature of the run / °C", (value) => { law.reference_K = law.temperature_K = value + zeroCelsius; }));
  return [constants, `Temperature of ${state.material.name}`, slider, reading];
}

/// A pasted spectrum; throws an Error that names the line.
function readSpectrum(text) {
  const terms = [];
  let equilibrium_Pa = 0;
  text.split(/\r?\n/).forEach((line, i) => {
    const cells = line.trim().split(/[,;\s]+/).filter((cell) => cell !== "");
    if (cells.length === 0 || line.trim().startsWith("#")) return;
    const [time, modulus] = cells.map(numberOf);
    if (terms.length === 0 && Number.isNaN(time)) return;  // the names of the columns
    if (cells.length !== 2 || !(time > 0) || !(modulus >= 0) || !Number.isFinite(modulus)) {
      throw new Error(`line ${i + 1}: expected a relaxation time above 0 and a modulus not below 0, got "${line.trim()}"`);
    }
    if (time === Infinity) equilibrium_Pa += modulus;
    else terms.push({relaxation_time_s: time, modulus_Pa: modulus});
  });
  if (!(terms.reduce((sum, term) => sum + term.modulus_Pa, equilibrium_Pa) > 0)) {
    throw new Error("expected at least one term with a modulus above 0");
  }
  return {equilibrium_Pa, terms};
}

function spectrumButtons(state, compute) {
  const text = document.getElementById("spectrum-text");
  const complaint = element("span", {id: "spectrum-complaint", role: "alert"});
  const take = (spectrum) => {
    state.spectrum = spectrum;
    complaint.textContent = "";
    compute();
  };
  document.getElementById("spectrum-buttons").append(
    element("button", {id: "take-spectrum", onclick: () => {
      try {
        take(readSpectrum(text.value));
      } catch (error) {
        complaint.textContent = error.message;
      }
    }}, "Take it"),
    element("button", {onclick: () => {
      const {terms, equilibrium_Pa} = state.material.shear;
      const rows = terms.map((term) => `${term.relaxation_time_s},${term.modulus_Pa}`);
      text.value = ["relaxation_time_s,modulus_Pa", ...rows, ...(equilibrium_Pa > 0 ? [`inf,${equilibrium_Pa}`] : [])]
        .join("\n");
      take(undefined);
    }}, "That of the run"),
    complaint);
}
