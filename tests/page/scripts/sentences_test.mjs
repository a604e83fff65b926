/// Tests of the sentences on the first screen of a study.

import assert from "node:assert/strict";
import {test} from "node:test";

import {resultSentences, threeTimes} from "../../../src/page/scripts/result_sentences.js";
import {complexCurves, sampledComplexCurves} from "../../../src/page/scripts/complex_curves.js";
import {complexColumns, complexModuli, complexOf, complexSentences, complexYoungsModuli, measuredColumns, measuredComplex,
  sentenceOnMeasuredComplex} from "../../../src/page/scripts/complex_moduli.js";
import {deviationsFrom} from "../../../src/page/scripts/deviation.js";
import {displayRange, percent, shortNumber, withMicroSign} from "../../../src/page/scripts/numbers.js";
import {mainLoad, shearOf, shearsOf} from "../../../src/page/scripts/loads.js";
import {binderOf, stagesOfInterest} from "../../../src/page/scripts/stages.js";
import {curvesOfSentences, seedsSentences, sweepSentences} from "../../../src/page/scripts/sweep_sentences.js";
import {symbolOf} from "../../../src/page/scripts/names.js";
import {nextStep, onSpace, sentencesOnReliability} from "../../../src/page/scripts/reliability_sentences.js";
import {groupsOfWarnings, lineOnGroup} from "../../../src/page/scripts/warnings.js";

/// A modulus that falls as t^-1/2 from a value at 1 ms, to 10 s.
function falling(boundary, atBegin) {
  const x = Array.from({length: 9}, (_, i) => 1e-3 * 10 ** (i / 2));
  return {boundary, x, y: x.map((time) => atBegin * Math.sqrt(1e-3 / time))};
}

const bounds = [falling("traction", 1e9), falling("displacement", 2e9)];

test("the modulus at the first, the middle and the last time", () => {
  assert.deepEqual(threeTimes(bounds).map((time) => Number(time.toPrecision(6))), [1e-3, 0.1, 10]);
  assert.deepEqual(resultSentences({stage: "mix", symbol: "G(t)", curves: bounds}),
    ["G(t) of mix is 1 to 2 GPa at 1 ms, 100 to 200 MPa at 100 ms and 10 to 20 MPa at 10 s (traction to displacement boundary)."]);
  const [alone] = resultSentences({stage: "cell", symbol: "G(t)", curves: [falling("periodic", 1e6)]});
  assert.equal(alone, "G(t) of cell is 1 MPa at 1 ms, 100 kPa at 100 ms and 10 kPa at 10 s (periodic boundary).");
});

test("beside the binder and the measurement", () => {
  const measured = {name: "Bennett", x: [1e-2, 1e-1], y: [4e8, 1e8]};
  const [, binder, ratio, place] = resultSentences({stage: "mix", symbol: "G(t)", curves: bounds,
    binder: {at: () => 1e6}, measured});
  assert.equal(binder, "That is 1000 to 2000 times its binder at 1 ms and 10 to 20 times its binder at 10 s.");
  // 1e9 sqrt(0.1) / 4e8 = 0.79 and 1e9 / 10 / 1e8 = 1.
  assert.equal(ratio, "From 10 ms to 100 ms the modulus under the traction boundary is 0.79 to 1 times and the modulus " +
    "under the displacement boundary is 1.6 to 2 times what was measured (Bennett).");
  assert.equal(place, "The measurement lies between both at all of these times.");
  const crossing = {name: "Bennett", x: [1e-3, 1e-2, 1e-1, 1], y: [1e8, 4e8, 1.5e8, 1e9]};
  assert.equal(resultSentences({stage: "mix", symbol: "G(t)", curves: bounds, measured: crossing}).at(-1),
    "The measurement lies below both up to 1 ms, between both from 10 ms to 100 ms and above both from 1 s on.");
  const elsewhere = {name: "Bennett", x: [100, 1000], y: [1, 1]};
  assert.equal(resultSentences({stage: "mix", symbol: "G(t)", curves: bounds, measured: elsewhere}).length, 1);
});

