/// What `breccia check` prints, by what matters first: cost, errors to be expected, warnings.

/// The lines that are pulled up: [{kind: "cost" | "grid" | "packing" | "filler" | "accuracy" | "warning", text}].
export function highlights(output) {
  const found = [];
  for (const line of output.split("\n")) {
    const text = line.trim();
    const kind = kindOf(text);
    if (kind === null || found.some((one) => one.text === shortened(kind, text))) continue;
    found.push({kind, text: shortened(kind, text)});
  }
  const order = ["cost", "accuracy", "grid", "packing", "filler", "warning"];
  return found.sort((a, b) => order.indexOf(a.kind) - order.indexOf(b.kind));
}

function kindOf(text) {
  if (/^warning: /.test(text)) return "warning";
  if (/^together /.test(text)) return "cost";
  if (/\baccuracy\b.*%/.test(text)) return "accuracy";
  if (/the error of the grid/.test(text)) return "grid";
  if (/the error of the packing/.test(text)) return "packing";
  return /: filler of the whole: /.test(text) ? "filler" : null;
}

function shortened(kind, text) {
  if (kind === "warning") return text.replace(/^warning: /, "");
  if (kind === "cost") return text.replace(/ of memory$/, "");
  return text;
}

/// The largest number of particles that a stage has, as far as the plan says it.
export function mostParticles(output) {
  const numbers = [...output.matchAll(/\b(\d+) particles\b/g)].map(([, number]) => Number(number));
  return numbers.length === 0 ? 0 : Math.max(...numbers);
}
