"use strict";

/// What the reader can change in the live figure: which material, its temperature, its spectrum.

const zeroCelsius = 273.15;

function liveChoices(candidates, state, compute) {
  const temperature = element("div", {className: "temperature"});
  const offer = () => temperature.replaceChildren(...temperatureChoice(state, compute));
  offer();
  if (candidates.length === 1) return [temperature];
  const select = element("select", {ariaLabel: "material", onchange: () => {
    Object.assign(state, {material: candidates[select.selectedIndex], spectrum: undefined, decades: 0});
    offer();
    compute();
  }}, ...candidates.map((material) => element("option", {}, material.name)));
  return [select, temperature];
}

/// The slider, and fields for the constants of the law where the deck has none.
function temperatureChoice(state, compute) {
  const known = state.material.temperature_shift;
  const law = {...known};
  const slider = element("input", {type: "range", id: "temperature", ariaLabel: "temperature", step: 0.5});
  const reading = element("output", {});
  const show = () => {
    slider.disabled = !isComplete(law);
    reading.textContent = slider.disabled ? "give the three constants of the WLF law to move it"
      : shiftTo(slider, law, state);
  };
  slider.addEventListener("input", () => {
    show();
    compute();
  });
  const choice = [`Temperature of ${state.material.name}`, slider, reading];
  if (known !== undefined) setRange(slider, law);
  show();
  return known !== undefined ? choice : [constantsOf(law, () => {
    if (isComplete(law)) setRange(slider, law);
    show();
    compute();
  }), ...choice];
}

function isComplete(law) {
  return [law.c1, law.c2_K, law.reference_K].every(Number.isFinite) && law.c1 > 0 && law.c2_K > 0;
}

/// Takes over the temperature of a slider, and says what it does.
function shiftTo(slider, law, state) {
  const celsius = Number(slider.value);
  state.decades = decadesOfShift(law, celsius + zeroCelsius) - decadesOfShift(law, law.temperature_K);
  return `${minus(celsius)} °C, relaxation times × ${shortNumber(10 ** state.decades)}`;
}

/// About the temperature of the run, and well above that at which the law ends.
function setRange(slider, law) {
  const below = 40, above = 60, room = 10;
  const own = Number((law.temperature_K - zeroCelsius).toFixed(2));
  const toPole = law.temperature_K - law.reference_K + law.c2_K;
  slider.min = own - Math.max(0, Math.min(below, Math.floor(toPole - room)));
  slider.max = own + above;
  slider.value = own;
}

function constantsOf(law, changed) {
  const field = (label, take) => {
    const input = element("input", {type: "number", step: "any", ariaLabel: label, oninput: () => {
      take(input.value === "" ? NaN : Number(input.value));
      changed();
    }});
    return element("label", {}, `${label} `, input, " ");
  };
  return element("div", {},
    field("c1", (value) => { law.c1 = value; }),
    field("c2 / K", (value) => { law.c2_K = value; }),
    field("temperature of the run / °C", (value) => { law.reference_K = law.temperature_K = value + zeroCelsius; }));
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
      throw new Error(`line ${i + 1}: expected a relaxation time above 0 and a modulus not below 0, ` +
        `got "${line.trim()}"`);
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
