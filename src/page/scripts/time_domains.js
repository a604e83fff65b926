/// The times at which the runs of a dynamic test are valid, behind its curves.

import {currentInks} from "./colours.js";
import {study} from "./data.js";
import {isNarrow} from "./figure.js";
import {shortNumber} from "./numbers.js";

/// Marks the times at which each run of a dynamic test is valid, with the mass scaling factor of the run. The test is the
/// first dynamic one of the last stage that is shown.
export function addTimeDomains(layout, shown) {
  const stage = study.stages.findLast((one) => shown.stages.has(one.name) && shown.methods.has("dynamic") &&
    one.tests.some((test) => test.time_domains !== undefined));
  if (stage === undefined) return;
  const load = shown.quantity.name === "bulk" ? "bulk" : "shear";
  const test = stage.tests.find((one) => one.time_domains !== undefined && shown.boundaries.has(one.boundary) &&
    one.load === load);
  if (test === undefined) return;
  const narrow = isNarrow();
  // Room for the labels above the curves.
  const [least, most] = layout.yaxis.range;
  if (!narrow) layout.yaxis.range = [least, most + 0.1 * (most - least)];
  test.time_domains.forEach(({valid_s: [begin, end], density_factor: factor}, i) => {
    layout.shapes.push({type: "rect", xref: "x", yref: "paper", x0: begin, x1: end, y0: 0, y1: 1, layer: "below",
      line: {width: 0}, fillcolor: i % 2 === 0 ? "#4477aa" : "#998866", opacity: 0.13});
    if (narrow) return;
    layout.annotations.push({xref: "x", yref: "paper", x: Math.log10(Math.sqrt(begin * end)),
      y: i % 2 === 0 ? 1 : 0.96, yanchor: "top", showarrow: false, text: `ρ × ${shortNumber(factor)}`,
      font: {size: 10, color: currentInks().faint}});
  });
}
