/// Where the focus goes once a change of the deck is made, since the control that has made it may be gone.

/// Controls have the path to which they belong as data-focus, places with several of them as data-path.
const selectorOf = (name, path) => `[data-${name}="${CSS.escape(JSON.stringify(path))}"]`;

export class FocusAfterChange {
  #paths = [];
  #origin = null;
  #change = null;

  /// The focus goes to the first of these paths that is there after the change that is made next.
  goesTo(paths) {
    this.#paths = paths;
    this.#origin = document.activeElement;
    this.#change = null;
  }

  /// The focus goes to what takes the place of the value at a path, which is about to be removed.
  afterRemovalOf(path) {
    const place = document.querySelector(selectorOf("path", path));
    const siblings = [...place?.parentElement.children ?? []].filter(({dataset}) => dataset.path !== undefined)
      .map(({dataset}) => JSON.parse(dataset.path));
    this.goesTo(placesAfterRemoval(path, siblings));
  }

  /// The change at a path is the one after which the focus goes; others may be under way.
  waitsFor(path) {
    this.#change ??= JSON.stringify(path);
  }

  stays() {
    this.#paths = [];
  }

  /// Puts the focus where it is to go after a change at a path, unless the user has gone elsewhere meanwhile.
  goAfter(path) {
    if (this.#paths.length === 0 || this.#change !== JSON.stringify(path)) return;
    const active = document.activeElement;
    const hasLeft = active !== this.#origin && active !== document.body && active !== null;
    const control = hasLeft ? undefined : this.#paths.map(controlAt).find((one) => one !== undefined);
    this.#paths = [];
    control?.focus();
    control?.select?.();
  }
}

/// The control of a path, or the first one within its place.
function controlAt(path) {
  const isUsable = (one) => !one.disabled && one.offsetParent !== null;
  return [...document.querySelectorAll(selectorOf("focus", path)),
    ...document.querySelectorAll(`${selectorOf("path", path)} [data-focus]`)].find(isUsable);
}

/// The paths at which something is left to take the focus after a value is removed, the best first: the value that
/// follows it in the same table or array, the one before it, the list with which values are added there, and the places
/// around it. `siblings` are the paths of the values beside it as the form shows them.
export function placesAfterRemoval(path, siblings) {
  const around = path.slice(0, -1);
  const beside = siblings.filter((one) => one.length === path.length && around.every((part, i) => part === one[i]))
    .map((one) => one.at(-1));
  const at = beside.indexOf(path.at(-1));
  // The element that follows in an array has the index of the one that is removed.
  const next = typeof path.at(-1) === "number" ? [path.at(-1)] : beside.slice(at + 1, at + 2);
  const places = at < 0 ? [] : [...next, ...at > 0 ? [beside[at - 1]] : []].map((part) => [...around, part]);
  for (let length = around.length; length >= 0; --length) {
    places.push([...around.slice(0, length), "add"], ...length > 0 ? [around.slice(0, length)] : []);
  }
  return places;
}