test("the whole error of a single curve at each time", () => {
  const curve = falling("periodic", 1e6);
  curve.error = {whole: curve.x.map((time) => (time < 1 ? 0.034 : NaN))};
  const sentence = (curves) => resultSentences({stage: "cell", symbol: "G(t)", curves})[0];
  assert.equal(sentence([curve]),
    "G(t) of cell is 1 MPa ± 3.4 % at 1 ms, 100 kPa ± 3.4 % at 100 ms and 10 kPa at 10 s (periodic boundary).");
  assert.ok(!sentence([{...bounds[0], error: curve.error}, bounds[1]]).includes("±"), "two bounds are a range already");
});

/// A Maxwell element of 2 MPa and 0.1 s: G' = 2e6 x^2 / (1 + x^2), G'' = 2e6 x / (1 + x^2) with x = 0.1 omega.
const relaxed = {stage: "mix", load: "isotropic", boundary: "periodic", x: [1e-3, 10], y: [2e6, 1]};
function dynamic(part, modulus) {
  const x = Array.from({length: 401}, (_, i) => 0.1 * 10 ** (i / 100));
  return {...relaxed, role: "stage", quantity: "dynamic", part, x, y: x.map((omega) => modulus(0.1 * omega))};
}
const maxwell = [dynamic("storage", (x) => 2e6 * x ** 2 / (1 + x ** 2)), dynamic("loss", (x) => 2e6 * x / (1 + x ** 2))];

test("complex moduli, their phase and error at frequencies in hertz", () => {
  const [modulus] = complexModuli(maxwell, [{...relaxed, error: {whole: [0.03, 0.05]}}]);
  const {size, phase} = modulus.at(10 / (2 * Math.PI));
  assert.ok(Math.abs(size / (2e6 / Math.SQRT2) - 1) < 1e-3 && Math.abs(phase - 45) < 0.05);
  const [sentence, binder] = complexSentences({stage: "mix", letter: "G", moduli: [modulus], result: [relaxed], error: "± 5 % by the packing",
    binder: {at: () => complexOf(1e3, 0)}});
  assert.equal(sentence, "|G*| of mix is 20 kPa ± 5 % with a phase of 89° at 15.9 mHz, 1.06 MPa ± 4 % with a phase of " +
    "58° at 1 Hz and 2 MPa ± 3 % with a phase of 0.57° at 159 Hz (periodic boundary; ± 5 % by the packing).");
  assert.equal(binder, "That is 20 times its binder at 15.9 mHz and 2000 times its binder at 159 Hz.");
  const columns = complexColumns("G", modulus, "");
  assert.deepEqual(columns.map(([head]) => head), ["|G*|", "phase", "G′", "G″", "tan δ"]);
  assert.equal(columns[4][1](10 / (2 * Math.PI)), "1");
  assert.deepEqual(complexModuli([], [relaxed]), [], "a stage without a series");
  const elastic = complexModuli([dynamic("storage", () => 2e6), dynamic("loss", () => 0)], [relaxed])[0];
  assert.deepEqual(elastic.at(1), {size: 2e6, phase: 0, storage: 2e6, loss: 0});
  const crossed = ["traction", "displacement"].map((boundary, i) => ({...relaxed, boundary, y: [3e6 - i * 1e6, 1]}));
  const both = crossed.map((curve) => ({...modulus, boundary: curve.boundary}));
  assert.ok(complexSentences({stage: "mix", letter: "G", moduli: both, result: crossed})[0].endsWith("(the modulus under displacement is below that under traction: use neither)."));
  assert.ok(complexSentences({stage: "mix", letter: "G", moduli: both, result: [...crossed].reverse().map((curve, i) => ({...curve,
    boundary: crossed[i].boundary}))})[0].endsWith("(traction to displacement boundary)."));
});

