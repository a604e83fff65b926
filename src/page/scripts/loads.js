/// The loads of curves. The load "isotropic" is the mean of all shears of a box.

/// The load whose modulus is shown as G: the isotropic mean, else shear, else the first shear; bulk where there is
/// nothing else, and undefined without any.
export function mainLoad(loads) {
  return ["isotropic", "shear"].find((load) => loads.includes(load)) ?? loads.find((load) => load !== "bulk") ?? loads[0];
}

/// The loads to be shown at first: where there is the mean of all shears, without them.
export function loadsShownFirst(loads) {
  return loads.includes("isotropic") ? loads.filter((load) => !load?.startsWith("shear")) : loads;
}

/// The load of shear that serves for a stage of study.json: the isotropic mean where it was tested, else shear.
export function shearOf({tests = []}) {
  return tests.some(({load}) => load === "isotropic") ? "isotropic" : "shear";
}

/// The loads of the virtual tests whose mean is the shear modulus of a stage of study.json.
export function shearsOf({tests = []}) {
  return tests.find((test) => test.mean_of !== undefined)?.mean_of ?? ["shear"];
}
