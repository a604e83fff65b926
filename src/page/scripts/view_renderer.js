/// The renderer that all views share, since a browser has few WebGL contexts. The global `THREE` is three.js.

let sharedRenderer;
const watchers = [];

/// The renderer; undefined where the browser has no WebGL 2.
export function renderer() {
  if (sharedRenderer !== undefined) return sharedRenderer;
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("webgl2", {antialias: true});
  if (context === null) return undefined;
  // The colours are those of the pictures, unchanged.
  THREE.ColorManagement.enabled = false;
  sharedRenderer = new THREE.WebGLRenderer({canvas, context});
  sharedRenderer.outputColorSpace = THREE.LinearSRGBColorSpace;
  sharedRenderer.setClearColor(0xffffff);
  // These listeners are added after those of the renderer, which requests a new context and fills it.
  for (const event of ["webglcontextlost", "webglcontextrestored"]) {
    canvas.addEventListener(event, () => watchers.forEach((watcher) => watcher(event === "webglcontextlost")));
  }
  return sharedRenderer;
}

/// Whether this browser draws the views.
export function drawsViews() {
  return typeof DecompressionStream !== "undefined" && renderer() !== undefined;
}

/// Whether the browser has taken the context away, as it may when the graphics card is reset or many pages use it.
export function isContextLost() {
  return renderer().getContext().isContextLost();
}

/// Calls `watcher` with true when the context is lost, and with false when there is another one.
export function watchContext(watcher) {
  watchers.push(watcher);
}
