/// The result of a sweep in sentences: the range of the moduli of the tasks, and the task nearest to the measurement.

import {threeTimes} from "./result_sentences.js";
import {mainLoad} from "./loads.js";
import {listed} from "./names.js";
import {display, shortNumber} from "./numbers.js";
import {ratioRange, valueAt} from "./sampling.js";

/// The curves of one test that the sentences are about: the main load, the last stage, under displacement
/// before others. A task without that test has none.
export function curvesOfSentences(curves) {
  const order = ["displacement", "periodic", "traction"];
  const load = mainLoad(curves.map((curve) => curve.load));
  const ofLoad = curves.filter((curve) => curve.load === load);
  const {stage, method} = ofLoad.at(-1);
  const ofStage = ofLoad.filter((curve) => curve.stage === stage && curve.method === method);
  const boundary = order.find((one) => ofStage.some((curve) => curve.boundary === one));
  return ofStage.filter((curve) => curve.boundary === boundary);
}

/// The sentences. `curves` are those of one test, one for each task, `symbol` is that of the modulus, `boundary` the
/// boundary condition, `tasks` the number of tasks that are done; `textOnTask` returns a text on the swept values of the
/// task of a curve; `measured` {name, x, y} may be undefined.
export function sweepSentences({curves, symbol, boundary, tasks, textOnTask, measured}) {
  const times = threeTimes(curves);
  const ranges = [times[0], times.at(-1)].map((time) => rangeAt(curves, time, textOnTask));
  const part = curves.length < tasks ? `, in ${curves.length} of ${tasks} tasks` : "";
  const sentences = [`${symbol} of ${curves[0].stage}, ${boundary} boundary${part}: ${listed([...new Set(ranges)])}.`];
  return measured === undefined ? sentences : [...sentences, ...nearestTo(measured, curves, boundary, textOnTask)];
}

/// "1 MPa (gap 10 um) to 3 MPa (gap 1 um) at 1 ms".
function rangeAt(curves, time, textOnTask) {
  const values = curves.map((curve) => ({curve, value: valueAt(curve.x, curve.y, time)}))
    .filter(({value}) => Number.isFinite(value)).sort((one, other) => one.value - other.value);
  const words = ({curve, value}) => `${display(value, "Pa")} (${textOnTask(curve)})`;
  const [least, most] = [values[0], values.at(-1)];
  const range = least === most ? words(least) : `${words(least)} to ${words(most)}`;
  return `${range} at ${display(time, "s")}`;
}

/// The task whose largest deviation from the measurement, as a factor, is the smallest, at the times of all tasks.
function nearestTo({name, x, y}, curves, boundary, textOnTask) {
  const isCommon = (time) => curves.every((curve) => Number.isFinite(valueAt(curve.x, curve.y, time)));
  const places = [...x.keys()].filter((i) => isCommon(x[i]));
  const isPart = places.length < x.filter((time) => curves.some((one) => Number.isFinite(valueAt(one.x, one.y, time)))).length;
  const measured = {x: places.map((i) => x[i]), y: places.map((i) => y[i])};
  const known = curves.map((curve) => ({curve, range: ratioRange(curve, measured)}))
    .filter(({range}) => range !== undefined);
  if (known.length < 2) return [];
  const factor = ([least, most]) => Math.max(1 / least, most);
  const {curve, range} = known.reduce((best, one) => (factor(one.range) < factor(best.range) ? one : best));
  const [least, most] = range.map((ratio) => shortNumber(ratio, 2));
  const ratios = least === most ? least : `${least} to ${most}`;
  return [`Nearest to what was measured (${name}) comes ${textOnTask(curve)}, with a modulus (${boundary} boundary) of ` +
    `${ratios} times the measured one${isPart ? ", at the times that all tasks have" : ""}.`];
}
