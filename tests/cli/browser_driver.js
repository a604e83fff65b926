"use strict";

// What the reader of tests/cli/browser-test does. It goes by what is on the page, as far as it can.
const complaints = [];
addEventListener("error", (event) => complaints.push(event.message));
addEventListener("unhandledrejection", (event) => complaints.push(String(event.reason)));
document.addEventListener("securitypolicyviolation", (event) => complaints.push(`fetches ${event.blockedURI}`));
for (const level of ["error", "warn"]) console[level] = (...words) => complaints.push(words.join(" "));

const seen = [];
/// Texts have blanks that break no line (unbroken of numbers.js); what is seen has common ones.
const see = (what, value) => seen.push(`${what}: ${String(value).replaceAll("\u00a0", " ")}`);
const wait = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
const at = (id) => document.getElementById(id);

/// What the page has handed to the reader as files, the last one at the end.
const saved = [];
window.Blob = class extends Blob {
  constructor(parts, options) {
    super(parts, options);
    saved.push(parts.join(""));
  }
};

function savedBy(text) {
  [...document.querySelectorAll("button, #curve-files a")].find((one) => one.textContent === text).click();
  return saved.at(-1);
}

const tickTexts = (plot, axis) => at(plot)._fullLayout[axis].ticktext.join(" ");

/// What the page draws of the load at a share of its ramp from the middle.
function loadAt(share) {
  const {x, y} = at("runs-plot").data.find((trace) => trace.name === "load");
  const {study} = JSON.parse(at("data").textContent);
  const {ramp_s: ramp} = study.stages[0].tests.find((test) => test.time_domains).time_domains.at(-1);
  return y[x.findIndex((time) => Math.abs(time / ramp - share) < 1e-6)];
}

const shownTraces = (start) => at("curve-plot").data.filter((trace) => trace.name.startsWith(start)).length;

/// The value at 10 ms of the curve of a stage that the page has computed.
function liveModulus(stage) {
  const trace = at("live-plot").data.find((one) => one.name === `${stage}, displacement`);
  const right = trace.x.findIndex((time) => time > 0.01);
  const share = Math.log(0.01 / trace.x[right - 1]) / Math.log(trace.x[right] / trace.x[right - 1]);
  return trace.y[right - 1] * Math.pow(trace.y[right] / trace.y[right - 1], share);
}

function choose(id, text) {
  const select = at(id);
  select.selectedIndex = [...select.options].findIndex((option) => option.textContent === text);
  select.dispatchEvent(new Event("change"));
}

function move(slider, value) {
  slider.value = value;
  slider.dispatchEvent(new Event("input"));
}

async function paste(text) {
  at("spectrum-text").value = text;
  at("take-spectrum").click();
  await wait(100);
  return at("spectrum-complaint").textContent;
}

/// The page of a fit.
async function lookAtFit() {
  see("title", document.querySelector("h1").textContent);
  const master = () => at("master-plot");
  see("sweeps", new Set(master().data.filter(({mode}) => mode === "markers").map(({name}) => name)).size);
  see("axis of the master curve", master().layout.xaxis.title.text);
  const [before] = master().data[0].x;
  move(at("reference"), 29);
  await wait(100);
  see("axis at another reference", master().layout.xaxis.title.text);
  see("shift of the master curve", master().data[0].x[0] / before);
  see("figures of the fit", [...document.querySelectorAll(".plot")].filter((plot) => plot.data?.length > 0).length);
}

/// The page of a sweep.
async function lookAtSweep() {
  see("title", document.querySelector("h1").textContent);
  see("curves", at("curve-plot").data.length);
  see("answer", at("answer").textContent.replace(/\d[\d.]*/g, "x").replace(/[kM]Pa/g, "Pa"));
  see("measured in the sweep", at("curve-plot").data.at(-1).name.replace("&lt;", "<"));
  see("ratios to the measurement", [...document.querySelectorAll("#task-table th")].filter((one) =>
    one.textContent.includes("over measured")).length);
  see("links", document.querySelectorAll('#task-table a[href$="/report.html"]').length);
  const last = at("key-plot").data.map((trace) => trace.y.at(-1));
  move(at("key-slider"), 0);
  await wait(100);
  see("slider moves the time", at("key-plot").data.every((trace, i) => trace.y.at(-1) > last[i]));
  see("cells along the axis", tickTexts("key-plot", "xaxis"));
  choose("reference", "deviation from cells 12");
  await wait(100);
  see("curves compared", at("curve-plot").data.length);
  see("coarse cells are stiffer", at("curve-plot").data.every((trace) => trace.y.length > 0 &&
    trace.y.every((value) => value > 0)));
}

