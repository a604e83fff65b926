/// Values with which a key is added to a deck, before the user writes their own.

import {sourceWithoutDots} from "./inline_table.js";
import {firstKey, formsOfKey, isModulus} from "./key_reference.js";
import {suitedValue} from "./suited_values.js";
import {isNumber, quoted} from "./toml_source.js";

const ofKeys = {
  name: '"composite"', dimensions: "3", density: '"1 g/cm^3"', poisson: "0.3", thermal_expansion: '"50e-6 /K"',
  stiffness: '{ symmetry = "cubic", C11 = "10 GPa", C12 = "5 GPa", C44 = "4 GPa" }',
  temperature_shift: '{ law = "wlf", c1 = 8, c2 = "100 K", reference = "20 degC", temperature = "40 degC" }',
  box: '"10 mm"', particles: "60", cells: "[64, 128]", resolution: '"10 /mm"', fraction: "0.3", from: '"1 mm"',
  to: '"4 mm"', gap: '"0.1 mm"', film: '"20 um"', seed: "1", columns: "4", rows: "4", repeats: "2", walls: "true",
  packing: '{ method = "random", seed = 1 }', bonds: '{ debonded = "10 %", kind = "sealed" }', debonded: '"10 %"',
  times: '["1 ms", "1 s"]', frequencies: '["0.01 Hz", "100 Hz"]', accuracy: '"3 %"', budget: '"10 min"',
  fields: '"last"', loads: '["isotropic", "bulk"]', boundaries: '["periodic"]', mass_scaling_factors: '"auto"',
  vary: "{}", quasistatic: '{ range = "times" }', dynamic: "{ courant = 0.9 }", films: "{ face_share = 0.3 }",
  crop: "{ left = 0, top = 0, width = 100, height = 100 }", pixel: '"1 um"', smooth: "3", page: "1",
  threshold: '"otsu"', normal: "[1, 0]", pairs: "[]", ramp: '"1 ms"', sweep: '{ "stages.*.packing.seed" = [1, 2, 3] }',
  static: '"1 MPa"', glassy: '"1 GPa"', unrelaxed: '"1 GPa"', equilibrium: '"1 MPa"', delta: "2.2", k: "0.2", h: "0.6",
  beta: "50", exponent: "0.5", time: '"1 s"', instantaneous: '"40e-6 /MPa"', creep: '"20e-6 /MPa"',
  reference_temperature: '"20 degC"', angle: '"30 deg"', counts: "[1, 1]", activation_energy: '"120 kJ/mol"',
  c1: "8", c2: '"100 K"', reference: '"20 degC"', temperature: '"40 degC"', sd: '"0.1 GPa"', factor: "2",
};

/// The source of the value that a key begins with in the table at `path` of a deck; `file` is the name of the file that
/// the value names, if it names one, and `picture` the size of the picture of the table, if it is known.
export function startingValue(sections, key, {tree, path, file = null, picture = null}) {
  const suited = suitedValue(key, tree, path);
  if (suited !== null) return suited;
  if (isModulus(key)) return '"1 GPa"';
  if (key.key === "crop" && picture !== null) return largestSquare(picture);
  if (isFile(key)) return quoted(file);
  if (ofKeys[key.key] !== undefined) return ofKeys[key.key];
  const [form] = formsOfKey(sections, key);
  if (form !== undefined) return valueOfForm(sections, form, file);
  if (key.choices.length > 0) return /^of |array of/.test(key.type) ? `[${key.choices[0].source}]` : key.choices[0].source;
  if (key.example !== null && key.example !== undefined) return sourceWithoutDots(key.example);
  if (isNumber(key.default) || /^"[^"]*"$/.test(key.default)) return key.default;
  if (/integer/.test(key.type)) return "1";
  if (/number/.test(key.type)) return "0.5";
  return key.type === "boolean" ? "true" : '""';
}

/// The largest square of a picture, of an even number of pixels.
function largestSquare({width, height}) {
  const side = 2 * Math.floor(Math.min(width, height) / 2);
  return `{ left = 0, top = 0, width = ${side}, height = ${side} }`;
}

/// A form as the value of a key, such as `{ law = "2s2p1d", static = "1 MPa", … }`; `file` is the name of that of a form
/// which is one.
export function valueOfForm(sections, form, file = null) {
  if (form.keys !== undefined) {
    const law = form.example.table.get("law").source;
    const entries = form.keys.map((key) => `${key} = ${ofKeys[key] ?? '""'}`);
    return `{ law = ${law}, ${entries.join(", ")} }`;
  }
  if (firstKey(form.example) === "terms") return '{ equilibrium = "1 MPa", terms = [{ time = "1 s", modulus = "10 MPa" }] }';
  if (firstKey(form.example) === "passing") {
    const rows = [["1 mm", "0 %"], ["2 mm", "40 %"], ["4 mm", "100 %"]];
    return `{ passing = [${rows.map(([size, share]) => `{ size = "${size}", passing = "${share}" }`).join(", ")}] }`;
  }
  return sourceWithoutDots(form.example).replace(patternOfFile, () => quoted(file));
}

const patternOfFile = /"[\w-]+\.csv"/;

/// Whether the value of a key in this form names a file.
export function isFileForm(form) {
  return form.keys === undefined && patternOfFile.test(form.example.source);
}

/// Whether the value of a key is the name of a file.
export function isFile(key) {
  if (key === null) return false;
  return key.type === "file" || ["prony", "measured", "curve", "sites", "discs", "polygons", "polygon"].includes(key.key)
    || (key.key === "particles" && key.section.endsWith("packing"));
}

/// The files of the folder that a key may mean: pictures for the file of an image, tables for all else.
export function filesFor(key, folder) {
  return key.section === "stages.*.packing" && key.key === "file" ? folder.pictures ?? [] : folder.tables ?? [];
}
