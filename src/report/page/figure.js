"use strict";

/// What all figures share: colours of the page, axes, buttons, files to keep.

/// On paper the page is light, whatever the screen is.
const printing = {now: false};

function isDark() {
  return !printing.now && matchMedia("(prefers-color-scheme: dark)").matches;
}

const inks = {
  light: {paper: "#ffffff", ink: "#1c2226", faint: "#5b666d", line: "#e2e6e8"},
  dark: {paper: "#14191c", ink: "#e4e9ec", faint: "#9aa7ae", line: "#2b3439"},
};

function currentInks() {
  return isDark() ? inks.dark : inks.light;
}

/// Text for a figure, in which the library would take <b> for bold.
function plotText(text) {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
}

function axisTitle(title, unit) {
  return {text: plotText(unit === "" ? title : `${title} / ${unit}`), standoff: 8};
}

function commonAxis() {
  const {faint, line} = currentInks();
  return {gridcolor: line, linecolor: faint, ticks: "outside", tickcolor: faint, automargin: true, showline: true};
}

/// A logarithmic axis of values in a unit. Times have a unit each, all else has one for the axis.
function logAxis(title, unit, values) {
  const positive = values.filter((value) => value > 0);
  const [least, most] = extent(positive.map(Math.log10));
  const room = 0.04 * (most - least) + 0.02;
  const shown = unit === "s" ? {unit: "", scale: 1} : unitFor(unit, positive);
  const textOf = (value) => unit === "s" ? display(value, "s") : shortNumber(value / shown.scale);
  return {...commonAxis(), type: "log", range: [least - room, most + room], title: axisTitle(title, shown.unit),
    zeroline: false, textOf};
}

/// From the smallest to the largest value, zero among them.
function linearAxis(title, unit, values) {
  const [least, most] = extent([0, ...values]);
  const room = 0.05 * (most - least) || 1;
  const {unit: shown, scale} = unitFor(unit, values);
  return {...commonAxis(), type: "linear", range: [least - room, most + room], title: axisTitle(title, shown),
    zerolinecolor: currentInks().faint, scale};
}

/// Shares of another curve are linear, all else logarithmic.
function valueAxis(quantity, curves) {
  const axis = quantity.unit === "%" ? linearAxis : logAxis;
  return axis(quantity.title, quantity.unit, curves.flatMap((curve) => curve.y));
}

function valueText(value, quantity) {
  return quantity.unit === "%" ? `${shortNumber(value)} %` : display(value, quantity.unit);
}

function layoutOf(quantity, curves) {
  const {paper, ink, faint} = currentInks();
  const isNarrow = document.body.clientWidth < 640;
  const xHover = {s: "%{x:.3~s}s", "rad/s": "%{x:.3~g} rad/s"}[quantity.xUnit] ?? "%{x}";
  return {
    paper_bgcolor: paper, plot_bgcolor: paper, font: {color: ink, size: isNarrow ? 11 : 13},
    margin: {l: isNarrow ? 48 : 70, r: 12, t: 26, b: 48},
    xaxis: {...logAxis(quantity.x, quantity.xUnit, curves.flatMap((curve) => curve.x)), tickCount: isNarrow ? 5 : 12,
      unifiedhovertitle: {text: xHover}},
    yaxis: {...valueAxis(quantity, curves), tickCount: 8}, uirevision: `${quantity.name} ${quantity.title}`,
    hovermode: "x unified", hoverlabel: {bgcolor: paper, bordercolor: faint, font: {color: ink, size: 12}},
    legend: {orientation: "h", traceorder: "normal", y: -0.2, yanchor: "top", font: {size: isNarrow ? 10 : 12}},
    dragmode: isNarrow ? false : "zoom", shapes: [], annotations: [],
  };
}

const plotOptions = {responsive: true, displaylogo: false,
  modeBarButtons: [["zoom2d", "pan2d", "zoomIn2d", "zoomOut2d", "resetScale2d"]]};

/// Draws a figure in its element. What its axes say of their ticks (ticks.js) holds at any zoom; screen readers get a
/// description.
async function drawFigure(plot, traces, layout) {
  const names = [...new Set(traces.filter((trace) => trace.showlegend !== false).map((trace) => trace.name))];
  plot.setAttribute("role", "img");
  plot.setAttribute("aria-label", `${layout.yaxis.title.text} against ${layout.xaxis.title.text}: ${names.join("; ")}`);
  plot.shownLayout = layout;
  await Plotly.react(plot, traces, withTicks(layout), plotOptions);
  await followZoom(plot, layout);
  if (plot.followsZoom) return;
  plot.followsZoom = true;
  plot.on("plotly_relayout", (event) => {
    if (Object.keys(event).some((name) => /axis\d*\.(range|autorange)/.test(name))) followZoom(plot, plot.shownLayout);
  });
}

/// The trace of a curve in a colour, and before it that of its band.
function tracesOf(curve, quantity, line) {
  const common = {x: curve.x, mode: "lines", type: "scatter", name: plotText(curve.label)};
  const traces = [];
  if (curve.band !== undefined) {
    const edge = {...common, hoverinfo: "skip", showlegend: false, line: {width: 0}};
    traces.push({...edge, y: curve.y.map((y, i) => Math.max(y - curve.band[i], 1e-3 * y))});
    traces.push({...edge, y: curve.y.map((y, i) => y + curve.band[i]), fill: "tonexty",
      fillcolor: line.color.replace("hsl", "hsla").replace(")", ", 0.18)")});
  }
  traces.push({...common, y: curve.y, text: curve.y.map((y) => valueText(y, quantity)), hovertemplate: "%{text}",
    line: {width: 2.2, ...line}});
  return traces;
}

/// Makes an element with text or children in it.
function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (name in made) made[name] = value;
    else made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}

/// The figure of a plot as SVG, in the colours of paper.
async function saveFigure(plot, name, draw) {
  printing.now = true;
  await draw();
  const url = await Plotly.toImage(plot, {format: "svg", width: 1000, height: 650});
  printing.now = false;
  await draw();
  const picture = decodeURIComponent(url.slice(url.indexOf(",") + 1));
  const label = plotText(plot.getAttribute("aria-label")).replaceAll('"', "&quot;");
  save(fileName(name, "svg"), picture.replace("<svg ", `<svg role="img" aria-label="${label}" `), "image/svg+xml");
}

/// A row of chips of which each can be on or off; `changed` is called when one changes.
function chips(title, names, isOn, changed) {
  const made = names.map(([value, label]) => {
    const box = element("input", {type: "checkbox", checked: isOn.has(value), onchange: () => {
      if (box.checked) isOn.add(value);
      else isOn.delete(value);
      changed();
    }});
    box.dataset.choice = value;
    return element("label", {className: "chip"}, box, element("span", {}, label));
  });
  return element("fieldset", {}, element("span", {}, title), ...made);
}

/// Draws figures now, and anew where their colours change: with those of the screen, and on paper.
function keepFigures(drawAll) {
  drawAll();
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", drawAll);
  for (const [event, isPrinting] of [["beforeprint", true], ["afterprint", false]]) {
    addEventListener(event, () => {
      printing.now = isPrinting;
      drawAll();
    });
  }
}
