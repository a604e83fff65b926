/// The controls of the live figure: which material the reader changes, its temperature and its spectrum, or the moduli
/// of an elastic one. They change `state`, {material, spectrum, bulk, pasted, decades}, and then call `compute`; `pasted` is a spectrum
/// that the reader has given.

import {element} from "./elements.js";
import {display, minus, shortNumber} from "./numbers.js";
import {readSpectrum} from "./spectrum_text.js";
import {decadesOfShift, temperaturesOfLaw} from "./viscoelasticity.js";

const zeroCelsius = 273.15;

export function liveChoices(candidates, state, compute) {
  const temperature = element("div", {className: "temperature"});
  const offer = () => temperature.replaceChildren(...(hasModuliToMove(state.material) ? moduliChoice(state, compute)
    : temperatureChoice(state, compute)));
  offer();
  if (candidates.length === 1) return [temperature];
  const select = element("select", {id: "material", ariaLabel: "material", onchange: () => {
    Object.assign(state, {material: candidates[select.selectedIndex], spectrum: undefined, bulk: undefined,
      pasted: undefined, decades: 0});
    offer();
    compute();
  }}, ...candidates.map((material) => element("option", {}, material.name)));
  return [select, temperature];
}

/// Whether a range of moduli [Pa] is wider than that of a single sampled modulus (sampledRange in response.js).
export function isWide([least, most]) {
  return most > 1.3 * least;
}

/// Whether the material is elastic, and the responses of its boxes have been sampled for other moduli of it.
export function hasModuliToMove({ranges, shear, bulk}) {
  return ranges !== undefined && shear.terms.length === 0 && bulk.terms.length === 0 &&
    (isWide(ranges.shear) || isWide(ranges.bulk));
}

/// Sliders of those moduli of an elastic material that the run has sampled over a range.
function moduliChoice(state, compute) {
  const {name, ranges, shear, bulk} = state.material;
  const take = {shear: (series) => { state.spectrum = series; }, bulk: (series) => { state.bulk = series; }};
  const own = {shear: shear.equilibrium_Pa, bulk: bulk.equilibrium_Pa};
  return ["shear", "bulk"].filter((modulus) => isWide(ranges[modulus])).flatMap((modulus) => {
    const [least, most] = ranges[modulus];
    const slider = element("input", {type: "range", id: `${modulus}-modulus`, ariaLabel: `${modulus} modulus`,
      min: Math.log10(Math.max(least, 1e-9 * most)), max: Math.log10(most), step: "any"});
    slider.value = Math.log10(own[modulus]);
    const reading = element("output", {}, display(own[modulus], "Pa"));
    slider.addEventListener("input", () => {
      const equilibrium_Pa = 10 ** Number(slider.value);
      reading.textContent = display(equilibrium_Pa, "Pa");
      take[modulus]({equilibrium_Pa, terms: []});
      compute();
    });
    return [`${modulus === "shear" ? "Shear" : "Bulk"} modulus of ${name}`, slider, reading];
  });
}

/// The slider of the temperature, and fields for the constants of the WLF law if the deck has none.
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
  return law.temperatures_K !== undefined ||
    ([law.c1, law.c2_K, law.reference_K].every(Number.isFinite) && law.c1 > 0 && law.c2_K > 0);
}

/// Shifts the material to the temperature of the slider, and returns a text on the effect.
function shiftTo(slider, law, state) {
  const celsius = Number(slider.value);
  // The values of the slider are round, the ends of a table need not be.
  const [coldest, hottest] = temperaturesOfLaw(law);
  const temperature = Math.min(Math.max(celsius + zeroCelsius, coldest), hottest);
  state.decades = decadesOfShift(law, temperature) - decadesOfShift(law, law.temperature_K);
  return `${minus(celsius)} °C, relaxation times × ${shortNumber(10 ** state.decades)}`;
}

/// The range of the slider: about the temperature of the run, and within the meaning of the law.
function setRange(slider, law) {
  const below = 40, above = 60;
  const ofRun = Number((law.temperature_K - zeroCelsius).toFixed(2));
  const [coldest, hottest] = temperaturesOfLaw(law).map((temperature) => temperature - zeroCelsius);
  // The steps are whole degrees from the temperature of the run.
  slider.min = ofRun - Math.max(0, Math.min(below, Math.floor(ofRun - coldest)));
  slider.max = ofRun + Math.max(0, Math.min(above, Math.floor(hottest - ofRun)));
  slider.value = ofRun;
}

/// Fields for the constants of the law, which they change before they call `changed`.
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

/// Shows a spectrum that was found for the material of the state, where the reader would have given it: the slider of a
/// modulus, or the text of the spectrum.
export function showSpectrum(spectrum) {
  const slider = document.getElementById("shear-modulus");
  if (spectrum.terms.length === 0 && slider !== null) {
    slider.value = Math.log10(spectrum.equilibrium_Pa);
    slider.nextElementSibling.textContent = display(spectrum.equilibrium_Pa, "Pa");
  } else {
    document.getElementById("spectrum-text").value = spectrumText(spectrum);
  }
}

/// A spectrum as readSpectrum() reads it.
function spectrumText({terms, equilibrium_Pa}) {
  const rows = terms.map((term) => `${term.relaxation_time_s},${term.modulus_Pa}`);
  return ["relaxation_time_s,modulus_Pa", ...rows, ...(equilibrium_Pa > 0 ? [`inf,${equilibrium_Pa}`] : [])].join("\n");
}

/// The buttons below the text of the spectrum.
export function spectrumButtons(state, compute) {
  const text = document.getElementById("spectrum-text");
  const complaint = element("span", {id: "spectrum-complaint", role: "alert"});
  const take = (spectrum) => {
    Object.assign(state, {spectrum, bulk: undefined, pasted: spectrum});
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
      text.value = spectrumText(state.material.shear);
      take(undefined);
    }}, "That of the run"),
    complaint);
}