function showQuantity(name) {
  at("quantity").value = name;
  at("quantity").dispatchEvent(new Event("change"));
}

/// The first screen has the result of the last stage; the other stage can be added.
async function lookAtStages() {
  see("title", document.querySelector("h1").textContent);
  see("answer", at("answer").textContent.split(" at ")[0].replace(/[\d.]+/g, "x"));
  see("warnings", [...document.querySelectorAll("#warnings > li")].length);
  see("picture beside the figure", document.querySelector("#result-picture figcaption").textContent.split(":")[0]);
  see("rows of moduli", document.querySelectorAll("#moduli tbody tr").length);
  const {annotations} = at("curve-plot")._fullLayout;
  see("names at the ends", annotations.map(({text}) => text.replaceAll("<br>", " ").replace("&lt;", "<")).filter((text) =>
    !text.startsWith("ρ")).join("; "));
  see("area between the bounds", at("curve-plot").data.filter(({fill}) => fill === "toself").length);
  see("curves of stage A at first", shownTraces("A, "));
  document.querySelector('input[data-choice="A"]').click();
  await wait(100);
  see("curves of stage A when it is on", shownTraces("A, "));
}

/// What was measured stands in the figure, in the tables and in what is saved.
function lookAtMeasurement() {
  see("measured curve", at("curve-plot").data.some((trace) => trace.name === 'measured, Bennett et al., "1998" <2>'
    .replace("<", "&lt;") && trace.y.every((value) => value > 0)));
  see("figure for those who hear", at("curve-plot").getAttribute("role") + ", " +
    at("curve-plot").getAttribute("aria-label").split(":")[0]);
  see("legend of figure", [...at("curve-plot").querySelectorAll(".legendtext")].some((one) =>
    one.textContent.endsWith('Bennett et al., "1998" <2>')));
  see("times", tickTexts("curve-plot", "xaxis"));
  see("table of the measurement", [...document.querySelectorAll("#comparison-tables h3")].map((one) => one.textContent)
    .filter((text) => text.includes("Bennett")).join("; "));
  const file = savedBy("These curves as CSV");
  see("curve as CSV", file.split("\n").find((line) => line.includes("Bennett")).replace(/,[^,]*,[^,]*$/, ""));
  see("table as CSV", savedBy("all of comparison.csv").split("\n")[1].replace(/,[\d.e+-]+(,[\d.e+-]*)*$/, ""));
  see("how good", document.querySelector("#quality-summary li").textContent.split(",")[0]);
}

async function zoomInTime() {
  await Plotly.relayout(at("curve-plot"), {"xaxis.range": [Math.log10(0.02), Math.log10(0.05)]});
  await wait(100);
  see("times when zoomed", tickTexts("curve-plot", "xaxis"));
  await Plotly.relayout(at("curve-plot"), {"xaxis.range": [Math.log10(0.9e-3), Math.log10(0.055)]});
  await wait(100);
}

async function hoverOverCurve() {
  const pane = at("curve-plot").querySelector(".nsewdrag");
  pane.scrollIntoView({block: "center"});
  const {left, top, width, height} = pane.getBoundingClientRect();
  const pointer = {bubbles: true, clientX: left + width / 2, clientY: top + height / 2};
  pane.dispatchEvent(new MouseEvent("mouseover", pointer));
  pane.dispatchEvent(new MouseEvent("mousemove", pointer));
  await wait(500);
  const hover = at("curve-plot").querySelector(".hoverlayer").textContent;
  const texts = at("curve-plot").data.find((trace) => trace.name.startsWith("A, displacement")).text;
  see("hover tells the curve", hover.includes("A, displacement") && texts.some((text) => hover.includes(text)));
}