test("a complex modulus beside a measured one", () => {
  const at = (omega) => complexOf(2e6 * (0.1 * omega) ** 2 / (1 + (0.1 * omega) ** 2), 2e6 * 0.1 * omega / (1 + (0.1 * omega) ** 2));
  const curves = complexCurves({...relaxed, role: "stage", label: "mix"}, [0.1, 1000], at);
  assert.deepEqual(curves.map(({quantity}) => quantity), ["dynamic", "dynamic", "absolute", "phase", "loss-factor"]);
  const omegas = [2 * Math.PI, 10, 20 * Math.PI];
  const measured = sampledComplexCurves({role: "measured", stage: "mix", label: "measured, DMA"}, omegas, omegas.map(at));
  const beside = measuredComplex([...curves, ...measured], "mix", "dynamic");
  assert.equal(beside.name, "DMA");
  const [modulus] = complexModuli(curves, [relaxed]);
  assert.equal(modulus.at(10 / (2 * Math.PI)).phase, 45, "the series itself, not between samples");
  assert.equal(sentenceOnMeasuredComplex([modulus], beside, "G"),
    "From 1 Hz to 10 Hz |G*| is 1 and G″ 1 times what was measured (DMA), and the phases are within 0.01°.");
  const columns = measuredColumns("G", [modulus], beside);
  assert.deepEqual(columns.map(([head]) => head), ["measured |G*|", "measured phase", "|G*| over measured"]);
  assert.deepEqual(columns.map(([, text]) => text(10 / (2 * Math.PI))), ["1.41 MPa", "45°", "1.000"]);
  assert.deepEqual(columns.map(([, text]) => text(100)), ["–", "–", "–"]);
  for (const [i, reference] of measured.entries()) {
    const [{x, y}] = deviationsFrom(reference, [curves[i]]);
    assert.deepEqual(x, omegas);
    assert.ok(y.every((deviation) => Math.abs(deviation) < 1e-9), `${reference.label}: ${y}`);
  }
  assert.equal(measuredComplex(curves, "mix", "dynamic"), undefined);
});

test("a complex Young's modulus beside a measured one", () => {
  const omegas = [1, 10, 100].map((frequency) => 2 * Math.PI * frequency);
  const curve = (role, part, size) => ({role, quantity: "young-dynamic", stage: "mix", boundary: "periodic", part,
    label: `measured, DMA, E${part === "loss" ? "″" : "′"}`, x: omegas, y: omegas.map(() => size)});
  const computed = [{...curve("stage", "storage", 3e6), shares: [0.02, 0.02, 0.02]}, curve("stage", "loss", 4e6)];
  const measured = measuredComplex([...computed, curve("measured", "storage", 6e6), curve("measured", "loss", 8e6)], "mix",
    "young-dynamic");
  const relaxation = [{boundary: "periodic", x: [1e-4, 10], y: [5e6, 4e6]}];
  const moduli = complexYoungsModuli(computed);
  assert.equal(sentenceOnMeasuredComplex(moduli, measured, "E"),
    "From 1 Hz to 100 Hz |E*| is 0.5 and E″ 0.5 times what was measured (DMA), and the phases are within 0.01°.");
  assert.ok(Math.abs(moduli[0].errorAt(1) - 0.02) < 1e-9);
  assert.ok(Number.isNaN(complexYoungsModuli([curve("stage", "storage", 3e6), computed[1]])[0].errorAt(1)), "not known");
  assert.ok(complexSentences({stage: "mix", letter: "E", moduli, result: relaxation, error: "± 2 %"})[0].startsWith(
    "|E*| of mix is 5 MPa ± 2 % with a phase of 53° at 1 Hz"));
  assert.deepEqual(complexColumns("E", moduli[0], "").map(([head]) => head), ["|E*|", "phase", "E′", "E″", "tan δ"]);
});

test("bounds that cross, and the error of the grid", () => {
  const crossed = [falling("traction", 3e6), falling("displacement", 2e6)];
  const [text] = resultSentences({stage: "mix", symbol: "G(t)", curves: crossed, error: "± 3 % by the grid"});
  assert.ok(text.endsWith("(the modulus under displacement is below that under traction: use neither; ± 3 % by the grid)."), text);
});

