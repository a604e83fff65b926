/// A browser without a window, driven by the DevTools protocol over two pipes.

import {spawn} from "node:child_process";
import {mkdtemp, rm} from "node:fs/promises";
import {tmpdir} from "node:os";
import {join} from "node:path";

const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/// A page in the browser.
export class Page {
  #send;

  constructor(send, complaints) {
    this.#send = send;
    /// What the page has complained of: errors, warnings, what its policy has blocked.
    this.complaints = complaints;
  }

  /// The value of an expression in the page, which may be a promise.
  async value(expression) {
    const {result, exceptionDetails} = await this.#send("Runtime.evaluate",
      {expression, awaitPromise: true, returnByValue: true});
    if (exceptionDetails) throw new Error(`${expression}: ${exceptionDetails.exception?.description}`);
    return result.value;
  }

  /// Waits until an expression in the page is true; throws after a minute, with what the page shows.
  async until(expression, seconds = 60) {
    for (let tries = 0; tries < 20 * seconds; ++tries) {
      if (await this.value(`Boolean(${expression})`)) return;
      await pause(50);
    }
    const shown = await this.value("document.body.innerText");
    throw new Error(`not within ${seconds} s: ${expression}\n${shown}\n${this.complaints.join("\n")}`);
  }

  /// Presses a key, such as "Tab", "Enter" or "a", with the element in focus.
  async press(key, modifiers = 0) {
    const codes = {Tab: 9, Enter: 13, Escape: 27, " ": 32, ArrowDown: 40, ArrowUp: 38};
    const text = key === "Enter" ? "\r" : key.length === 1 ? key : undefined;
    const event = {key, modifiers, text: modifiers ? undefined : text,
      windowsVirtualKeyCode: codes[key] ?? key.toUpperCase().charCodeAt(0)};
    await this.#send("Input.dispatchKeyEvent", {type: "keyDown", ...event});
    await this.#send("Input.dispatchKeyEvent", {type: "keyUp", ...event, text: undefined});
  }

  /// Types a text into the element in focus.
  async type(text) {
    await this.#send("Input.insertText", {text});
  }

  async resize(width, height) {
    await this.#send("Emulation.setDeviceMetricsOverride", {width, height, deviceScaleFactor: 1, mobile: false});
  }

  /// The bytes of a picture (PNG) of the whole page, or of its beginning with a width and height in pixels.
  async picture(size = undefined) {
    const clip = size && {x: 0, y: 0, scale: 1, ...size};
    const {data} = await this.#send("Page.captureScreenshot", {format: "png", captureBeyondViewport: !size, clip});
    return Buffer.from(data, "base64");
  }

  async reload() {
    await this.#send("Page.reload");
  }
}

export class Browser {
  #process;
  #profile;
  #waiting = new Map();
  #listeners = [];
  #number = 0;
  #rest = "";

  /// Starts a browser that reaches this machine alone.
  static async start(program) {
    const browser = new Browser();
    browser.#profile = await mkdtemp(join(tmpdir(), "breccia-browser-"));
    browser.#process = spawn(program, ["--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
      "--remote-debugging-pipe", `--user-data-dir=${browser.#profile}`, "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1"],
    {stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"]});
    browser.#process.stdio[4].setEncoding("utf8").on("data", (text) => browser.#take(text));
    return browser;
  }

  /// Opens an address in a page.
  async open(address) {
    const {targetId} = await this.#send("Target.createTarget", {url: "about:blank"});
    const {sessionId} = await this.#send("Target.attachToTarget", {targetId, flatten: true});
    const send = (method, parameters) => this.#send(method, parameters, sessionId);
    const complaints = [];
    this.#listeners.push(({method, params, sessionId: session}) => {
      if (session !== sessionId) return;
      if (method === "Runtime.exceptionThrown") complaints.push(params.exceptionDetails.exception?.description);
      if (method === "Log.entryAdded" && params.entry.level === "error") complaints.push(params.entry.text);
      if (method === "Runtime.consoleAPICalled" && ["error", "warning"].includes(params.type)) {
        complaints.push(params.args.map((one) => one.value ?? one.description).join(" "));
      }
    });
    for (const domain of ["Page", "Runtime", "Log"]) await send(`${domain}.enable`);
    await send("Page.navigate", {url: address});
    const page = new Page(send, complaints);
    await page.until("document.readyState === 'complete'");
    return page;
  }

  async end() {
    this.#process.kill("SIGKILL");
    await new Promise((resolve) => this.#process.once("close", resolve));
    await rm(this.#profile, {recursive: true, force: true, maxRetries: 5});
  }

  #send(method, params = {}, sessionId = undefined) {
    const id = ++this.#number;
    this.#process.stdio[3].write(`${JSON.stringify({id, method, params, sessionId})}\0`);
    return new Promise((resolve, reject) => this.#waiting.set(id, {resolve, reject}));
  }

  #take(text) {
    const messages = (this.#rest + text).split("\0");
    this.#rest = messages.pop();
    for (const message of messages.map((one) => JSON.parse(one))) {
      const waiting = this.#waiting.get(message.id);
      this.#waiting.delete(message.id);
      if (waiting && message.error) waiting.reject(new Error(message.error.message));
      else if (waiting) waiting.resolve(message.result);
      else this.#listeners.forEach((listener) => listener(message));
    }
  }
}