async function lookAtStorageModulus() {
  showQuantity("dynamic");
  await wait(100);
  see("storage modulus", at("curve-plot").data.some((trace) => trace.name.includes("G′")));
  const picture = decodeURIComponent(await Plotly.toImage(at("curve-plot"), {format: "svg"}));
  see("figure as SVG", picture.includes("<svg"));
}

/// The same over the frequency in Hz, and over the temperature at one frequency.
async function lookAtAxes() {
  const titleOfAxis = () => at("curve-plot").layout.xaxis.title.text;
  const frequencies = titleOfAxis();
  at("axis").value = "temperature";
  at("axis").dispatchEvent(new Event("change"));
  await wait(100);
  see("axes", `${frequencies}; ${titleOfAxis()} at ${at("abscissa").value} Hz`);
  const storage = at("curve-plot").data.find((trace) => trace.name === "B, displacement, G′");
  see("softer when warmer", storage.x.every((celsius, i) => i === 0 || (celsius > storage.x[i - 1] &&
    storage.y[i] <= storage.y[i - 1])));
}

async function lookAtDeviation() {
  showQuantity("shear");
  choose("reference", "deviation from A, displacement, quasi-static");
  await wait(100);
  const deviation = at("curve-plot").data.find((trace) => trace.name === "A, displacement, dynamic");
  see("dynamic within a per cent", deviation.y.length > 0 && deviation.y.every((value) => Math.abs(value) < 1));
}

/// The runs of the dynamic method, with the load on them.
async function lookAtRuns() {
  const runs = () => at("runs-plot").data;
  see("runs of the dynamic method", runs().some((trace) => trace.name.startsWith("ρ × ") && trace.x[0] > 0));
  choose("runs-axis", "linear time, with the load");
  await wait(100);
  for (const share of [-0.25, 0, 0.25, 0.35]) see(`load at ${share} of the ramp`, loadAt(share));
  see("linear time", `${tickTexts("runs-plot", "xaxis")}; ${at("runs-plot").layout.xaxis.title.text}`);
  see("load beside the runs", runs().some((trace) => trace.name === "load" && Math.max(...trace.y) === 1));
}

/// The curves that the page computes itself at other temperatures of the binder.
async function changeTemperature() {
  see("agreement", at("live-note").dataset.agreement);
  for (const stage of ["A", "B"]) see(`${stage} at 19 C`, liveModulus(stage));
  move(at("temperature"), 25);
  await wait(100);
  for (const stage of ["A", "B"]) see(`${stage} at 25 C`, liveModulus(stage));
  see("refusals at 25 C", at("live-refusals").childElementCount);
  move(at("temperature"), 79);
  await wait(100);
  for (const stage of ["A", "B"]) see(`${stage} at 79 C`, liveModulus(stage));
  see("refusals at 79 C", at("live-refusals").childElementCount);
  move(at("temperature"), 19);
}

/// The same with other binders, good ones and bad ones.
async function pasteSpectra() {
  see("bad spectrum", await paste("relaxation_time_s,modulus_Pa\n0.01,stiff"));
  see("empty spectrum", await paste(""));
  await paste("relaxation_time_s,modulus_Pa\n0.01,0.5e6\n1,0.1e6\n");
  see("A with the same spectrum pasted", liveModulus("A"));
  see("refusals of the same spectrum", at("live-refusals").childElementCount);
  await paste("relaxation_time_s,modulus_Pa\n0.01,5e9\n");
  see("refusal of a stiff spectrum", at("live-refusals").textContent.includes("run a study with that material"));
}

async function lookAtFields() {
  const maps = [...document.querySelectorAll("#field-pictures img")];
  await Promise.all(maps.map((map) => map.decode()));
  see("maps of fields", maps.length);
  const choice = document.querySelector(".field-choice");
  choice.selectedIndex = 2;
  choice.dispatchEvent(new Event("change"));
  see("maps of another test", document.querySelector("#field-pictures figcaption").textContent);
}

