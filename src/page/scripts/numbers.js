/// Numbers as text for readers.

/// The SI prefixes with their factors, from the largest to the smallest.
export const prefixes = [[1e12, "T"], [1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"],
  [1e-9, "n"], [1e-12, "p"], [1e-15, "f"]];

/// A quantity with an SI prefix: display(1.234e-6, "s") is "1.23 µs". Times of a thousand seconds and more stay in
/// seconds: "1000 s", "2·10⁶ s".
export function display(value, unit, digits = 3) {
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "–";
  if (value === 0) return `0 ${unit}`;
  const rounded = Number(value.toPrecision(digits));
  if (unit === "s" && Math.abs(rounded) >= 1000) return `${shortNumber(rounded, digits)} s`;
  const fitting = prefixes.find(([size]) => Math.abs(rounded) >= size * (1 - 1e-12));
  if (fitting === undefined) return `${shortNumber(rounded, digits)} ${unit}`;
  const [scale, prefix] = fitting;
  return `${minus(Number((rounded / scale).toPrecision(digits)))} ${prefix}${unit}`;
}

/// A range of a quantity: "1.26 to 2.2 GPa", "340 kPa to 1.2 MPa"; one value where both are the same in three digits.
export function displayRange(least, most, unit) {
  const [from, to] = [display(least, unit), display(most, unit)];
  if (from === to) return from;
  const [number, unitOfLeast] = from.split(" ");
  return to.endsWith(` ${unitOfLeast}`) ? `${number} to ${to}` : `${from} to ${to}`;
}

/// The time [s] that a calculation has taken: "2.4 s", "50 min", "3 h".
export function duration(seconds) {
  const unit = [["d", 86400], ["h", 3600], ["min", 60]].find(([, size]) => seconds >= 2 * size);
  return unit === undefined ? display(seconds, "s") : `${Number((seconds / unit[1]).toPrecision(3))} ${unit[0]}`;
}

/// A number as text, with a minus sign instead of a hyphen.
export function minus(number) {
  return String(number).replace("-", "−");
}

/// A text of the command line, whose signs are those of ASCII, with the micro sign: "4.2 µm".
export function withMicroSign(text) {
  return text.replace(/(\d) u(m|s|Pa)\b/g, "$1 µ$2");
}

/// A share of one in per cent, "1.23 %", small ones with a power of ten; no text if the share is unknown.
export function percent(share) {
  if (share === null || share === undefined) return "";
  if (!Number.isFinite(share)) return "–";
  const value = 100 * share;
  return `${Math.abs(value) < 1e-3 ? shortNumber(value, 1) : minus(Number(value.toPrecision(2)))} %`;
}

/// A fraction by area, volume or mass in per cent with one decimal: "65.0 %".
export function percentOfWhole(share) {
  return `${(100 * share).toFixed(1)} %`;
}

/// A number without a unit: "0.0103", "1.03·10⁵".
export function shortNumber(value, digits = 3) {
  if (!Number.isFinite(value)) return "–";
  const isPlain = value === 0 || (Math.abs(value) >= 1e-3 && Math.abs(value) < 1e5);
  if (isPlain) return minus(Number(value.toPrecision(digits)));
  const [factor, power] = value.toExponential(digits - 1).split("e");
  const superscript = [...String(Number(power))].map((sign) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(sign)]).join("");
  return Number(factor) === 1 ? `10${superscript}` : `${minus(Number(factor))}·10${superscript}`;
}

/// A ratio in two digits, or three where it is less than a fifth above one, which two digits would hide.
export function ratioNumber(ratio) {
  return shortNumber(ratio, ratio > 1 && ratio < 1.2 ? 3 : 2);
}

/// The range of ratios in words: "0.92 to 1.04", or one number.
export function ratioText(ratios) {
  return [...new Set([Math.min(...ratios), Math.max(...ratios)].map(ratioNumber))].join(" to ");
}

/// A text in which no line ends between a number and its unit, or after "±".
export function unbroken(text) {
  return text.replaceAll("± ", "±\u00a0")
    .replace(/(\d) (?=(?:[kMGTmµunp]?(?:Pa|Hz|s|m)|%|°C|min|h)(?![A-Za-z]))/g, "$1\u00a0");
}