test("a binder that has flowed away, and curves of no time in common", () => {
  const flowing = {at: (time) => 1e6 * Math.exp(-time / 1e-2)};
  const [, ratio] = resultSentences({stage: "mix", symbol: "G(t)", curves: bounds, binder: flowing});
  assert.equal(ratio, "That is 1100 to 2200 times its binder at 1 ms.");
  const apart = [{boundary: "traction", x: [1e-3, 1e-2], y: [2, 2]}, {boundary: "displacement", x: [1, 10], y: [3, 3]}];
  assert.deepEqual(resultSentences({stage: "mix", symbol: "G(t)", curves: apart}),
    ["G(t) of mix is 3 Pa at 1 s (traction to displacement boundary)."]);
  const sample = [{boundary: "periodic", x: [1], y: [2e6]}];
  assert.deepEqual(resultSentences({stage: "mix", symbol: "G(t)", curves: sample}),
    ["G(t) of mix is 2 MPa at 1 s (periodic boundary)."]);
  assert.deepEqual([shortNumber(Infinity), shortNumber(NaN), percent(NaN)], ["–", "–", "–"]);
});

test("a sweep: its range, and the task that is nearest to the measurement", () => {
  const task = (gap, atBegin) => ({...falling("displacement", atBegin), stage: "mix", load: "shear", method: "quasistatic",
    values: {gap}});
  const curves = [task(10, 1e6), task(1, 3e6), task(3, 2e6)];
  const words = {curves, symbol: "G(t)", xUnit: "s", boundary: "displacement", textOnTask: ({values}) => `gap ${values.gap}`};
  assert.deepEqual(sweepSentences(words), ["G(t) of mix, displacement boundary: 1 MPa (gap 10) to 3 MPa (gap 1) at 1 ms and " +
    "10 kPa (gap 10) to 30 kPa (gap 1) at 10 s."]);
  // 2e6 sqrt(0.1) / 8e5 = 0.79 and 2e6 / 10 / 2e5 = 1; the others are off by a factor of 2 and 1.5.
  const measured = {name: "Bennett", x: [1e-2, 1e-1], y: [8e5, 2e5]};
  assert.equal(sweepSentences({...words, measured})[1],
    "Nearest to what was measured (Bennett) comes gap 3, with a modulus (displacement boundary) of 0.79 to 1 times the measured one.");
  // A task with fewer times is compared with the others at its own times.
  const short = {...task(5, 1.9e6), x: curves[0].x.slice(0, 4), y: task(5, 1.9e6).y.slice(0, 4)};
  const late = {name: "Bennett", x: [1e-2, 1e-1], y: [6e5, 6e5]};
  assert.ok(sweepSentences({...words, curves: [...curves, short], measured: late})[1].includes("comes gap 5, with a " +
    "modulus (displacement boundary) of 1 times"));
  assert.ok(sweepSentences({...words, tasks: 4})[0].startsWith("G(t) of mix, displacement boundary, in 3 of 4 tasks: 1 MPa"));
  assert.equal(sweepSentences({...words, curves: curves.slice(1, 2), measured}).length, 1);
  const inFrequency = sweepSentences({...words, symbol: "|G*|", xUnit: "Hz", measured});
  assert.ok(inFrequency[0].startsWith("|G*| of mix, displacement boundary: 1 MPa (gap 10) to 3 MPa (gap 1) at 1 mHz and"));
  assert.ok(inFrequency[1].includes("with a |G*| (displacement boundary) of 0.79 to 1 times the measured one."));
});

