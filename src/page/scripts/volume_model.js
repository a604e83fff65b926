/// A cube of coloured cells, drawn as the surface of the body that a cut leaves. The global `THREE` is three.js.

import {unpackedBytes} from "./compressed_bytes.js";
import {surfaceOf} from "./solid_cut.js";

const vertexShader = `
  attribute vec3 outward;
  varying vec3 place;
  void main() {
    // The point is moved into the cell under the surface, out of the one that has been cut away.
    place = position - 1e-4 * outward;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

const fragmentShader = `
  precision highp sampler3D;
  uniform sampler3D cells;
  uniform sampler2D colours;
  varying vec3 place;
  void main() {
    int colour = int(255.0 * texture(cells, place).r + 0.5);
    gl_FragColor = vec4(texelFetch(colours, ivec2(colour, 0), 0).rgb, 1.0);
  }`;

/// The colours as a texture of 256 colours, filled up with the last one.
function colourTexture(colours) {
  const data = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; ++i) data.set([...colours[Math.min(i, colours.length - 1)], 255], 4 * i);
  const texture = new THREE.DataTexture(data, 256, 1);
  texture.needsUpdate = true;
  return texture;
}

/// The model of a volume: `cells` along x, y and z, `values` with the colour of each (compressed_bytes.js), and the colours, each
/// with red, green and blue from 0 to 255.
export async function volumeModel({cells, values}, colours) {
  const texture = new THREE.Data3DTexture(await unpackedBytes(values), ...cells);
  Object.assign(texture, {format: THREE.RedFormat, unpackAlignment: 1, needsUpdate: true});
  const palette = colourTexture(colours);
  const material = new THREE.ShaderMaterial({vertexShader, fragmentShader,
    uniforms: {cells: {value: texture}, colours: {value: palette}},
    polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1});
  const geometry = new THREE.BufferGeometry();
  return {
    object: new THREE.Mesh(geometry, material),
    setCut(planes) {
      const surface = surfaceOf(planes);
      const attribute = (name, of) =>
        geometry.setAttribute(name, new THREE.Float32BufferAttribute(surface.flatMap(of), 3));
      attribute("position", ({place}) => place);
      attribute("outward", ({normal}) => normal);
      geometry.computeBoundingSphere();
    },
    dispose() {
      for (const one of [texture, palette, material, geometry]) one.dispose();
    },
  };
}
