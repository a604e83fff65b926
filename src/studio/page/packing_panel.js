/// The picture of the packing, drawn anew after each change of the deck that is sound.

import {element} from "../../page/scripts/elements.js";
import * as api from "./api.js";
import {commandLine} from "./command_line.js";
import {mostParticles} from "./check_output.js";

const pause = 1200;
const slow = 8;          // seconds: packings that have taken longer are drawn on demand alone
const many = 3000;       // particles: likewise

/// The panel. `sound(output)` is called when a check has found no mistake.
export function packingPanel(context) {
  const pictures = element("div", {className: "packings"});
  const state = element("p", {className: "note", role: "status"}, "");
  const line = commandLine();
  const button = element("button", {type: "button", onclick: () => draw()}, "Pack now");
  const output = element("pre", {});
  const details = element("details", {hidden: true}, element("summary", {}, "what the program says"), output);
  const panel = element("section", {className: "panel", ariaLabel: "packing"},
    element("header", {}, element("h3", {}, "Packing"), button), pictures, state, details, line.element);
  let [timer, seconds, packed, call] = [0, 0, null, 0];

  async function draw() {
    clearTimeout(timer);
    const [name, text, number] = [context.deck.name, context.deck.savedText, ++call];
    panel.classList.add("busy");
    state.textContent = "packing …";
    const start = performance.now();
    try {
      const answer = await api.pack(name);
      if (number !== call) return;
      seconds = (performance.now() - start) / 1000;
      packed = text;
      await show(answer);
      if (text !== context.deck.text) markOld();
    } catch (error) {
      if (number === call && error.status !== 409) state.textContent = error.message;
    } finally {
      if (number === call) panel.classList.remove("busy");
    }
  }

  async function show({command, exit, output: words, stages}) {
    line.show(command);
    context.showCommand(command, "the picture of the packing");
    output.textContent = words;
    details.hidden = words === "";
    state.textContent = exit === 0 ? "" : "It could not be packed.";
    details.open = exit !== 0;
    panel.classList.toggle("old", exit !== 0);
    if (exit !== 0) return;
    const drawn = await Promise.all(stages.filter(({picture}) => picture).map(figureOf));
    pictures.replaceChildren(...drawn);
    if (drawn.length === 0) state.textContent = "These stages have no pictures.";
  }

  function markOld() {
    panel.classList.add("old");
    state.textContent = "of an earlier text of the deck";
  }

  return {
    element: panel,
    sound(plan) {
      clearTimeout(timer);
      if (packed === context.deck.savedText) {
        ++call;  // the picture of a text between is of no use any more
        panel.classList.remove("old", "busy");
        state.textContent = "";
        return;
      }
      if (seconds > slow || mostParticles(plan) > many) {
        state.textContent = "The deck has changed; packing it takes a while, so it waits for the button.";
        panel.classList.add("old");
      } else {
        timer = setTimeout(draw, pause);
      }
    },
    changed() {
      clearTimeout(timer);
      if (packed !== null && packed !== context.deck.text) markOld();
    },
  };
}

/// A picture, once it is loaded, so that the earlier one stays until then.
async function figureOf({name, picture}) {
  const image = element("img", {alt: `packing of ${name}`, src: picture});
  await image.decode().catch(() => {});
  return element("figure", {}, image, element("figcaption", {}, name));
}