function enlargePicture() {
  document.querySelector('button[aria-label="larger"]').click();
  see("zoomed picture", document.querySelector(".picture img").style.transform.includes("scale(1.5)"));
}

/// The page of a study. Each step leaves the page as the next one expects it.
async function look() {
  await lookAtStages();
  lookAtMeasurement();
  await zoomInTime();
  await hoverOverCurve();
  await lookAtStorageModulus();
  await lookAtAxes();
  await lookAtDeviation();
  await lookAtRuns();
  await changeTemperature();
  await pasteSpectra();
  await lookAtFields();
  enlargePicture();
}

/// The page of a study with an interphase whose modulus varies: its slider in place of that of the temperature.
async function lookAtInterphase() {
  see("title", document.querySelector("h1").textContent);
  see("materials", [...at("material").options].map((option) => option.textContent).join(", "));
  see("agreement", at("live-note").dataset.agreement);
  choose("material", "interphase");
  await wait(100);
  see("temperature of the interphase", at("temperature") !== null);
  const slider = at("shear-modulus");
  see("range of the slider", `${(10 ** slider.min).toPrecision(3)} to ${(10 ** slider.max).toPrecision(3)}`);
  see("modulus of the run", liveModulus("C"));
  move(slider, Math.log10(20e6));
  await wait(100);
  see("modulus with a soft interphase", liveModulus("C"));
  see("refusals of a soft interphase", at("live-refusals").childElementCount);
  await paste("relaxation_time_s,modulus_Pa\ninf,9e9\n");
  see("refusal of a rigid interphase", at("live-refusals").textContent.includes("not shown. There interphase would"));
  choose("material", "binder");
  await wait(100);
  see("temperature of the binder", at("temperature") !== null);
}

/// The colour of a canvas at a place from its centre, right and up, in sides of the box; seen along an axis.
function colourAt(canvas, right, up) {
  const pixels = canvas.height / (2 * 0.92);
  const [x, y] = [canvas.width / 2 + right * pixels, canvas.height / 2 - up * pixels].map(Math.round);
  const [red, green, blue] = canvas.getContext("2d").getImageData(x, y, 1, 1).data;
  return `#${[red, green, blue].map((channel) => channel.toString(16).padStart(2, "0")).join("")}`;
}

/// Waits until a view has been drawn (again), after an action of the reader.
async function untilDrawn(figure, action = () => {}) {
  const before = figure.dataset.drawn;
  action();
  for (let i = 0; i < 6000 && figure.dataset.drawn === before; ++i) await wait(10);
  if (figure.dataset.drawn === before) throw new Error(`not drawn after ${action}`);
}

const press = (figure, key) => untilDrawn(figure, () => figure.querySelector("canvas").dispatchEvent(
  new KeyboardEvent("keydown", {key, bubbles: true, cancelable: true})));

const chooseIn = (figure, className, index) => untilDrawn(figure, () => {
  const select = figure.querySelector(className);
  select.selectedIndex = index;
  select.dispatchEvent(new Event("change"));
});

/// A view that has been drawn, with its section through the middle, seen along z.
async function sectionOf(figure) {
  figure.scrollIntoView({block: "center"});
  if (figure.dataset.drawn === undefined) await untilDrawn(figure);
  await chooseIn(figure, ".view-cut", 3);
  await press(figure, "z");
  return figure.querySelector("canvas");
}

