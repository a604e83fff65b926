/// A view of a cube that the reader turns by mouse, touch or keys. All views use one renderer and copy its pictures.
/// The global `THREE` is three.js.

import {element} from "./elements.js";
import {fileName} from "./files.js";
import {display} from "./numbers.js";
import {cuts, edgesOf} from "./solid_cut.js";
import {isContextLost, renderer, watchContext} from "./view_renderer.js";
import {turnAfterTap} from "./view_touch.js";

/// Direction from which a view is seen at first: its azimuth from x and its elevation above the xy plane [degrees].
const home = [35, 22];
const directions = {x: [0, 0], y: [-90, 0], z: [-90, 90]};
const turnOfKey = 7.5, zoomOfKey = 1.2;
const halfHeight = 0.92, distance = 4;

function edgeLines() {
  const lines = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({color: 0x2f4858}));
  lines.frustumCulled = false;
  const setCut = (planes) => lines.geometry.setAttribute("position",
    new THREE.Float32BufferAttribute(edgesOf(planes).flat(), 3));
  return {lines, setCut};
}

/// A round length, 1, 2 or 5 times a power of ten, of at most `most`.
export function roundLength(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  return [5, 2, 1].find((factor) => factor * power <= most * (1 + 1e-9)) * power;
}

/// The factor by which the pixels of a view are coarser while it is dragged on a slow machine, so that it follows.
function dragPace() {
  const slow = 60, coarsest = 4;
  let coarseness = 1, isDragged = false, last = 0;
  return {
    begin() {
      isDragged = true;
      last = performance.now();
    },
    end() {
      isDragged = false;
      coarseness = 1;
    },
    ofNextFrame() {
      const now = performance.now();
      if (isDragged && now - last > slow) coarseness = Math.min(coarsest, 1.5 * coarseness);
      last = now;
      return coarseness;
    },
  };
}

/// The camera, and the controls that turn it. `begun` and `ended` are called when the reader starts and stops dragging.
function turnableCamera(canvas, {changed, begun, ended}) {
  const camera = new THREE.OrthographicCamera(-1, 1, halfHeight, -halfHeight, 0.1, 2 * distance);
  camera.up.set(0, 0, 1);
  const controls = new THREE.OrbitControls(camera, canvas);
  controls.target.set(0.5, 0.5, 0.5);
  Object.assign(controls, {minZoom: 0.5, maxZoom: 40, zoomToCursor: true});
  controls.addEventListener("change", changed);
  controls.addEventListener("start", begun);
  controls.addEventListener("end", ended);
  const lookFrom = ([azimuth, elevation]) => {
    // The elevation stays just below 90 degrees, where no direction would be upwards.
    const [a, e] = [azimuth, Math.max(-89.99, Math.min(89.99, elevation))].map((degrees) => degrees * Math.PI / 180);
    camera.position.set(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e))
      .multiplyScalar(distance).add(controls.target);
    controls.update();
    changed();
  };
  const direction = () => {
    const {x, y, z} = camera.position.clone().sub(controls.target).normalize();
    return [Math.atan2(y, x), Math.asin(z)].map((angle) => angle * 180 / Math.PI);
  };
  return {
    camera,
    lookFrom,
    turn: (azimuth, elevation) => lookFrom([direction()[0] + azimuth, direction()[1] + elevation]),
    zoom(factor) {
      camera.zoom = Math.min(controls.maxZoom, Math.max(controls.minZoom, camera.zoom * factor));
      camera.updateProjectionMatrix();
      controls.update();
      changed();
    },
    reset() {
      controls.target.set(0.5, 0.5, 0.5);
      camera.zoom = 1;
      camera.updateProjectionMatrix();
      lookFrom(home);
    },
  };
}

/// The actions of the keys, by the names of the keys.
function actionsOfKeys(view) {
  return {
    ArrowLeft: () => view.turn(-turnOfKey, 0), ArrowRight: () => view.turn(turnOfKey, 0),
    ArrowUp: () => view.turn(0, turnOfKey), ArrowDown: () => view.turn(0, -turnOfKey),
    "+": () => view.zoom(zoomOfKey), "=": () => view.zoom(zoomOfKey), "-": () => view.zoom(1 / zoomOfKey),
    x: () => view.lookFrom(directions.x), y: () => view.lookFrom(directions.y), z: () => view.lookFrom(directions.z),
    0: () => view.reset(), Home: () => view.reset(),
  };
}

