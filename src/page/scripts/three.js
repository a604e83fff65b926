/// The exports of three.js that the views use. The library is in the page before their modules, as the global `THREE`.

export {
  BufferGeometry, ColorManagement, Data3DTexture, DataTexture, Float32BufferAttribute,
  InstancedBufferAttribute, InstancedBufferGeometry, LinearSRGBColorSpace, LineBasicMaterial, LineSegments, Mesh,
  NearestFilter, OrthographicCamera, Quaternion, RedFormat, Scene, ShaderMaterial, Uint16BufferAttribute, Vector3,
  WebGLRenderer,
} from "three";
export {OrbitControls} from "three/examples/jsm/controls/OrbitControls.js";
