/// The calls to the server of the studio. All addresses are relative to the page.

/// A call that the server has refused: its status, its message, and what else it has answered.
export class Refused extends Error {
  constructor(status, answer) {
    super(answer?.error ?? `the studio has answered ${status}`);
    this.status = status;
    this.answer = answer ?? {};
  }
}

/// A call that no server has answered.
export class Ended extends Error {
  constructor() {
    super("the studio has ended: start it again by `breccia studio`");
  }
}

const listeners = [];

/// Calls listener(isReached) whenever a call shows that the server is there, or that it is not.
export function whenReached(listener) {
  listeners.push(listener);
}

async function call(address, options = {}) {
  let [response, answer] = [null, null];
  try {
    response = await fetch(address, {cache: "no-store", ...options});
    answer = await response.json().catch(() => null);
  } catch {
    listeners.forEach((listener) => listener(false));
    throw new Ended();
  }
  listeners.forEach((listener) => listener(true));
  if (!response.ok) throw new Refused(response.status, answer);
  return answer;
}

const post = (address, value) => call(address, {
  method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify(value),
});

export const getState = () => call("api/state");
export const newDeck = (name, example) => post("api/new", {name, example});
export const getDeck = (name) => call(`api/deck?name=${encodeURIComponent(name)}`);
export const saveDeck = (deck) => post("api/deck", deck);
export const editDeck = (edit) => post("api/edit", edit);
export const check = (name) => post("api/check", {name});
export const pack = (name) => post("api/pack", {name});
export const fit = (file, options) => post("api/fit", {file, options});
export const run = (name, options) => post("api/run", {name, options});
export const runCommand = (name, options) => post("api/run-command", {name, options});
export const stop = () => post("api/stop", {});
export const getJob = () => call("api/job");
export const compare = (results) => post("api/compare", {results});

export const upload = (file) => call(`api/upload?name=${encodeURIComponent(file.name)}`, {
  method: "POST", headers: {"Content-Type": "application/octet-stream"}, body: file,
});

/// The text of a file of the folder, or null if it is not there.
export async function fileText(path) {
  try {
    const response = await fetch(addressOf(path), {cache: "no-store"});
    return response.ok ? await response.text() : null;
  } catch {
    return null;
  }
}

/// The address of a file of the folder.
export function addressOf(path) {
  const parts = path.startsWith("files/") ? path.split("/") : ["files", ...path.split("/")];
  return parts.map(encodeURIComponent).join("/");
}
