/// The cube [0, 1]^3 without a corner that a reader cuts off: all that is above three planes at once. Planes below 0
/// leave no condition on their axis, so that one plane alone cuts a slab off.

/// The ways to cut, with the planes for a place between 0 and 1.
export const cuts = [
  {name: "a corner", planes: (at) => [at, at, at]},
  {name: "across x", planes: (at) => [at, -1, -1]},
  {name: "across y", planes: (at) => [-1, at, -1]},
  {name: "across z", planes: (at) => [-1, -1, at]},
  {name: "nothing", planes: () => [2, 2, 2]},
];

const axes = [0, 1, 2];
const others = (axis) => [(axis + 1) % 3, (axis + 2) % 3];

/// The corner that is cut off begins here; at 1 along an axis there is none.
function cornerOf(planes) {
  return planes.map((plane) => Math.min(1, Math.max(0, plane)));
}

function isCut(corner) {
  return corner.every((place) => place < 1);
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

/// The corners of triangles, and the outward normal at each, of the surface of what is left.
export function surfaceOf(planes) {
  const corner = cornerOf(planes);
  return axes.flatMap((axis) => {
    const [across, up] = others(axis);
    const notch = [corner[across], corner[up]];
    const whole = rectangle(axis, 0, [0, 0], [1, 1], -1);
    if (!isCut(corner)) return [...whole, ...rectangle(axis, 1, [0, 0], [1, 1], 1)];
    return [...whole,
      ...rectangle(axis, corner[axis], notch, [1, 1], 1),
      ...rectangle(axis, 1, [0, 0], [notch[0], 1], 1),
      ...rectangle(axis, 1, [notch[0], 0], [1, notch[1]], 1)];
  });
}

/// The ends of the edges of what is left.
export function edgesOf(planes) {
  const corner = cornerOf(planes);
  const edges = [];
  for (const axis of axes) {
    const [across, up] = others(axis);
    const edge = (from, to, at) => {
      if (to > from) edges.push(point(axis, from, at), point(axis, to, at));
    };
    edge(0, 1, [0, 0]);
    edge(0, 1, [1, 0]);
    edge(0, 1, [0, 1]);
    if (!isCut(corner)) {
      edge(0, 1, [1, 1]);
      continue;
    }
    edge(0, corner[axis], [1, 1]);
    edge(corner[axis], 1, [corner[across], corner[up]]);
    edge(corner[axis], 1, [1, corner[up]]);
    edge(corner[axis], 1, [corner[across], 1]);
  }
  return edges;
}