test("tasks of a sweep that are as near to what was measured as the nearest", () => {
  const task = (gap, value, error) => ({...falling("periodic", value), stage: "mix", values: {gap}, error: Array(9).fill(error)});
  const words = {symbol: "G(t)", xUnit: "s", boundary: "periodic", textOnTask: ({values}) => `gap ${values.gap}`,
    measured: {name: "Bennett", x: [1e-3, 1e-2], y: [1e6, 1e6 / Math.sqrt(10)]}};
  // Ratios of 1, 1.04 and 1.5, each known within 3 %.
  const curves = [task(1, 1e6, 0.03), task(2, 1.04e6, 0.03), task(3, 1.5e6, 0.03)];
  assert.equal(sweepSentences({...words, curves})[2], "As near, within the errors of both, comes gap 2.");
  assert.equal(sweepSentences({...words, curves: curves.map((curve) => ({...curve, packings: 5}))})[2],
    "As near, within the scatter of the packings, comes gap 2.");
  const well = curves.map((curve) => ({...curve, error: Array(9).fill(0.01)}));
  assert.equal(sweepSentences({...words, curves: well}).length, 2, "the difference is more than the errors");
  const unknown = curves.map(({error, ...curve}) => curve);
  assert.equal(sweepSentences({...words, curves: unknown}).length, 2);
  assert.ok(!sweepSentences({...words, curves: curves.map((curve) => ({...curve, packings: 5})), tasks: 15})[0].includes("of 15"));
});

test("packings that differ in their seeds alone", () => {
  const packing = (factor) => ({...falling("periodic", 1e6 * factor), stage: "mix", load: "shear"});
  // The deviations are those of 0.9, 1 and 1.1; the measured values are half the mean.
  const words = {curves: [0.9, 1, 1.1].map(packing), symbol: "G(t)", xUnit: "s", boundary: "periodic", tasks: 3};
  const {x, y} = packing(0.5);
  assert.deepEqual(seedsSentences({...words, measured: {name: "Bennett", x, y}}), [
    "G(t) of mix, the mean of 3 packings, periodic boundary: 1 MPa with a standard deviation of 10 % at 1 ms and 10 kPa " +
      "with a standard deviation of 10 % at 10 s.",
    "The deviation is that of one packing, without the error of the grid.",
    "The mean is 2 times what was measured (Bennett)."]);
  assert.ok(seedsSentences({...words, tasks: 4})[0].includes("the mean of 3 packings, 3 of 4 tasks, periodic boundary"));
});

test("the test of a sweep that its sentence is about", () => {
  const curve = (stage, load, boundary) => ({stage, load, boundary, method: "quasistatic"});
  const curves = [curve("A", "shear", "displacement"), curve("B", "shear", "traction"), curve("B", "shear", "displacement"),
    curve("B", "bulk", "displacement")];
  assert.deepEqual(curvesOfSentences(curves), [curves[2]]);
  assert.deepEqual(curvesOfSentences(curves.slice(0, 2)), [curves[1]]);
  const periodic = curve("B", "shear", "periodic");
  assert.deepEqual(curvesOfSentences([...curves, periodic]), [periodic]);
});

test("ranges with their units", () => {
  assert.equal(displayRange(1.26e9, 2.2e9, "Pa"), "1.26 to 2.2 GPa");
  assert.equal(displayRange(3.4e8, 1.2e9, "Pa"), "340 MPa to 1.2 GPa");
  assert.equal(displayRange(1e6, 1.0001e6, "Pa"), "1 MPa");
  assert.equal(withMicroSign("the gap, 4.2 um, at 100 us; 3 units"), "the gap, 4.2 µm, at 100 µs; 3 units");
});

test("stages, their matrices and the binder", () => {
  const study = {materials: [{name: "b"}, {name: "f"}],
    stages: [{name: "A", matrix: "b"}, {name: "B", matrix: "A"}, {name: "C", matrix: "b"}]};
  assert.deepEqual(stagesOfInterest(study).map(({name}) => name), ["B", "C"]);
  assert.equal(binderOf(study, "B").name, "b");
});

