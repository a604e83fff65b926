/// The colours of phases in the pictures (report/microstructure_picture.hpp).

export const matrixColour = "#f3e9d8";

/// The colour of films that are debonded.
export const debondedColour = "#d92d20";

/// The colours of the fillers and their coatings, from the first filler on.
const colours = ["#5b7f95", "#b5652b", "#6b8e4e", "#8a6bac", "#c9a227", "#a8444f", "#3f8f8b", "#7a7a7a"];

/// The materials of the phases in a picture: those of the fillers, then those of their coatings, each once.
export function phasesOf(fillers) {
  const coatings = fillers.flatMap(({coating}) => (coating === null ? [] : [coating.material]));
  return [...new Set([...fillers.map(({material}) => material), ...coatings])];
}

/// The colour of a material among those of the phases.
export function colourOf(material, phases) {
  return colours[phases.indexOf(material) % colours.length];
}

/// The colours by the numbers of phases, the matrix first.
export function coloursOfPhases(fillers) {
  const phases = phasesOf(fillers);
  return [matrixColour, ...phases.map((material) => colourOf(material, phases))];
}

/// Red, green and blue of a colour, 0 to 255.
export function channelsOf(colour) {
  const digits = colour.replace("#", "");
  return [0, 2, 4].map((at) => parseInt(digits.slice(at, at + 2), 16));
}
