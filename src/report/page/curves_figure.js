"use strict";

/// The figure with all curves, and the choices of what it shows.

const dashes = {quasistatic: "solid", dynamic: "dash"};

function curvesFigure(curves) {
  const plot = document.getElementById("curve-plot");
  const shown = {
    quantity: quantities.find((quantity) => curves.some((curve) => curve.quantity === quantity.name)),
    stages: new Set(distinct(study.stages, "name")),
    boundaries: new Set(Object.keys(boundNames)),
    methods: new Set(Object.keys(methodNames)),
    loads: new Set(["shear", "shear-xx-yy", "bulk"]),
    grids: new Set(["best"]),
    extras: new Set(["measured", "matrix", "band", "domains"]),
  };

  const isShown = (curve) => {
    if (curve.quantity !== shown.quantity.name) return false;
    if (curve.role === "matrix") return shown.extras.has("matrix");
    if (!shown.stages.has(curve.stage)) return false;
    if (curve.role === "measured") return shown.extras.has("measured");
    const isBest = curve.cells === undefined || curve.cells === bestGrid(curve.stage);
    return shown.boundaries.has(curve.boundary) && shown.loads.has(curve.load) &&
      (curve.method === undefined || shown.methods.has(curve.method)) &&
      ((isBest && shown.grids.has("best")) || shown.grids.has(curve.cells));
  };

  const lineOf = (curve) => {
    if (curve.role === "matrix") return {dash: "dot", width: 1.6};
    if (curve.role === "measured") return {width: 2.8};
    const isFine = curve.cells === undefined || curve.cells === bestGrid(curve.stage);
    if (curve.part === "loss") return {dash: "dash"};
    return {dash: dashes[curve.method] ?? "solid", width: isFine ? 2.2 : 1};
  };

  const draw = () => {
    const layout = layoutOf(shown.quantity, curves.filter(isShown));
    if (shown.extras.has("domains") && shown.quantity.x === "time") addTimeDomains(layout, shown);
    const traces = curves.filter(isShown).flatMap((curve) => {
      const {band, ...plain} = curve;
      return tracesOf(shown.extras.has("band") ? curve : plain, shown.quantity, lineOf(curve));
    });
    const unknown = shown.quantity.x !== "time" ? " From the Prony series, of the grid and method that tell most." : "";
    document.getElementById("curve-note").textContent = noteOn(curves.filter(isShown)) + unknown;
    return Plotly.react(plot, traces, layout, plotOptions);
  };

  document.getElementById("curve-choices").append(...choicesOf(curves, shown, draw));
  const name = () => `${study.title} ${shown.quantity.title}`;
  document.getElementById("curve-buttons").append(
    element("button", {onclick: () => save(fileName(name(), "csv"), csvOf(curves.filter(isShown), shown.quantity),
      "text/csv")}, "These curves as CSV"),
    element("button", {onclick: () => saveFigure(plot, name(), draw)}, "This figure as SVG"));
  listFiles(curves);
  return draw;
}

function noteOn(curves) {
  const notes = [];
  if (curves.some((curve) => curve.method === "dynamic")) notes.push("Dashed: dynamic method.");
  if (curves.some((curve) => curve.part === "loss")) notes.push("Solid G′, dashed G″.");
  if (curves.some((curve) => curve.role === "matrix")) notes.push("Dotted: matrix without particles.");
  if (curves.some((curve) => curve.band !== undefined)) {
    notes.push("Shaded: where the limit of vanishing cells is expected.");
  }
  return notes.join(" ");
}

/// Each choice only where there is something to choose.
function choicesOf(curves, shown, draw) {
  const tests = study.stages.flatMap((stage) => stage.tests);
  const rows = [];
  const select = element("select", {id: "quantity", ariaLabel: "quantity", onchange: () => {
    shown.quantity = quantities.find((quantity) => quantity.name === select.value);
    draw();
  }}, ...quantities.filter((quantity) => curves.some((curve) => curve.quantity === quantity.name))
    .map((quantity) => element("option", {value: quantity.name}, quantity.title)));
  rows.push(select);
  const add = (title, names, isOn) => {
    if (names.length > 1) rows.push(chips(title, names, isOn, draw));
  };
  const named = (values, names) => values.map((value) => [value, names[value] ?? value]);
  add("stage", named(distinct(study.stages, "name"), {}), shown.stages);
  add("bound", named(distinct(tests, "boundary"), boundNames), shown.boundaries);
  add("method", named(distinct(tests, "method"), methodNames), shown.methods);
  add("load", named(distinct(tests, "load").filter((load) => load !== "bulk"),
    {shear: "shear", "shear-xx-yy": "shear xx-yy"}), shown.loads);
  const several = study.stages.some((stage) => stage.cells.length > 1);
  const coarser = gridsOfStudy().filter((grid) => grid !== "extrapolated");
  if (several) add("grid", [["best", "h → 0"], ...coarser.map((grid) => [grid, gridName(grid)])], shown.grids);
  const extras = [["matrix", "matrix"]];
  if (curves.some((curve) => curve.role === "measured")) extras.unshift(["measured", "measured"]);
  if (curves.some((curve) => curve.band !== undefined)) extras.push(["band", "band"]);
  if (tests.some((test) => test.time_domains !== undefined)) extras.push(["domains", "time domains"]);
  rows.push(chips("also", extras, shown.extras, draw));
  return rows;
}

/// Bands where the runs of the first dynamic test of the last stage shown are valid, each with its density factor.
function addTimeDomains(layout, shown) {
  const stage = study.stages.findLast((one) => shown.stages.has(one.name) && shown.methods.has("dynamic") &&
    one.tests.some((test) => test.time_domains !== undefined));
  if (stage === undefined) return;
  const load = shown.quantity.name === "bulk" ? "bulk" : "shear";
  const test = stage.tests.find((one) => one.time_domains !== undefined && shown.boundaries.has(one.boundary) &&
    one.load === load);
  if (test === undefined) return;
  const isNarrow = document.body.clientWidth < 640;
  // Room for the labels above the curves.
  const [least, most] = layout.yaxis.range;
  if (!isNarrow) layout.yaxis.range = [least, most + 0.1 * (most - least)];
  test.time_domains.forEach(({valid_s: [begin, end], density_factor: factor}, i) => {
    layout.shapes.push({type: "rect", xref: "x", yref: "paper", x0: begin, x1: end, y0: 0, y1: 1, layer: "below",
      line: {width: 0}, fillcolor: i % 2 === 0 ? "#4477aa" : "#998866", opacity: 0.13});
    if (isNarrow) return;
    layout.annotations.push({xref: "x", yref: "paper", x: Math.log10(Math.sqrt(begin * end)),
      y: i % 2 === 0 ? 1 : 0.96, yanchor: "top", showarrow: false, text: `ρ × ${shortNumber(factor)}`,
      font: {size: 10, color: currentInks().faint}});
  });
}

function listFiles(curves) {
  const list = document.getElementById("curve-files");
  for (const quantity of quantities) {
    for (const curve of curves.filter((one) => one.quantity === quantity.name)) {
      const name = `${quantity.name}, ${curve.label}`;
      list.append(element("li", {}, element("a", {href: "#curves", onclick: (event) => {
        event.preventDefault();
        save(fileName(name, "csv"), csvOf([curve], quantity), "text/csv");
      }}, name)));
    }
  }
  for (const name of Object.keys(data.tables)) {
    list.append(element("li", {}, element("a", {href: "#curves", onclick: (event) => {
      event.preventDefault();
      save(name, data.tables[name], "text/csv");
    }}, `all of ${name}`)));
  }
}
