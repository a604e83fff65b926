/// What the reference says of a key: its first sentence, and all of it on demand.

import {element} from "../../page/scripts/elements.js";
import {firstSentence} from "./markdown.js";

/// The words of the reference on a key, as one text.
export function wordsOn(key) {
  const parts = [key.meaning, key.type === "" || key.type === "see below" ? "" : `Takes: ${key.type}.`,
    key.default === "" ? "" : `Without it: ${key.default}.`];
  return parts.filter((text) => text !== "").join(" ");
}

/// A line of help for a key; empty where the reference does not know it.
export function helpLine(key) {
  if (key === null) return element("p", {className: "help"}, "not in the reference of decks");
  const short = firstSentence(key.meaning).replace(/[;,]? see below\.?$|^see .*|\.$/, "");
  const all = wordsOn(key);
  const isUnit = key.type !== "" && key.type.length < 40 && !/table|see below|^text$|^modulus$/.test(key.type);
  const line = [short, isUnit && short.length < 80 ? `(${key.type})` : ""].filter((text) => text !== "").join(" ");
  if (line === "") return element("p", {className: "help"}, "");
  if (all.length <= line.length + 12) return element("p", {className: "help"}, line);
  const choices = key.choices.filter(({meaning}) => meaning !== "").map(({source, meaning}) =>
    element("p", {}, element("b", {}, source.replaceAll('"', "")), ` ${meaning}`));
  return element("details", {className: "help"}, element("summary", {}, line), element("p", {}, all), ...choices);
}
