/// Spheres and ellipsoids in a cube. Each is a square towards the reader, whose pixels find the surface by a ray: a
/// hundred thousand take no more than as many squares, and a cut shows their sections. The global `THREE` is three.js.

import {unpackedNumbers} from "./compressed_bytes.js";
import {channelsOf} from "./phase_colours.js";

const vertexShader = `
  attribute vec3 centre;
  attribute vec3 halfAxes;
  attribute vec4 turn;
  attribute vec3 colour;
  attribute vec3 coatingColour;
  attribute float coating;
  varying vec3 place;
  flat varying vec3 ofCentre;
  flat varying vec3 ofHalfAxes;
  flat varying vec4 ofTurn;
  flat varying vec3 ofColour;
  flat varying vec3 ofCoatingColour;
  flat varying float ofCoating;
  void main() {
    float radius = max(halfAxes.x, max(halfAxes.y, halfAxes.z)) + coating;
    vec3 right = vec3(viewMatrix[0][0], viewMatrix[1][0], viewMatrix[2][0]);
    vec3 up = vec3(viewMatrix[0][1], viewMatrix[1][1], viewMatrix[2][1]);
    place = centre + radius * (position.x * right + position.y * up);
    ofCentre = centre;
    ofHalfAxes = halfAxes;
    ofTurn = turn;
    ofColour = colour;
    ofCoatingColour = coatingColour;
    ofCoating = coating;
    gl_Position = projectionMatrix * viewMatrix * vec4(place, 1.0);
  }`;

// The ray of a pixel runs along t from its point on the square; \`enter\` and \`leave\` are the t where it enters and
// leaves.
const fragmentShader = `
  uniform vec3 planes;
  uniform mat4 projectionMatrix;
  varying vec3 place;
  flat varying vec3 ofCentre;
  flat varying vec3 ofHalfAxes;
  flat varying vec4 ofTurn;
  flat varying vec3 ofColour;
  flat varying vec3 ofCoatingColour;
  flat varying float ofCoating;

  vec3 along(vec3 direction) {
    // Turned back by the quaternion.
    return direction + 2.0 * cross(-ofTurn.xyz, cross(-ofTurn.xyz, direction) + ofTurn.w * direction);
  }
  vec3 turned(vec3 direction) {
    return direction + 2.0 * cross(ofTurn.xyz, cross(ofTurn.xyz, direction) + ofTurn.w * direction);
  }
  float largest(vec3 of) { return max(of.x, max(of.y, of.z)); }
  float smallest(vec3 of) { return min(of.x, min(of.y, of.z)); }

  void main() {
    vec3 forward = -vec3(viewMatrix[0][2], viewMatrix[1][2], viewMatrix[2][2]);
    forward += vec3(lessThan(abs(forward), vec3(1e-5))) * 1e-5;
    vec3 axes = ofHalfAxes + ofCoating;
    vec3 from = along(place - ofCentre) / axes, step = along(forward) / axes;
    float a = dot(step, step), b = dot(from, step), c = dot(from, from) - 1.0;
    float discriminant = b * b - a * c;
    if (discriminant < 0.0) discard;
    float root = sqrt(discriminant), enter = (-b - root) / a, leave = (-b + root) / a;
    bool isSection = false;
    // The faces of the box.
    vec3 low = -place / forward, high = (1.0 - place) / forward;
    float inside = largest(min(low, high));
    if (inside > enter) {
      enter = inside;
      isSection = true;
    }
    leave = min(leave, smallest(max(low, high)));
    // The corner that is cut off.
    vec3 crossing = (planes - place) / forward;
    bvec3 rises = greaterThan(forward, vec3(0.0));
    float begin = largest(mix(vec3(-1e9), crossing, rises)), end = smallest(mix(crossing, vec3(1e9), rises));
    if (begin < end && enter >= begin - 1e-6 && enter < end) {
      enter = end;
      isSection = true;
    }
    if (enter >= leave) discard;
    vec3 surface = place + enter * forward;
    vec3 seen = along(surface - ofCentre);
    vec3 core = seen / ofHalfAxes;
    vec3 shade = ofCoating > 0.0 && dot(core, core) > 1.0 ? ofCoatingColour : ofColour;
    if (!isSection) {
      vec3 normal = normalize(turned(seen / (axes * axes)));
      vec3 right = vec3(viewMatrix[0][0], viewMatrix[1][0], viewMatrix[2][0]);
      vec3 up = vec3(viewMatrix[0][1], viewMatrix[1][1], viewMatrix[2][1]);
      vec3 light = normalize(-forward - 0.4 * right + 0.5 * up);
      shade *= 0.45 + 0.65 * max(0.0, dot(normal, light));
    }
    vec4 projected = projectionMatrix * viewMatrix * vec4(surface, 1.0);
    gl_FragDepth = 0.5 + 0.5 * projected.z / projected.w;
    gl_FragColor = vec4(min(shade, 1.0), 1.0);
  }`;

