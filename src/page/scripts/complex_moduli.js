/// The complex moduli of a stage at frequencies in hertz: the result of a study whose deck gives frequencies.

import {display, displayRange, percent, shortNumber} from "./numbers.js";
import {listed} from "./names.js";
import {valueAt} from "./sampling.js";
import {areCrossed, crossedText, textOnBoundaries, threeTimes} from "./result_sentences.js";

const perCycle = 2 * Math.PI;

/// The complex moduli of a result, one for each boundary: {boundary, x, at, errorAt} with the frequencies x [Hz], the
/// modulus {size, phase, storage, loss} at one of them [Pa, degrees], and its error, that of the relaxation modulus at
/// the time 1/omega (NaN where it is not known). `result` are the relaxation moduli; `curves` all curves of the study.
export function complexModuli(curves, result) {
  return result.flatMap((modulus) => {
    const part = (name) => curves.find((curve) => curve.role === "stage" && curve.quantity === "dynamic" &&
      curve.part === name && ["stage", "load", "boundary"].every((key) => curve[key] === modulus[key]));
    const [storage, loss] = [part("storage"), part("loss")];
    if (storage === undefined || loss === undefined) return [];
    const value = ({x, y}, frequency) => valueAt(x, y, perCycle * frequency);
    return [{boundary: modulus.boundary, x: storage.x.map((frequency) => frequency / perCycle),
      at: storage.modulusAt === undefined
        ? (frequency) => complexOf(value(storage, frequency), value(loss, frequency))
        : (frequency) => storage.modulusAt(perCycle * frequency),
      errorAt: (frequency) => (modulus.error === undefined ? NaN
        : valueAt(modulus.x, modulus.error.whole, 1 / (perCycle * frequency)))}];
  });
}

/// A complex modulus {size, phase, storage, loss}, the phase in degrees.
export function complexOf(storage, loss) {
  return {size: Math.hypot(storage, loss), phase: Math.atan2(loss, storage) * 180 / Math.PI, storage, loss};
}

function rangeOf(values) {
  return [Math.min(...values), Math.max(...values)];
}

function phaseText(phases) {
  const [from, to] = rangeOf(phases).map((phase) => shortNumber(phase, 2));
  return `${from === to ? from : `${from} to ${to}`}°`;
}

/// "± 3.4 %" of a single modulus; empty for several, and where it is not known.
function errorText(moduli, frequency) {
  const share = moduli.length === 1 ? moduli[0].errorAt(frequency) : NaN;
  return Number.isFinite(share) ? ` ± ${percent(share)}` : "";
}

/// The sentences on complex moduli of a letter, G or E; `result` are the relaxation moduli that belong to them, `error`
/// is a text on their errors, `binder` {at} has the binder's complex modulus.
export function complexSentences({stage, letter, moduli, result, error, binder}) {
  const frequencies = threeTimes(moduli);
  const isCrossed = areCrossed(result, frequencies.map((frequency) => 1 / (perCycle * frequency)));
  const parts = frequencies.map((frequency) => {
    const here = moduli.map(({at}) => at(frequency));
    return `${displayRange(...rangeOf(here.map(({size}) => size)), "Pa")}${errorText(moduli, frequency)} with a phase of ` +
      `${phaseText(here.map(({phase}) => phase))} at ${display(frequency, "Hz")}`;
  });
  const boundaries = isCrossed ? crossedText : textOnBoundaries(moduli);
  const remarks = [boundaries, error].filter(Boolean).join("; ");
  const sentences = [`|${letter}*| of ${stage} is ${listed(parts)} (${remarks}).`];
  if (binder !== undefined) {
    const ratios = [frequencies[0], frequencies.at(-1)].map((frequency) => {
      const [from, to] = rangeOf(moduli.map(({at}) => at(frequency).size / binder.at(frequency).size))
        .map((ratio) => shortNumber(ratio, 2));
      return `${from === to ? from : `${from} to ${to}`} times its binder at ${display(frequency, "Hz")}`;
    });
    sentences.push(`That is ${listed([...new Set(ratios)])}.`);
  }
  return sentences;
}

/// Whether a table of one complex modulus shows its error.
export function showsError(modulus) {
  return modulus.x.some((frequency) => Number.isFinite(modulus.errorAt(frequency)));
}

