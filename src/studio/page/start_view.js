/// The first view: decks of the folder, and examples to begin with.

import {element} from "../../page/scripts/elements.js";
import * as api from "./api.js";

/// What most begin with: an example (null: the starter deck), the words of its button, and what it is about.
const beginnings = [
  [null, "Begin with the starter deck", "discs in a soft binder, quick, every line of the deck explained"],
  ["spheres.toml", "Begin with spheres", "in three dimensions, of one size in a rubber"],
  ["two-fillers.toml", "Begin with two fillers", "of two materials and sizes, as a propellant has them"],
  ["image.toml", "Begin with a micrograph", "a picture in which particles are brighter or darker than the matrix"],
];

/// The view. `openDeck(name)` and `take(DECK)` are called with what the user has chosen.
export function startView(context, {openDeck, take}) {
  const decks = element("ul", {className: "decks"});
  const noDecks = element("p", {className: "note"}, "There is no deck in this folder yet. Begin with one of those below.");
  const name = element("input", {type: "text", id: "new-name", spellcheck: false, autocomplete: "off",
    placeholder: "my-composite"});
  const complaint = element("p", {className: "mistake", role: "alert", hidden: true});
  const examples = element("div", {className: "examples"});
  const view = element("section", {className: "view", ariaLabel: "decks"},
    element("p", {}, "The stiffness of a filled composite over time, from what it is made of. You need the modulus of the "
      + "binder (a file of a rheometer or a DMA will do), the moduli of the filler, and its sizes and fraction, or a "
      + "micrograph. All of it is a deck, a file of text in this folder, which the page writes for you."),
    element("h2", {}, "Decks of this folder"), noDecks, decks,
    element("h2", {}, "A new deck"),
    element("p", {className: "new"}, element("label", {htmlFor: "new-name"}, "name "), name, ".toml"), complaint,
    element("ul", {className: "beginnings"}, ...beginnings.map(([example, words, about]) => element("li", {},
      element("button", {type: "button", className: example === null ? "main" : "", onclick: () => begin(example)}, words),
      ` ${about}`))),
    element("h3", {}, "or from an example"), examples);
  let shown = "";

  async function begin(example) {
    complaint.hidden = true;
    const stem = name.value.trim().replace(/\.toml$/, "") || (example === null ? "starter"
      : example.split("/").at(-1).replace(/\.toml$/, ""));
    try {
      const deck = await api.newDeck(`${stem}.toml`, example);
      context.showCommand(deck.command, example === null ? "a new deck" : "the example, with the files it names");
      name.value = "";
      take(deck);
    } catch (error) {
      complaint.textContent = error.message;
      complaint.hidden = false;
      name.focus();
    }
  }

  /// A few are shown at once, many when they are asked for.
  function groupOfExamples([group, ofGroup]) {
    const list = element("ul", {className: "decks"}, ...ofGroup.map((one) => button(one, () => begin(one.name))));
    if (ofGroup.length <= 3) return element("section", {}, element("h4", {}, group), list);
    return element("details", {className: "all"}, element("summary", {}, `${group} (${ofGroup.length})`), list);
  }

  return {element: view, update() {
    const {decks: found, examples: offered} = context.folder;
    const state = JSON.stringify([found, offered]);
    if (state === shown) return;
    shown = state;
    noDecks.hidden = found.length > 0;
    decks.replaceChildren(...found.map((deck) => button(deck, () => openDeck(deck.name))));
    examples.replaceChildren(...groupsOfExamples(offered).map(groupOfExamples));
  }};
}

/// A deck or an example as a button: its title, what it is about, and its name.
function button({name, title, about = ""}, act) {
  return element("li", {}, element("button", {type: "button", className: "deck", onclick: act},
    element("b", {}, title || name), element("span", {}, shortAbout(about)), element("span", {className: "note"}, name)));
}

/// The examples by material: those in materials/NAME under the name, the others by what they are of.
export function groupsOfExamples(examples) {
  const groups = new Map();
  for (const one of examples) {
    const [, material] = /^materials\/([^/]+)\//.exec(one.name) ?? [];
    const group = material !== undefined ? sentenceCase(material.replaceAll("-", " and "))
      : /^pbx/.test(one.name) ? "Plastic-bonded explosive, PBX-9501" : /propellant/i.test(one.title) ? "Propellant"
        : one.name.includes("/") ? "Studies and checks" : "Shapes and models";
    groups.set(group, [...groups.get(group) ?? [], one]);
  }
  const rank = (group) => ["Plastic-bonded explosive, PBX-9501", "Shapes and models", "Studies and checks"].indexOf(group);
  return [...groups].sort(([a], [b]) => rank(a) - rank(b));
}

function sentenceCase(text) {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

function shortAbout(about) {
  const words = about.replace(/\s+/g, " ").trim();
  return words.length <= 190 ? words : `${words.slice(0, 185).replace(/\s+\S*$/, "")} …`;
}