test("the same warning of several stages stands in one line", () => {
  const warnings = ["b: Poisson's ratio is 0.5", "A: the gap, 500 nm, is 0.52 cells wide; the modulus is too high",
    "B: the gap, 4.2 um, is 1 cell wide; the modulus is too high", "B: only 7 particles"];
  const groups = groupsOfWarnings(warnings, ["A", "B"]);
  assert.deepEqual(groups.map(({texts}) => texts.length), [1, 2, 1]);
  assert.deepEqual(groups.map(lineOnGroup), ["b: Poisson's ratio is 0.5",
    "Stage A: the gap, 500 nm, is 0.52 cells wide; the modulus is too high. Likewise B.", "Stage B: only 7 particles"]);
  const same = ["A: few particles (7 of 30); take more; or not", "B: few particles (7 of 30); take more; or not"];
  assert.deepEqual(groupsOfWarnings(same, ["A", "B"]).map(lineOnGroup), ["Stages A and B: few particles; take more"]);
});

test("the load that is shown as G", () => {
  assert.equal(mainLoad(["bulk", "shear", "isotropic"]), "isotropic");
  assert.equal(mainLoad(["bulk", "shear-xx-yy", "shear"]), "shear");
  assert.equal(mainLoad(["shear-yz", "bulk"]), "shear-yz");
  assert.equal(mainLoad([]), undefined);
  assert.equal(shearOf({tests: [{load: "shear"}, {load: "isotropic"}]}), "isotropic");
  assert.deepEqual(shearsOf({tests: [{load: "isotropic", mean_of: ["shear", "shear-xx-yy"]}]}), ["shear", "shear-xx-yy"]);
  assert.deepEqual(shearsOf({}), ["shear"]);
});

test("the reliability of a stage, from the error estimates of the run", () => {
  const stage = {name: "B", matrix: "A", dimensions: 2, fillers: [{}], cells: [50],
    tests: [{boundary: "displacement"}, {boundary: "traction"}],
    microstructure: {particles: 40, seed: 1, smallest_gap_m: 1e-6, smallest_diameter_m: 2e-5},
    quality: {narrowest_gap_cells: 0.5, grid_error: null, bounds: [{load: "shear",
      first: {time_s: 1e-3, relative_distance: 0.1}, last: {time_s: 1, relative_distance: 0.5}}]}};
  const study = {stages: [{name: "A", microstructure: {largest_diameter_m: 5e-6}}, stage]};
  const text = sentencesOnReliability(study, stage).join("\n");
  for (const words of ["discs bonded", "apart by 10 % at 1 ms and 50 % at 1 s", "1 µm, 0.5 cells wide",
    "one, so its error is not known", "40 particles, placed at random once", "B is 4 times as large"]) {
    assert.ok(text.includes(words), `${words} in ${text}`);
  }
  const byRule = {...stage, quality: {...stage.quality, expected_grid_error: 0.03}};
  assert.ok(sentencesOnReliability(study, byRule).join("\n").includes("one, with an error of 3 % at most by a rule"));
  const ofRange = {...byRule, quality: {...byRule.quality, grid_rule: "by a rule of packings of 52 and 55 %"}};
  assert.ok(sentencesOnReliability(study, ofRange).join("\n").includes("3 % at most by a rule of packings of 52 and 55 %."));
  const measurable = {...byRule, quality: {...byRule.quality, measuring_grids: [25, 50]}};
  assert.ok(sentencesOnReliability(study, measurable).join("\n").includes("by a rule. Two grids, cells = [25, 50], measure it."));
  const ofMean = {...stage, quality: {...stage.quality, anisotropy: {first: {time_s: 1e-3, relative_distance: 0.04},
    last: {time_s: 1, relative_distance: 0.3}}}};
  assert.ok(sentencesOnReliability(study, ofMean).join("\n").includes("which are apart by 4 % at 1 ms and 30 % at 1 s."));
  assert.ok(sentencesOnReliability({...study, frequencies_Hz: [0.159, 159]}, ofMean).join("\n")
    .includes("which are apart by 30 % at 160 mHz and 4 % at 160 Hz."));
  assert.ok(!text.includes("all shears"));
  const without = {...stage, quality: {...stage.quality, grid_rule: "no rule for ellipsoids"}};
  assert.ok(sentencesOnReliability(study, without).join("\n").includes("its error is not known (no rule for ellipsoids)"));
  const apart = {...stage, cells: [20, 21], quality: {...stage.quality, grid_error: 1.5}};
  assert.ok(sentencesOnReliability(study, apart).join("\n").includes("differ too much"));
  const withFlow = {...stage, tests: [{boundary: "displacement", mixing: "flow"}]};
  assert.ok(sentencesOnReliability(study, withFlow).join("\n").includes("flows through gaps narrower than a cell"));
  const image = {...stage, fillers: [{}], microstructure: {...stage.microstructure, pixels: [10, 10]}};
  assert.ok(sentencesOnReliability(study, image).join("\n").includes("the grains of an image bonded"));
  const periodic = {...stage, matrix: "b", dimensions: 3, cells: [32, 64], tests: [{boundary: "periodic"}],
    microstructure: {particles: 1}, quality: {grid_error: 0.02}};
  const other = sentencesOnReliability({stages: [periodic]}, periodic).join("\n");
  for (const words of ["a cube", "repeats without end", "whose error is 2 % at most"]) assert.ok(other.includes(words), other);
  assert.ok(!other.includes("seed") && !other.includes("stages"));
});

