/// Running the deck: progress, what the program prints, stop, and the result.

import {element} from "../../page/scripts/elements.js";
import {duration} from "../../page/scripts/numbers.js";
import * as api from "./api.js";
import {commandLine} from "./command_line.js";

const states = {running: "running", done: "complete", failed: "failed",
  stopped: "stopped; running it again goes on from there"};

/// The panel. `openResult(path)` shows a result; `finished()` is called when a job has ended.
export function runPanel(context, {openResult, finished}) {
  const seeds = element("input", {type: "number", min: 1, max: 100, value: "1", id: "seeds"});
  const runButton = element("button", {type: "button", className: "main", onclick: () => run()}, "Run");
  const anewButton = element("button", {type: "button", hidden: true, onclick: () => run({anew: true})},
    "Keep the earlier results and run into a new folder");
  const stopButton = element("button", {type: "button", hidden: true, onclick: stop}, "Stop");
  const open = element("button", {type: "button", className: "main", hidden: true}, "Open the result");
  const bar = element("progress", {max: 1, hidden: true, ariaLabel: "progress of the run"});
  const state = element("p", {className: "state", role: "status"});
  const live = element("p", {className: "note live"});
  const refusal = element("p", {className: "mistake", role: "alert"});
  const output = element("pre", {hidden: true});
  const line = commandLine();
  const panel = element("section", {className: "panel run", ariaLabel: "run"}, element("h3", {}, "Run"),
    element("div", {className: "buttons"}, runButton, stopButton, anewButton, open,
      element("label", {htmlFor: "seeds", title: "seeds: packings that differ by chance alone, for mean and spread"},
        "packings ", seeds)),
    refusal, bar, state, live, output, line.element);
  // `ran`: the text of the deck that this page has run last; `stopping`: the run that was asked to stop; `asked`: for
  // what the command was asked last.
  let [timer, job, ran, stopping, asked] = [0, null, null, null, ""];
  seeds.addEventListener("input", update);

  async function run(options = {}) {
    runButton.disabled = true;
    refusal.textContent = "";
    try {
      await context.deck.save();
      if (!context.deck.isSaved) throw new Error("the deck is not saved, so that another text of it would run");
      const text = context.deck.savedText;
      show(await api.run(context.deck.name, {...chosenOptions(), ...options}));
      ran = {id: job.id, text};
      context.showCommand(job.command, "the run");
    } catch (error) {
      refusal.textContent = error.message;
    }
    runButton.disabled = job?.state === "running";
  }

  async function stop() {
    stopButton.disabled = true;
    stopping = job.id;
    try {
      show(await api.stop());
    } catch (error) {
      refusal.textContent = error.message;
    }
  }

  function show(newJob) {
    const hasEnded = job?.state === "running" && newJob?.state !== "running";
    job = newJob;
    update();
    clearTimeout(timer);
    if (job?.state === "running") timer = setTimeout(poll, 500);
    if (hasEnded) finished(job);
  }

  /// Shows the run that is under way, or the last one if it was of the deck that is open.
  function update() {
    const isRunning = job?.state === "running";
    const isShown = isRunning || (job !== null && job.name === context.deck?.name);
    runButton.disabled = isRunning;
    stopButton.hidden = bar.hidden = !isRunning;
    if (!isRunning) stopButton.disabled = false;
    panel.dataset.state = isShown ? job.state : "";
    state.hidden = live.hidden = !isShown;
    output.hidden = !isShown || job.output === "";
    anewButton.hidden = !isShown || job.state !== "failed" || !job.output.includes("--overwrite");
    open.hidden = !isShown || isRunning || job.report === null;
    if (isShown) showJob();
    if (isRunning) line.show(job.command);
    else if (context.deck !== null) showCommand();
  }

  const chosenOptions = () => Number(seeds.value) > 1 ? {seeds: Number(seeds.value)} : {};

  /// Shows the command that the button would run, which the studio knows: another text of the deck has results of its
  /// own.
  async function showCommand() {
    const {name, savedText, isSaved} = context.deck;
    const state = JSON.stringify([name, savedText, chosenOptions(), job?.state]);
    if (!isSaved || state === asked) return;
    asked = state;
    const {command} = await api.runCommand(name, chosenOptions()).catch(() => ({command: ""}));
    if (state === asked && job?.state !== "running") line.show(command);
  }

  function showJob() {
    const isRunning = job.state === "running";
    if (job.share === null) bar.removeAttribute("value");
    else bar.value = job.share;
    const elapsed = duration(Math.max(job.seconds, 0.1));
    const isOld = ran?.id === job.id && context.deck?.name === job.name && ran.text !== context.deck.text;
    const words = isRunning ? `${job.name} is ${stopping === job.id ? "stopping; what is done is kept" : "running"}`
      : `${job.name}: ${states[job.state]}, ${elapsed}${isOld ? "; of an earlier text of the deck" : ""}`;
    if (state.textContent !== words) state.textContent = words;
    live.textContent = isRunning ? [elapsed, job.live].filter((text) => text !== "").join("; ") : "";
    if (output.textContent !== job.output) {
      output.textContent = job.output;
      output.scrollTop = output.scrollHeight;
    }
    open.onclick = () => openResult(job.results);
  }

  async function poll() {
    try {
      show(await api.getJob());
    } catch {
      timer = setTimeout(poll, 2000);
    }
  }

  return {element: panel, show, update};
}