/// The columns [head, text at a frequency] of a table of one complex modulus of a letter, G or E; `name` is that of its
/// boundary, or empty.
export function complexColumns(letter, modulus, name) {
  const head = (symbol) => (name === "" ? symbol : `${symbol}, ${name}`);
  const columns = [[`|${letter}*|`, ({size}) => display(size, "Pa")], ["phase", ({phase}) => `${shortNumber(phase, 3)}°`],
    [`${letter}′`, ({storage}) => display(storage, "Pa")], [`${letter}″`, ({loss}) => display(loss, "Pa")],
    ["tan δ", ({storage, loss}) => shortNumber(loss / storage, 3)]];
  return columns.map(([symbol, text], i) => [head(symbol), (frequency) =>
    text(modulus.at(frequency)) + (i === 0 ? errorText([modulus], frequency) : "")]);
}

/// The complex Young's moduli [{boundary, x, at, errorAt}], as complexModuli(), of their storage and loss moduli; the
/// former have the `shares` of the errors at their frequencies.
export function complexYoungsModuli(curves) {
  const storages = curves.filter(({part}) => part === "storage");
  return storages.map((storage) => {
    const loss = curves.find(({part, boundary}) => part === "loss" && boundary === storage.boundary);
    return {boundary: storage.boundary, x: storage.x.map((frequency) => frequency / perCycle),
      at: (frequency) => complexOf(...[storage, loss].map(({x, y}) => valueAt(x, y, perCycle * frequency))),
      errorAt: (frequency) => (storage.shares === undefined ? NaN
        : valueAt(storage.x, storage.shares, perCycle * frequency))};
  });
}

/// The measured complex modulus of a stage beside computed ones: {name, x, moduli} with the frequencies x [Hz], from its
/// curves of the quantity "dynamic" or "young-dynamic"; undefined where nothing was measured in frequency.
export function measuredComplex(curves, stage, quantityOf) {
  const of = (name) => curves.find(({role, quantity, part, stage: its}) => role === "measured" &&
    quantity === quantityOf && part === name && its === stage);
  const [storage, loss] = [of("storage"), of("loss")];
  if (storage === undefined) return undefined;
  return {name: storage.label.replace("measured, ", "").replace(/, [GE]′$/, ""),
    x: storage.x.map((omega) => omega / perCycle), moduli: storage.y.map((value, i) => complexOf(value, loss.y[i]))};
}

/// The ratios of the absolute value and of the loss modulus of a computed complex modulus to the measured ones, and the
/// difference of the phases [degrees], at each measured frequency.
function deviationsFrom(measured, {at}) {
  return measured.x.map((frequency, i) => {
    const [computed, reference] = [at(frequency), measured.moduli[i]];
    return {ratio: computed.size / reference.size, loss: lossOf(computed) / lossOf(reference),
      phase: computed.phase - reference.phase};
  });
}

function lossOf({size, phase}) {
  return size * Math.sin(phase * Math.PI / 180);
}

/// A sentence on complex moduli beside a measured one, of a letter: G or E; empty where they have no frequency in common.
export function sentenceOnMeasuredComplex(moduli, measured, letter) {
  const found = moduli.flatMap((modulus) => deviationsFrom(measured, modulus)).filter(({ratio}) => Number.isFinite(ratio));
  if (found.length === 0) return "";
  const [sizes, losses] = [({ratio}) => ratio, ({loss}) => loss].map((part) => {
    const [from, to] = rangeOf(found.map(part).filter(Number.isFinite)).map((ratio) => shortNumber(ratio, 3));
    return from === to ? from : `${from} to ${to}`;
  });
  const largest = Math.max(...found.map(({phase}) => Math.abs(phase)));
  const [first, last] = [measured.x[0], measured.x.at(-1)].map((frequency) => display(frequency, "Hz", 2));
  return `From ${first} to ${last} |${letter}*| is ${sizes} and ${letter}″ ${losses} times what was measured ` +
    `(${measured.name}), and the phases are within ${shortNumber(Math.max(largest, 0.01), 2)}°.`;
}

/// The columns [head, text at a frequency] of a measured complex modulus of a letter, G or E, in the table of computed
/// ones, where it is known. Between measured frequencies the ratio is interpolated.
export function measuredColumns(letter, moduli, measured) {
  const at = (values, frequency) => valueAt(measured.x, values, frequency);
  const text = (value, shown) => (Number.isFinite(value) ? shown(value) : "–");
  const ratios = moduli.map((modulus) => deviationsFrom(measured, modulus).map(({ratio}) => ratio));
  return [[`measured |${letter}*|`, (frequency) => text(moduli[0].at(frequency).size / at(ratios[0], frequency), (size) =>
    display(size, "Pa"))],
  ["measured phase", (frequency) => text(at(measured.moduli.map(({phase}) => phase), frequency), (phase) =>
    `${shortNumber(phase, 3)}°`)],
  [`|${letter}*| over measured`, (frequency) => text(at(ratios[0], frequency), () =>
    [...new Set(ratios.map((values) => at(values, frequency).toFixed(3)))].join(" … "))]];
}
