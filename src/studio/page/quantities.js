/// Lengths and moduli as decks have them: a number and a unit.

const metres = new Map([["pm", 1e-12], ["nm", 1e-9], ["um", 1e-6], ["µm", 1e-6], ["mm", 1e-3], ["cm", 1e-2], ["m", 1],
  ["km", 1e3]]);
const pascals = new Map([["Pa", 1], ["kPa", 1e3], ["MPa", 1e6], ["GPa", 1e9]]);

/// The number of a quantity in the basic unit of a map of units, or null where its unit is none of them.
function numberIn(units, text) {
  const [, number, unit] = /^\s*([\d.]+(?:[eE][+-]?\d+)?)\s*([A-Za-zµ]+)\s*$/.exec(text ?? "") ?? [];
  const found = Number(number) * (units.get(unit) ?? NaN);
  return Number.isFinite(found) && found > 0 ? found : null;
}

/// A quantity of two digits, in the unit in which it is 1 to 1000 where there is one.
function textIn(units, number) {
  const names = [...units.keys()].filter((name) => name !== "µm" && name !== "cm");
  const unit = names.findLast((name) => number >= 0.9995 * units.get(name)) ?? names[0];
  return `${Number((number / units.get(unit)).toPrecision(2))} ${unit}`;
}

/// The length of a text such as "2 mm" [m], and the text of a length.
export const lengthOf = (text) => numberIn(metres, text);
export const lengthText = (length) => textIn(metres, length);

/// The modulus of a text such as "3 GPa" [Pa], and the text of a modulus.
export const modulusOf = (text) => numberIn(pascals, text);
export const modulusText = (modulus) => textIn(pascals, modulus);
