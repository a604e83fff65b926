/// The result of a sweep in sentences: the range of the moduli of the tasks, and the task nearest to the measurement.

import {threeTimes} from "./result_sentences.js";
import {mainLoad} from "./loads.js";
import {listed} from "./names.js";
import {display, percent, ratioText} from "./numbers.js";
import {ratioRange, valueAt} from "./sampling.js";

/// The curves of one test that the sentences are about: the main load, the last stage, under the periodic boundary, which
/// comes nearest to the material, before others. A task without that test has none.
export function curvesOfSentences(curves) {
  const order = ["periodic", "displacement", "traction"];
  const load = mainLoad(curves.map((curve) => curve.load));
  const ofLoad = curves.filter((curve) => curve.load === load);
  const {stage, method} = ofLoad.at(-1);
  const ofStage = ofLoad.filter((curve) => curve.stage === stage && curve.method === method);
  const boundary = order.find((one) => ofStage.some((curve) => curve.boundary === one));
  return ofStage.filter((curve) => curve.boundary === boundary);
}

/// The sentences. `curves` are those of one test, one for each task or the mean of several (meansOverSeeds), `symbol` is that of the modulus, `xUnit` the unit of
/// their times or frequencies, `boundary` the boundary condition, `tasks` the number of tasks that are done; `textOnTask`
/// returns a text on the swept values of the task of a curve; `measured` {name, x, y} may be undefined.
export function sweepSentences({curves, symbol, xUnit, boundary, tasks, textOnTask, measured}) {
  const places = threeTimes(curves);
  const ranges = [places[0], places.at(-1)].map((at) => `${rangeAt(curves, at, textOnTask)} at ${display(at, xUnit)}`);
  const known = curves.reduce((sum, {packings}) => sum + (packings ?? 1), 0);
  const part = known < tasks ? `, in ${known} of ${tasks} tasks` : "";
  const sentences = [`${symbol} of ${curves[0].stage}, ${boundary} boundary${part}: ${listed([...new Set(ranges)])}.`];
  const name = `${xUnit === "s" ? "a modulus" : "a |G*|"} (${boundary} boundary)`;
  return measured === undefined ? sentences : [...sentences, ...nearestTo(measured, curves, name, textOnTask)];
}

/// The sentences on packings that differ in their seeds alone: the mean of a modulus over them and the standard deviation
/// of one, and the mean beside what was measured. Arguments as above.
export function seedsSentences({curves, symbol, xUnit, boundary, tasks, measured}) {
  const places = threeTimes(curves);
  const parts = [places[0], places.at(-1)].map((at) => {
    const {mean, deviation} = meanAt(curves, at);
    return `${display(mean, "Pa")} with a standard deviation of ${percent(deviation / mean)} at ${display(at, xUnit)}`;
  });
  const part = curves.length < tasks ? `, ${curves.length} of ${tasks} tasks` : "";
  const sentences = [`${symbol} of ${curves[0].stage}, the mean of ${curves.length} packings${part}, ${boundary} boundary: ` +
    `${listed([...new Set(parts)])}.`, "The deviation is that of one packing, without the error of the grid."];
  const range = measured && ratioRange({x: curves[0].x, y: curves[0].x.map((at) => meanAt(curves, at).mean)}, measured);
  if (range === undefined) return sentences;
  return [...sentences, `The mean is ${ratioText(range)} times what was measured (${measured.name}).`];
}

/// The mean of the curves that are known at a place, and the standard deviation of one of them.
function meanAt(curves, at) {
  const values = curves.map(({x, y}) => valueAt(x, y, at)).filter(Number.isFinite);
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  const squares = values.reduce((sum, value) => sum + (value - mean) ** 2, 0);
  return {mean, deviation: Math.sqrt(squares / (values.length - 1))};
}

/// "1 MPa (gap 10 um) to 3 MPa (gap 1 um)".
function rangeAt(curves, at, textOnTask) {
  const values = curves.map((curve) => ({curve, value: valueAt(curve.x, curve.y, at)}))
    .filter(({value}) => Number.isFinite(value)).sort((one, other) => one.value - other.value);
  const share = ({x, error}) => (error === undefined ? "" : ` ± ${percent(valueAt(x, error, at))}`);
  const words = ({curve, value}) => `${display(value, "Pa")}${share(curve)} (${textOnTask(curve)})`;
  const [least, most] = [values[0], values.at(-1)];
  return least === most ? words(least) : `${words(least)} to ${words(most)}`;
}

/// The task whose largest deviation from the measurement, as a factor, is the smallest, where all tasks are known, and
/// those that are as near as far as the scatter of packings or the errors tell.
function nearestTo({name, x, y}, curves, nameOfModulus, textOnTask) {
  const isCommon = (time) => curves.every((curve) => Number.isFinite(valueAt(curve.x, curve.y, time)));
  const places = [...x.keys()].filter((i) => isCommon(x[i]));
  const isPart = places.length < x.filter((time) => curves.some((one) => Number.isFinite(valueAt(one.x, one.y, time)))).length;
  const measured = {x: places.map((i) => x[i]), y: places.map((i) => y[i])};
  const known = curves.map((curve) => ({curve, range: ratioRange(curve, measured)}))
    .filter(({range}) => range !== undefined).map((one) => ({...one, factor: Math.max(1 / one.range[0], one.range[1])}));
  if (known.length < 2) return [];
  const best = known.reduce((nearest, one) => (one.factor < nearest.factor ? one : nearest));
  const {curve, range} = best;
  const equal = known.filter((one) => one !== best &&
    Math.log(one.factor / best.factor) < Math.hypot(uncertaintyOf(one.curve), uncertaintyOf(curve)));
  const reason = curves.some(({packings}) => packings !== undefined) ? "scatter of the packings" : "errors of both";
  const sentences = [`Nearest to what was measured (${name}) comes ${textOnTask(curve)}, with ${nameOfModulus} of ` +
    `${ratioText(range)} times the measured one${isPart ? ", where all tasks are known" : ""}.`];
  if (equal.length > 0) {
    sentences.push(`As near, within the ${reason}, ${equal.length === 1 ? "comes" : "come"} ` +
      `${listed(equal.map((one) => textOnTask(one.curve)))}.`);
  }
  return sentences;
}

/// The largest error of a curve, over it; 0 where it is not known.
function uncertaintyOf({error}) {
  return Math.max(0, ...(error ?? []));
}