/// The ball of glass in the view of the particles.
async function lookAtParticles(figure) {
  const canvas = await sectionOf(figure);
  see("ball", [0, 0.39, 0.41].map((right) => colourAt(canvas, right, 0)).join(" "));
  see("ball upwards", [0.39, 0.41].map((up) => colourAt(canvas, 0, up)).join(" "));
  await untilDrawn(figure, () => move(figure.querySelector(".view-slider"), 0.05));
  see("below the ball", colourAt(canvas, 0, 0));
  const before = canvas.toDataURL();
  await press(figure, "0");
  const home = canvas.toDataURL();
  await press(figure, "ArrowLeft");
  const turned = canvas.toDataURL();
  see("keys turn", before !== home && home !== turned);
  await press(figure, "Home");
  see("keys turn back", canvas.toDataURL() === home);
  await press(figure, "+");
  see("keys zoom", canvas.toDataURL() !== home);
  await untilDrawn(figure, () => figure.querySelector('button[aria-label="all of it"]').click());
  see("button goes back", canvas.toDataURL() === home);
  const pointer = (type, x, y) => canvas.dispatchEvent(new PointerEvent(type, {bubbles: true, pointerId: 1,
    pointerType: "mouse", button: type === "pointermove" ? -1 : 0, buttons: 1, clientX: x, clientY: y}));
  await untilDrawn(figure, () => {
    pointer("pointerdown", 300, 300);
    pointer("pointermove", 340, 310);
    pointer("pointerup", 340, 310);
  });
  see("dragging turns", canvas.toDataURL() !== home);
  see("scale bar", figure.querySelector(".view-scale").textContent);
  see("axes", [...figure.querySelectorAll(".view-axis")].map((name) => name.textContent).join(""));
}

/// Whether the colours of a section through the middle are those of the cells below it, seen along z.
async function showsCells(canvas, {cells, stress: {values}}, colours) {
  const stream = new Blob([Uint8Array.from(atob(values), (sign) => sign.charCodeAt(0))]).stream()
    .pipeThrough(new DecompressionStream("deflate"));
  const of = new Uint8Array(await new Response(stream).arrayBuffer());
  const places = Array.from({length: cells}, (_, i) => i);
  return places.every((y) => places.every((x) => {
    const colour = colours[of[((cells / 2 - 1) * cells + y) * cells + x]];
    return colourAt(canvas, (x + 0.5) / cells - 0.5, (y + 0.5) / cells - 0.5) === `#${colour}`;
  }));
}

async function lookAtFieldView(figure) {
  const canvas = await sectionOf(figure);
  const {views} = JSON.parse(at("data").textContent);
  const field = views.stages.S.fields["fields.vtkhdf"];
  see("colours of cells", await showsCells(canvas, field, views.colours.match(/.{6}/g)));
  see("legend of colours", figure.querySelector(".colour-words").textContent);
  const ticks = [...figure.querySelectorAll(".colour-ticks span")].map(({textContent: text}) => text.replace("−", "-"));
  see("ticks of colours are round", ticks.length > 2 && ticks.every((text) => /^-?(0|[1-9]\d?0*|0\.0*[1-9]\d?)$/.test(text)));
  await chooseIn(figure, ".view-quantity", 2);
  see("materials in a section", [0, 0.47].map((right) => colourAt(canvas, right, right)).join(" "));
  see("legend of materials", figure.querySelector(".legend").textContent);
  await chooseIn(figure, ".view-field", 1);
  see("view of another test", figure.querySelector("figcaption").firstChild.textContent);
}

/// The page of a study in three dimensions.
async function lookAtSpace() {
  see("title", document.querySelector("h1").textContent);
  const views = [...document.querySelectorAll(".rotatable")];
  see("views", views.length);
  see("views cannot be drawn", !at("no-views").hidden);
  see("pictures beside the views", document.querySelectorAll(".picture img").length);
  if (views.length === 0) return;
  await lookAtParticles(views[0]);
  await lookAtFieldView(views[1]);
}

function lookAtPage() {
  if (JSON.parse(at("data").textContent).views !== undefined) return lookAtSpace();
  if (at("task-table") !== null) return lookAtSweep();
  if (at("master-plot") !== null) return lookAtFit();
  return at("material") === null ? look() : lookAtInterphase();
}

addEventListener("load", async () => {
  try {
    await lookAtPage();
    const fetched = performance.getEntriesByType("resource").filter((entry) => !/^(data|blob):/.test(entry.name));
    see("fetched", fetched.length);
    see("complaints", complaints.length === 0 ? 0 : complaints.join("; "));
    seen.push("done");
  } catch (error) {
    seen.push(error.stack);
  }
  const list = document.createElement("pre");
  list.id = "seen";
  list.textContent = `\n${seen.join("\n")}\n`;
  // For those who do not wait for the page's end (browser-test).
  for (const line of seen) console.info(`seen:${line}`);
  document.body.append(list);
});
