/// Tests of the parts of the views of three dimensions that need no browser.

import assert from "node:assert/strict";
import {test} from "node:test";
import {deflateSync} from "node:zlib";

import {unpackedBytes, unpackedNumbers} from "../../../src/page/scripts/compressed_bytes.js";
import {channelsOf, coloursOfPhases} from "../../../src/page/scripts/phase_colours.js";
import {roundLength} from "../../../src/page/scripts/rotatable_view.js";
import {cuts, edgesOf, surfaceOf} from "../../../src/page/scripts/solid_cut.js";

const dot = (a, b) => a.reduce((sum, one, i) => sum + one * b[i], 0);
const minus = (a, b) => a.map((one, i) => one - b[i]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const triangles = (surface) => surface.filter((_, i) => i % 3 === 0).map((_, i) => surface.slice(3 * i, 3 * i + 3));

/// Area and, by the divergence theorem, volume of a surface, whose triangles must face their normals.
function measures(surface) {
  let area = 0, volume = 0;
  for (const [a, b, c] of triangles(surface)) {
    const twice = cross(minus(b.place, a.place), minus(c.place, a.place));
    const size = 0.5 * Math.sqrt(dot(twice, twice));
    area += size;
    volume += size * dot(a.place, a.normal) / 3;
    assert.ok(dot(twice, a.normal) >= 0, "a triangle is seen from outside");
  }
  return {area, volume};
}

const close = (got, wanted) => assert.ok(Math.abs(got - wanted) < 1e-12, `${got} is not ${wanted}`);

test("a cut leaves a closed solid", () => {
  const expected = {
    "a corner": {area: 6, volume: 1 - 0.7 ** 3, edges: 21, length: 12 + 6 * 0.7},
    "across x": {area: 2 + 4 * 0.3, volume: 0.3, edges: 12, length: 8 + 4 * 0.3},
    "across y": {area: 2 + 4 * 0.3, volume: 0.3, edges: 12, length: 8 + 4 * 0.3},
    "across z": {area: 2 + 4 * 0.3, volume: 0.3, edges: 12, length: 8 + 4 * 0.3},
    nothing: {area: 6, volume: 1, edges: 12, length: 12},
  };
  assert.deepEqual(cuts.map(({name}) => name), Object.keys(expected));
  for (const {name, planes} of cuts) {
    const {area, volume, edges, length} = expected[name];
    const found = measures(surfaceOf(planes(0.3)));
    close(found.area, area);
    close(found.volume, volume);
    const ends = edgesOf(planes(0.3));
    assert.equal(ends.length, 2 * edges);
    const lengths = ends.filter((_, i) => i % 2 === 0).map((end, i) => Math.hypot(...minus(ends[2 * i + 1], end)));
    close(lengths.reduce((sum, one) => sum + one), length);
  }
});

test("cuts at the ends", () => {
  for (const {name, planes} of cuts) {
    close(measures(surfaceOf(planes(1))).volume, 1);
    close(measures(surfaceOf(planes(0))).volume, name === "nothing" ? 1 : 0);
  }
});

test("a slab is cut off where its plane says", () => {
  const places = surfaceOf(cuts.find(({name}) => name === "across y").planes(0.25)).map(({place}) => place);
  assert.deepEqual([0, 1, 2].map((axis) => Math.max(...places.map((place) => place[axis]))), [1, 0.25, 1]);
});

test("packed bytes and numbers", async () => {
  const pack = (bytes) => deflateSync(Uint8Array.from(bytes)).toString("base64");
  assert.deepEqual([...await unpackedBytes(pack([0, 255, 7]))], [0, 255, 7]);
  const numbers = await unpackedNumbers({from: -1, to: 3, values: pack([0, 0, 0xff, 0xff, 0, 0x80])});
  assert.deepEqual([...numbers.slice(0, 2)], [-1, 3]);
  close(numbers[2], -1 + 4 * 32768 / 65535);
});

test("colours of phases", () => {
  const fillers = [{material: "glass", coating: {material: "skin"}}, {material: "steel", coating: null},
    {material: "glass", coating: null}];
  assert.deepEqual(coloursOfPhases(fillers), ["#f3e9d8", "#5b7f95", "#b5652b", "#6b8e4e"]);
  assert.deepEqual(channelsOf("#5b7f95"), [91, 127, 149]);
  assert.deepEqual(channelsOf("0a0B0c"), [10, 11, 12]);
});

test("lengths of scale bars", () => {
  for (const [most, length] of [[0.3, 0.2], [0.5, 0.5], [7e-4, 5e-4], [1e-3, 1e-3], [19, 10]]) {
    close(roundLength(most) / length, 1);
  }
});
