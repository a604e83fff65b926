/// The dimensions of the boxes of a deck: what a deck of the plane has otherwise than one of space, and what cannot be
/// both.

import {entry, stagesOf} from "./deck_tree.js";
import {fillersOf} from "./suited_values.js";
import {sourceOf} from "./toml_source.js";

export function isInSpace(tree) {
  return entry(tree, "dimensions")?.value === 3;
}

function packingsOf(tree) {
  return stagesOf(tree).map((stage) => entry(stage, "packing"));
}

const isImage = (packing) => entry(packing, "method")?.value === "image";

/// The words for both, by whether the stages are images or packings.
export function dimensionsWords(tree) {
  const hasImages = packingsOf(tree).some(isImage);
  return hasImages ? {plane: "in two dimensions: one picture, a cross-section", space: "in three dimensions: a stack of pictures",
    ofPlane: "quick; one layer of a stack is taken for a cross-section of cylinders",
    ofSpace: "takes longer; every pixel of the stack is a small cube"}
    : {plane: "in two dimensions: discs, cross-sections of cylinders", space: "in three dimensions: spheres, ellipsoids, grains",
      ofPlane: "quick; spheres of the same fraction are stiffer, and the result says by how much where a rule is known",
      ofSpace: "takes longer, and is what a composite of particles is"};
}

/// Why the deck cannot be of three dimensions, as one sentence, or "".
export function whyNotInSpace(tree) {
  const packings = packingsOf(tree);
  const hasPolygons = packings.some((packing) => entry(packing, "polygons") !== undefined)
    || stagesOf(tree).flatMap(fillersOf).some((filler) => entry(entry(filler, "shape"), "polygon") !== undefined);
  if (hasPolygons) return "Three dimensions have spheres and ellipsoids, but no polygons.";
  const image = packings.find((packing) => isImage(packing) && /\.png$/i.test(entry(packing, "file")?.value ?? ""));
  return image === undefined ? ""
    : "A PNG is one picture; three dimensions take a stack: a TIFF of several pages, .npy, .vti or HDF5.";
}

const loadsOfSpace = ["shear-yz", "shear-zx", "shear-yy-zz", "shear-zz"];

/// The changes with which a deck has two or three dimensions: the key, and what only the others have.
export function dimensionsChanges(tree, dimensions) {
  const toSpace = dimensions === 3;
  const changes = [{path: ["dimensions"], value: toSpace ? "3" : null}];
  packingsOf(tree).forEach((packing, i) => {
    const at = ["stages", i, "packing"];
    const has = (key) => entry(packing, key) !== undefined;
    const remove = (...keys) => keys.filter(has).forEach((key) => changes.push({path: [...at, key], value: null}));
    const set = (key, value) => changes.push({path: [...at, key], value});
    if (isImage(packing) && toSpace) remove("page");
    if (isImage(packing) && !toSpace) set("page", "1");
    if (entry(packing, "method")?.value === "regular") {
      const count = String(entry(packing, toSpace ? "columns" : "repeats")?.value ?? 1);
      remove(...toSpace ? ["columns", "rows"] : ["lattice", "repeats"]);
      for (const [key, value] of toSpace ? [["lattice", '"sc"'], ["repeats", count]] : [["columns", count], ["rows", count]]) {
        set(key, value);
      }
    }
  });
  return [...changes, ...toSpace ? [] : changesOfLoads(entry(entry(tree, "tests"), "loads"))];
}

/// Without the loads that the plane does not have.
function changesOfLoads(loads) {
  if (loads === undefined) return [];
  const all = loads.type === "array" ? loads.items : [loads];
  const left = all.filter(({value}) => !loadsOfSpace.includes(value));
  if (left.length === all.length) return [];
  return [{path: ["tests", "loads"], value: left.length === 0 ? null : `[${left.map(sourceOf).join(", ")}]`}];
}