/// The positions of a particle and of its periodic images that reach into the cube.
function imagesOf(centre, radius) {
  const shifts = centre.map((place) => [0, ...(place - radius < 0 ? [1] : []), ...(place + radius > 1 ? [-1] : [])]);
  return shifts[0].flatMap((x) => shifts[1].flatMap((y) => shifts[2].map((z) =>
    [centre[0] + x, centre[1] + y, centre[2] + z])));
}

/// The rotation of an ellipsoid (docs/decks.md) by its roll about x, its elevation and its azimuth.
function turnOf(azimuth, elevation, roll) {
  const about = (x, y, z, degrees) =>
    new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(x, y, z), degrees * Math.PI / 180);
  return about(0, 0, 1, azimuth).multiply(about(0, 1, 0, -elevation)).multiply(about(1, 0, 0, roll));
}

async function columnsOf({columns}) {
  const names = Object.keys(columns);
  const numbers = await Promise.all(names.map((name) => unpackedNumbers(columns[name])));
  return Object.fromEntries(names.map((name, i) => [name, numbers[i]]));
}

/// The values of each attribute of the squares, particle by particle. Lengths are shares of the side of the box.
async function attributesOf(particles, side, fillers) {
  const column = await columnsOf(particles);
  const isSphere = column.diameter_m !== undefined;
  const axes = isSphere ? [column.diameter_m, column.diameter_m, column.diameter_m]
    : [column.axis_1_m, column.axis_2_m, column.axis_3_m];
  const values = {centre: [], halfAxes: [], turn: [], colour: [], coatingColour: [], coating: []};
  for (let i = 0; i < particles.count; ++i) {
    const filler = fillers[column.filler === undefined ? 0 : Math.round(column.filler[i])];
    const halfAxes = axes.map((lengths) => 0.5 * lengths[i] / side);
    const coating = filler.coatingThickness / side;
    const turn = isSphere ? [0, 0, 0, 1]
      : turnOf(column.azimuth_deg[i], column.elevation_deg[i], column.roll_deg[i]).toArray();
    const centre = [column.x_m, column.y_m, column.z_m].map((places) => places[i] / side);
    for (const image of imagesOf(centre, Math.max(...halfAxes) + coating)) {
      values.centre.push(...image);
      values.halfAxes.push(...halfAxes);
      values.turn.push(...turn);
      values.colour.push(...filler.colour);
      values.coatingColour.push(...filler.coatingColour);
      values.coating.push(coating);
    }
  }
  return values;
}

/// The model of the particles of a stage in a box. `fillers` have their `colour`, and of their coating `coatingColour`
/// and `coatingThickness` [m], which is 0 without one.
export async function particleModel(particles, side, fillers) {
  const drawn = fillers.map((filler) => ({...filler,
    colour: channelsOf(filler.colour).map((channel) => channel / 255),
    coatingColour: channelsOf(filler.coatingColour).map((channel) => channel / 255)}));
  const values = await attributesOf(particles, side, drawn);
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.instanceCount = values.coating.length;
  geometry.setAttribute("position", new THREE.Float32BufferAttribute([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  for (const [name, numbers] of Object.entries(values)) {
    const size = numbers.length / geometry.instanceCount;
    geometry.setAttribute(name, new THREE.InstancedBufferAttribute(new Float32Array(numbers), size));
  }
  const material = new THREE.ShaderMaterial({vertexShader, fragmentShader,
    uniforms: {planes: {value: new THREE.Vector3(2, 2, 2)}}});
  const object = new THREE.Mesh(geometry, material);
  object.frustumCulled = false;
  return {
    object,
    setCut: (planes) => material.uniforms.planes.value.set(...planes),
    dispose() {
      material.dispose();
      geometry.dispose();
    },
  };
}