function listenToKeys(canvas, actions) {
  canvas.addEventListener("keydown", (event) => {
    const action = actions[event.key];
    if (action === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    action();
  });
  // The wheel alone scrolls the page, as over the pictures. Browsers report a pinch as the wheel with Ctrl.
  canvas.addEventListener("wheel", (event) => {
    if (!event.ctrlKey) event.stopImmediatePropagation();
  }, {capture: true});
}

/// The names of the axes at the ends of the edges that meet in the corner (0, 0, 0), and the scale bar. Their positions
/// are shares of the view, which may have another size on paper.
function labels(side) {
  const names = ["x", "y", "z"].map((name) => element("span", {className: "view-axis"}, name));
  const bar = element("span", {className: "view-scale"});
  const place = (camera) => {
    names.forEach((name, axis) => {
      const end = new THREE.Vector3();
      end.setComponent(axis, 1.06).project(camera);
      name.style.left = `${50 * (1 + end.x)}%`;
      name.style.top = `${50 * (1 - end.y)}%`;
    });
    const width = side * (camera.right - camera.left) / camera.zoom;
    const length = roundLength(0.3 * width);
    bar.style.width = `${100 * length / width}%`;
    bar.textContent = display(length, "m");
  };
  return {elements: [...names, bar], place};
}

/// The choice of a cut, and a slider for its position.
function cutControls(name, changed) {
  let [cut] = cuts;
  const slider = element("input", {type: "range", min: 0, max: 1, step: 0.005, value: 0.5,
    ariaLabel: `Place of the cut of ${name}`, className: "view-slider", oninput: () => show()});
  const choice = element("select", {ariaLabel: `Cut of ${name}`, className: "view-cut", onchange: () => {
    cut = cuts[choice.selectedIndex];
    show();
  }}, ...cuts.map((one) => element("option", {}, `cut off: ${one.name}`)));
  const show = () => {
    slider.disabled = cut.name === "nothing";
    changed(cut.planes(Number(slider.value)));
  };
  return {elements: [choice, slider], planes: () => cut.planes(Number(slider.value))};
}

/// A figure with a view of a box of this side [m], drawn when the reader scrolls to it. `build` returns a promise of a
/// model (volume_model.js, particle_model.js); `choices` are controls above the view, `below` are elements below it.
/// Returns the figure, and `show`, which takes another `build`.
export function rotatableView({name, caption, side, build, choices = [], below = []}) {
  const canvas = element("canvas", {tabIndex: 0, role: "img", className: "view-canvas",
    ariaLabel: `${caption}. The arrow keys turn it, plus and minus zoom, x, y and z look along an axis, 0 goes back.`});
  const marks = labels(side);
  const frame = element("div", {className: "picture view"}, canvas, ...marks.elements);
  const complaint = element("p", {className: "note", role: "alert"});
  const figure = element("figure", {className: "rotatable"});
  const scene = new THREE.Scene();
  const edges = edgeLines();
  scene.add(edges.lines);
  const pace = dragPace();
  let model, isDue = false, wanted = build, isSeen = false;

  const draw = () => {
    isDue = false;
    if (model === undefined || isContextLost()) return;
    const {clientWidth: width, clientHeight: height} = canvas;
    if (width === 0) return;
    const scale = Math.min(2, Math.max(1.5, devicePixelRatio)) / pace.ofNextFrame();
    const size = [width, height].map((length) => Math.round(scale * length));
    if (canvas.width !== size[0] || canvas.height !== size[1]) [canvas.width, canvas.height] = size;
    const {camera} = view;
    [camera.left, camera.right] = [-halfHeight * width / height, halfHeight * width / height];
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    renderer().setSize(...size, false);
    renderer().render(scene, camera);
    canvas.getContext("2d").drawImage(renderer().domElement, 0, 0);
    marks.place(camera);
    figure.dataset.drawn = Number(figure.dataset.drawn ?? 0) + 1;
  };
  const drawSoon = () => {
    if (!isDue) requestAnimationFrame(draw);
    isDue = true;
  };
  const cut = (planes) => {
    edges.setCut(planes);
    model?.setCut(planes);
    drawSoon();
  };
  const controls = cutControls(name, cut);
  const view = turnableCamera(canvas, {changed: drawSoon, begun: pace.begin, ended() {
    pace.end();
    drawSoon();
  }});
  listenToKeys(canvas, actionsOfKeys(view));
  turnAfterTap(canvas, frame);
  watchContext((isLost) => {
    complaint.textContent = isLost ? "The browser has taken the graphics away; the view waits for them." : "";
    if (!isLost) drawSoon();
  });

  const take = async (asked) => {
    const made = await asked();
    if (asked !== wanted) return made.dispose();
    if (model !== undefined) {
      scene.remove(model.object);
      model.dispose();
    }
    model = made;
    scene.add(model.object);
    complaint.textContent = "";
    cut(controls.planes());
  };
  const load = () => {
    const asked = wanted;
    take(asked).catch((error) => {
      if (asked === wanted) complaint.textContent = `This view cannot be drawn: ${error.message}`;
    });
  };
  const button = (text, label, action) => element("button", {ariaLabel: label, onclick: action}, text);
  figure.append(
    element("div", {className: "choices"}, ...choices, ...controls.elements), frame, complaint,
    element("figcaption", {}, caption, ...below),
    element("div", {className: "buttons"},
      ...Object.entries(directions).map(([axis, direction]) =>
        button(axis, `seen along ${axis}`, () => view.lookFrom(direction))),
      button("+", "larger", () => view.zoom(1.5)), button("−", "smaller", () => view.zoom(1 / 1.5)),
      button("All of it", "all of it", () => view.reset()),
      button("PNG", "PNG", () => saveCanvas(canvas, fileName(name, "png")))));

  view.reset();
  new ResizeObserver(drawSoon).observe(canvas);
  // On a busy machine one call may have entries of a figure out of sight that then came near.
  new IntersectionObserver((entries, observer) => {
    if (!entries.some(({isIntersecting}) => isIntersecting)) return;
    observer.disconnect();
    isSeen = true;
    load();
  }, {rootMargin: "400px"}).observe(figure);
  return {
    figure,
    show(nextBuild, nextCaption) {
      wanted = nextBuild;
      figure.querySelector("figcaption").firstChild.textContent = nextCaption;
      if (isSeen) load();
    },
  };
}

function saveCanvas(canvas, name) {
  element("a", {href: canvas.toDataURL("image/png"), download: name}).click();
}
