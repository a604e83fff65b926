/// The measurements that the tasks of a sweep are compared with.

import {data} from "./data.js";
import {mainLoad} from "./loads.js";
import {shortNumber} from "./numbers.js";
import {distinct} from "./records.js";
import {ratioRange} from "./sampling.js";

/// The measured curves, of the quantity G(t).
export function measuredCurves() {
  return data.measurements.map(({stage, measurement, time_s: x, measured_Pa: y}) =>
    ({role: "measured", quantity: "shear", stage, name: measurement, label: `measured, ${measurement}`, x, y}));
}

/// Columns for the table of tasks, [{head, of}]: over each measurement, the modulus of the stage under each boundary.
/// `of` gives the text for the number of a task.
export function ratioColumns(curves) {
  return measuredCurves().flatMap((measured) => {
    const ofStage = curves.filter((curve) => curve.stage === measured.stage && curve.load !== "bulk");
    const load = mainLoad(ofStage.map((curve) => curve.load));
    const tested = ofStage.filter((curve) => curve.load === load);
    return distinct(tested, "boundary").map((boundary) => ({
      head: `${measured.stage} over ${measured.label}, ${boundary}`,
      of: (task) => {
        const curve = tested.find((one) => one.task === task && one.boundary === boundary);
        const range = curve && ratioRange(curve, measured);
        return range === undefined ? "–" : range.map((ratio) => shortNumber(ratio)).join(" to ");
      }}));
  });
}