test("what both apparent moduli say of a larger body", () => {
  const tests = [{boundary: "displacement"}, {boundary: "traction"}];
  const stage = {name: "mix", dimensions: 2, cells: [100], tests, microstructure: {particles: 1}, quality: {}};
  const study = {stages: [stage]};
  const saying = (quality) => sentencesOnReliability(study, {...stage, quality}).join("\n");
  assert.ok(saying({}).includes("No particle crosses the sides, so they are no bounds"));
  assert.ok(saying({filler_on_sides: 0.46}).includes("The sides cut filler over 46 % of them"));
  assert.ok(saying({filler_on_sides: 0}).includes("They are an upper and a lower bound"));
});

test("what two dimensions leave out", () => {
  const packed = {dimensions: 2, microstructure: {}};
  assert.equal(onSpace({}, {...packed, dimensions: 3}), "");
  assert.equal(onSpace({}, {dimensions: 2}), "");
  assert.match(onSpace({}, packed), /parallel cylinders, in two dimensions; .* no rule says which/);
  assert.equal(onSpace({}, {...packed, quality: {spheres_over_discs: {time_s: 1, ratio: 1.52}}}),
    "This is the modulus of discs in two dimensions; that of spheres would be up to about 1.5 times as large (at 1 s).");
});

test("the next step about the error", () => {
  const step = (quality, cells = [100]) => nextStep({cells, quality});
  assert.equal(step({measuring_grids: [50, 100]}), "Next: cells = [50, 100] in the deck measures the error of the grid.");
  assert.equal(step({largest_error: 0.08, largest_sample_error: 0.07}),
    'Next: for half of this error, accuracy = "4 %" in [tests], in place of box and cells; breccia check says how long ' +
    "that takes.");
  assert.equal(step({largest_error: 0.08, largest_sample_error: 0.07, error_asked: 0.1}), "", "what was asked for");
  assert.equal(step({largest_error: 0.08, largest_sample_error: 0}), "", "a regular array has no other packing");
  assert.equal(step({largest_error: 0.05, largest_sample_error: 0.04}), "");
  assert.equal(step({measuring_grids: [12, 24], grid_rule: "too few cells for a rule"}),
    "Next: more cells; breccia check says how many the gaps take.");
  assert.equal(nextStep({cells: [100], quality: {filler_on_sides: 0.4}, tests: [{boundary: "displacement"}]}),
    'Next: boundaries = ["periodic"] in [tests], whose modulus comes nearest to that of the material.');
  assert.equal(step({}, ["films"]), "");
  assert.equal(step({}), "");
});

test("a shear among several has its name", () => {
  assert.equal(symbolOf("shear", ["shear", "bulk"]), "G(t)");
  assert.equal(symbolOf("shear", ["shear", "shear-xx-yy"]), "G(t) in shear xy, one of several shears,");
  assert.equal(symbolOf("isotropic", ["shear", "shear-xx-yy", "isotropic"]), "G(t)");
});
