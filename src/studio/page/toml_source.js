/// Values as the source of a deck: TOML.

/// A text in quotes.
export function quoted(text) {
  const escaped = text.replace(/["\\]/g, (sign) => `\\${sign}`)
    .replace(/[\u0000-\u001f\u007f]/g, (sign) => `\\u${sign.charCodeAt(0).toString(16).padStart(4, "0")}`);
  return `"${escaped}"`;
}

/// A key, in quotes where TOML asks for them.
export function keySource(key) {
  return /^[A-Za-z0-9_-]+$/.test(key) ? key : quoted(key);
}

/// The source of a node of the tree of a deck. Comments and blanks of the deck are not in it.
export function sourceOf(node) {
  if (node.type === "table") {
    const entries = node.entries.map(({key, value}) => `${keySource(key)} = ${sourceOf(value)}`);
    return entries.length === 0 ? "{}" : `{ ${entries.join(", ")} }`;
  }
  if (node.type === "array") return `[${node.items.map(sourceOf).join(", ")}]`;
  if (node.type === "text") return quoted(node.value);
  return String(node.value ?? "");
}

/// A node as it is typed into a field: texts without their quotes, arrays of them and of numbers without brackets,
/// anything else as TOML.
export function typedOf(node) {
  if (node.type === "array" && isPlainList(node)) return node.items.map(typedOf).join(", ");
  return node.type === "text" ? node.value : sourceOf(node);
}

function isPlainList({items}) {
  return items.length > 0 && items.every(({type, value}) => ["integer", "number"].includes(type)
    || (type === "text" && value !== "" && !/[,[\]{}"]/.test(value) && !isNumber(value)));
}

/// The source of what was typed as a list: "64, 128" is [64, 128].
export function sourceOfList(typed) {
  const text = typed.trim();
  if (text.startsWith("[")) return text;
  const items = text.split(",").map((item) => item.trim()).filter((item) => item !== "");
  return `[${items.map((item) => sourceOfTyped(item)).join(", ")}]`;
}

const numberPattern = /^[+-]?(\d+(_\d+)*)(\.\d+)?([eE][+-]?\d+)?$/;

/// Whether a text is a number of TOML.
export function isNumber(text) {
  return numberPattern.test(text);
}

/// The source of what was typed into a field. A field of numbers takes numbers as such and anything else, as "65 %", as
/// text; one of a name or a title takes all as text; arrays and tables may be typed wherever they can be meant.
export function sourceOfTyped(typed, {isText = false, wasText = false} = {}) {
  const text = typed.trim();
  if (isText) return quoted(text);
  if (/^[[{]/.test(text) || text === "true" || text === "false") return text;
  if (isNumber(text) && !wasText) return text.replace(/^\+/, "");
  return quoted(text);
}
