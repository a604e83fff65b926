/// The measurements that the tasks of a sweep are compared with.

import {inHertz, sampledComplexCurves} from "./complex_curves.js";
import {data} from "./data.js";
import {mainLoad} from "./loads.js";
import {shortNumber} from "./numbers.js";
import {distinct} from "./records.js";
import {ratioRange} from "./sampling.js";

function commonOf({stage, measurement}) {
  return {role: "measured", stage, name: measurement, label: `measured, ${measurement}`};
}

/// The measured curves, of the quantity G(t), and of those of the complex modulus over the frequency in hertz.
export function measuredCurves() {
  const inTime = data.measurements.map((one) => ({...commonOf(one), quantity: "shear", x: one.time_s, y: one.measured_Pa}));
  const inFrequency = data.measurements_in_frequency.flatMap((one) => inHertz(sampledComplexCurves(commonOf(one),
    one.angular_frequency_rad_per_s, one.measured_storage_modulus_Pa.map((storage, i) =>
      ({storage, loss: one.measured_loss_modulus_Pa[i]})))));
  return [...inTime, ...inFrequency];
}

/// Columns for the table of tasks, [{head, of}]: over each measurement, the modulus of the stage under each boundary, in
/// frequency its absolute value. `of` gives the text for the number of a task.
export function ratioColumns(curves) {
  const isComplex = curves.some(({quantity}) => quantity === "absolute");
  const compared = isComplex ? "absolute" : "shear";
  return measuredCurves().filter(({quantity}) => quantity === compared).flatMap((measured) => {
    const ofStage = curves.filter((curve) => curve.stage === measured.stage && curve.quantity === measured.quantity);
    const load = mainLoad(ofStage.map((curve) => curve.load));
    const tested = ofStage.filter((curve) => curve.load === load);
    const symbol = isComplex ? "|G*| of " : "";
    return distinct(tested, "boundary").map((boundary) => ({
      head: `${symbol}${measured.stage} over ${measured.label}, ${boundary}`,
      of: (task) => {
        const curve = tested.find((one) => one.task === task && one.boundary === boundary);
        const range = curve && ratioRange(curve, measured);
        return range === undefined ? "–" : [...new Set(range.map((ratio) => shortNumber(ratio)))].join(" to ");
      }}));
  });
}
