/// All results of the folder: a table, one of them in place, and several beside each other.

import {element} from "../../page/scripts/elements.js";
import {duration} from "../../page/scripts/numbers.js";
import * as api from "./api.js";
import {commandLine} from "./command_line.js";
import {moduliOf, recordsOf, textOfModulus} from "./result_moduli.js";

/// The view. `update()` shows the results of the folder of the context, `open(path)` one of them.
export function resultsView(context) {
  const body = element("tbody", {});
  const heads = ["compare", "title", "deck", "G at the first time", "G at the last time", "when", "took", "state"];
  const table = element("div", {className: "table"}, element("table", {className: "results"},
    element("thead", {}, element("tr", {}, ...heads.map((text) => element("th", {scope: "col"}, text)))), body));
  const none = element("p", {className: "note"}, "No results yet. A run writes them to the folder results.");
  const compareButton = element("button", {type: "button", disabled: true, onclick: compare}, "Compare those that are ticked");
  const comparison = comparisonPanel();
  const frame = element("iframe", {title: "result", className: "result", hidden: true});
  frame.setAttribute("sandbox", "allow-scripts allow-downloads allow-popups");
  const opened = element("div", {className: "opened", hidden: true});
  const view = element("section", {className: "view results-view", ariaLabel: "results"}, element("h2", {}, "Results"), none,
    table, element("div", {className: "buttons"}, compareButton), comparison.element, opened, frame);
  const [rows, chosen, moduli] = [new Map(), new Set(), new Map()];
  let reading = Promise.resolve();

  function update() {
    const {results} = context.folder;
    none.hidden = results.length > 0;
    table.hidden = compareButton.hidden = results.length === 0;
    for (const [path, row] of rows) {
      if (results.some((one) => one.path === path)) continue;
      row.element.remove();
      rows.delete(path);
      chosen.delete(path);
    }
    results.forEach((result, i) => {
      if (!rows.has(result.path)) rows.set(result.path, rowOf(result.path));
      const row = rows.get(result.path);
      if (body.rows[i] !== row.element) body.insertBefore(row.element, body.rows[i] ?? null);
      row.update(result);
    });
    compareButton.disabled = chosen.size < 2;
  }

  function rowOf(path) {
    const box = element("input", {type: "checkbox", ariaLabel: `compare ${path}`, onchange: () => {
      if (box.checked) chosen.add(path);
      else chosen.delete(path);
      compareButton.disabled = chosen.size < 2;
    }});
    const title = element("button", {type: "button", className: "link", onclick: () => open(path)});
    const [where, deck, first, last, date, took, state] = ["span", "span", "span", "span", "span", "span", "span"]
      .map((tag) => element(tag, {}));
    where.className = "note";
    const row = element("tr", {}, ...[box, element("span", {}, title, element("br"), where), deck, first, last, date, took,
      state].map((content) => element("td", {}, content)));
    return {element: row, update(result) {
      title.textContent = result.title;
      where.textContent = result.path;
      deck.textContent = result.deck ?? "";
      date.textContent = dateText(result.date);
      took.textContent = result.seconds > 0 ? duration(result.seconds) : "";
      state.textContent = stateText(result, context.deck);
      box.disabled = result.is_sweep;
      box.title = result.is_sweep ? "several runs are compared on their own page" : "";
      row.classList.toggle("old", state.textContent.includes("earlier text"));
      showModuli(result, first, last);
    }};
  }

  async function showModuli(result, first, last) {
    if (result.is_sweep) {
      first.textContent = "several runs: see its page";
      return;
    }
    if (view.closest("[hidden]") !== null) return;
    const state = `${result.date} ${result.complete}`;
    if (moduli.get(result.path)?.state !== state) {
      // One result after the other, so that many do not hold up what else the page asks for.
      reading = reading.then(() => readModuli(result.path)).catch(() => null);
      moduli.set(result.path, {state, found: reading});
    }
    const found = await moduli.get(result.path).found;
    const ofSymbol = found === null || found.symbol === "G" ? "" : `${found.symbol} = `;
    first.textContent = found === null ? "" : ofSymbol + textOfModulus(found.first);
    last.textContent = found === null ? "" : ofSymbol + textOfModulus(found.last);
  }

  function open(path) {
    const result = context.folder.results.find((one) => one.path === path);
    if (result === undefined) return;
    const differs = stateText(result, context.deck).includes("earlier text");
    const warning = `This is the result of an earlier text of ${result.deck}; run it again for the present one.`;
    const hasPage = result.report !== null;
    opened.hidden = false;
    frame.hidden = !hasPage;
    opened.replaceChildren(element("h3", {}, result.title),
      ...differs ? [element("p", {className: "notice"}, warning)] : [],
      ...hasPage ? [] : [element("p", {className: "note"}, "There is no page yet: the run is not complete.")],
      element("div", {className: "buttons"}, ...hasPage
        ? [element("a", {href: result.report, target: "_blank", rel: "noopener"}, "in a tab of its own")] : [],
        element("button", {type: "button", onclick: () => { frame.hidden = opened.hidden = true; }}, "Close")));
    if (!hasPage) return;
    if (frame.getAttribute("src") !== result.report || frame.dataset.date !== result.date) frame.src = result.report;
    frame.dataset.date = result.date;
    context.showCommand(result.command, "the page of the result");
    opened.scrollIntoView({block: "start"});
  }

  async function compare() {
    const paths = context.folder.results.map(({path}) => path).filter((path) => chosen.has(path));
    comparison.wait();
    try {
      const answer = await api.compare(paths);
      context.showCommand(answer.command, "the comparison");
      comparison.show(answer);
    } catch (error) {
      comparison.complain(error.message);
    }
  }

  return {element: view, update, open};
}

async function readModuli(path) {
  const errors = await api.fileText(`${path}/errors.csv`);
  const hasErrors = recordsOf(errors ?? "").length > 0;
  return moduliOf(errors, hasErrors ? null : await api.fileText(`${path}/curves.csv`));
}

function comparisonPanel() {
  const pictures = element("div", {className: "pictures"});
  const output = element("pre", {hidden: true});
  const state = element("p", {className: "note", role: "status"});
  const line = commandLine();
  const panel = element("section", {className: "panel", hidden: true, ariaLabel: "comparison"},
    element("h3", {}, "Comparison"), state, pictures, output, line.element);
  return {
    element: panel,
    wait() {
      panel.hidden = false;
      state.textContent = "comparing …";
    },
    show({command: words, output: text, pictures: addresses}) {
      state.textContent = "";
      line.show(words);
      output.hidden = false;
      output.textContent = text;
      pictures.replaceChildren(...addresses.map((src) => element("img", {src, alt: "curves of the results"})));
    },
    complain(message) {
      state.textContent = message;
    },
  };
}

/// Whether a result is of the text of the deck that is open.
export function stateText({complete, deck, deck_text: text}, open) {
  const state = complete ? "complete" : "not complete";
  const isOfOpen = open !== null && open !== undefined && open.name === deck;
  return isOfOpen && text !== open.text ? `${state}; of an earlier text of the deck` : state;
}

function dateText(date) {
  const time = new Date(date);
  return Number.isNaN(time.getTime()) ? "" : time.toLocaleString([], {dateStyle: "medium", timeStyle: "short"});
}
