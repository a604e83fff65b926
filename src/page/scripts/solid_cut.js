/// The cube [0, 1]^3 without the part that a reader cuts off: the points above all of three planes, one across each
/// axis. A plane below 0 is no condition, so that a single plane cuts off a slab.

/// The kinds of cuts, with the planes for a position between 0 and 1.
export const cuts = [
  {name: "a corner", planes: (at) => [at, at, at]},
  {name: "across x", planes: (at) => [at, -1, -1]},
  {name: "across y", planes: (at) => [-1, at, -1]},
  {name: "across z", planes: (at) => [-1, -1, at]},
  {name: "nothing", planes: () => [2, 2, 2]},
];

const axes = [0, 1, 2];
const others = (axis) => [(axis + 1) % 3, (axis + 2) % 3];

/// The body that a cut leaves: a box from the origin to `upper`, without the box from `notch` to (1, 1, 1) if there is
/// a notch.
function solidOf(planes) {
  const places = planes.map((plane) => Math.min(1, Math.max(0, plane)));
  if (places.some((place) => place === 1)) return {upper: [1, 1, 1]};
  if (places.every((place) => place > 0)) return {upper: [1, 1, 1], notch: places};
  return {upper: planes.map((plane, axis) => (plane < 0 ? 1 : places[axis]))};
}

function point(axis, along, [first, second]) {
  const place = [0, 0, 0];
  const [across, up] = others(axis);
  place[axis] = along;
  place[across] = first;
  place[up] = second;
  return place;
}

/// A rectangle perpendicular to an axis, as two triangles that face its positive or negative direction.
function rectangle(axis, along, from, to, faces) {
  const corners = [[from[0], from[1]], [to[0], from[1]], [to[0], to[1]], [from[0], to[1]]]
    .map((corner) => point(axis, along, corner));
  const order = faces > 0 ? [0, 1, 2, 0, 2, 3] : [0, 2, 1, 0, 3, 2];
  const normal = point(axis, faces, [0, 0]);
  return order.map((corner) => ({place: corners[corner], normal}));
}

/// The corners of the triangles of the surface of the body that is left, and the outward normal at each.
export function surfaceOf(planes) {
  const {upper, notch} = solidOf(planes);
  return axes.flatMap((axis) => {
    const [across, up] = others(axis);
    const end = [upper[across], upper[up]];
    const lower = rectangle(axis, 0, [0, 0], end, -1);
    if (notch === undefined) return [...lower, ...rectangle(axis, upper[axis], [0, 0], end, 1)];
    const corner = [notch[across], notch[up]];
    return [...lower,
      ...rectangle(axis, notch[axis], corner, end, 1),
      ...rectangle(axis, 1, [0, 0], [corner[0], 1], 1),
      ...rectangle(axis, 1, [corner[0], 0], [1, corner[1]], 1)];
  });
}

/// The ends of the edges of the body that is left, two for each.
export function edgesOf(planes) {
  const {upper, notch} = solidOf(planes);
  return axes.flatMap((axis) => {
    const [across, up] = others(axis);
    const edge = (from, to, at) => [point(axis, from, at), point(axis, to, at)];
    const [right, top] = [upper[across], upper[up]];
    const outer = [[0, 0], [right, 0], [0, top]].flatMap((at) => edge(0, upper[axis], at));
    if (notch === undefined) return [...outer, ...edge(0, upper[axis], [right, top])];
    const inner = [[notch[across], notch[up]], [1, notch[up]], [notch[across], 1]];
    return [...outer, ...edge(0, notch[axis], [1, 1]), ...inner.flatMap((at) => edge(notch[axis], 1, at))];
  });
}
