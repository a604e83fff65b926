"use strict";

/// What the pages call things.

const boundNames = {displacement: "upper bound", traction: "lower bound", periodic: "periodic"};
const methodNames = {quasistatic: "quasi-static", dynamic: "dynamic"};

/// The quantities that can be shown, in their order.
const quantities = [
  {name: "shear", title: "Relaxation modulus G(t)", x: "time", xUnit: "s", unit: "Pa"},
  {name: "bulk", title: "Plane-strain bulk modulus K(t) + G(t)/3", x: "time", xUnit: "s", unit: "Pa"},
  {name: "compliance", title: "Creep compliance", x: "time", xUnit: "s", unit: "1/Pa"},
  {name: "dynamic", title: "Storage and loss modulus G′, G″", x: "angular frequency", xUnit: "rad/s", unit: "Pa"},
  {name: "loss-factor", title: "Loss factor tan δ = G″/G′", x: "angular frequency", xUnit: "rad/s", unit: ""},
];

function gridName(cells) {
  return cells === "extrapolated" ? "h → 0" : `${cells} cells`;
}
