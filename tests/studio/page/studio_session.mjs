/// A studio in a folder of its own with a browser in front of it, and what a user does there, for tests.

import assert from "node:assert/strict";
import {mkdtemp, readFile, rm, writeFile} from "node:fs/promises";
import {tmpdir} from "node:os";
import {join} from "node:path";

import {Browser} from "./browser.mjs";
import {Studio} from "./studio_process.mjs";

export class StudioSession {
  static async start() {
    const session = new StudioSession();
    session.folder = await mkdtemp(join(tmpdir(), "breccia-studio-test-"));
    session.browser = await Browser.start("chromium");
    await session.restart();
    return session;
  }

  /// Starts the studio, which may have ended, in the same folder.
  async restart() {
    this.studio = await Studio.start(process.env.BRECCIA, this.folder);
  }

  async end() {
    await this.browser.end();
    await this.studio.end("SIGKILL");
    await rm(this.folder, {recursive: true, force: true, maxRetries: 5});
  }

  deckOnDisk(name) {
    return readFile(join(this.folder, name), "utf8");
  }

  /// Waits until the deck on the disk is as expected, and returns it.
  async deckThat(name, expected) {
    for (let tries = 0; tries < 600; ++tries) {
      const text = await this.deckOnDisk(name);
      if (expected.test(text)) return text;
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    return assert.match(await this.deckOnDisk(name), expected);
  }

  /// Begins a deck with the starter deck.
  async openStarter(name) {
    const page = await this.browser.open(this.studio.address);
    await page.resize(1400, 1000);
    await page.until("document.getElementById('new-name')?.offsetParent");
    await page.value("document.getElementById('new-name').focus()");
    await page.type(name);
    await page.value(`${button("Begin with the starter deck")}.click()`);
    await page.until(field(["stages", 0, "box"]));
    return page;
  }
}

/// Keeps a picture of the page where the caller of the test wants them.
export async function look(page, name) {
  if (process.env.PICTURES) await writeFile(join(process.env.PICTURES, `${name}.png`), await page.picture());
}

/// Expressions for a field by the path of its value, and for a button by its text.
export const field = (path) => `document.querySelector(${JSON.stringify(`[data-focus='${JSON.stringify(path)}']`)})`;
export const button = (text, within = "document") =>
  `[...${within}.querySelectorAll("button")].find((one) => one.textContent === ${JSON.stringify(text)} && one.offsetParent)`;

/// Types a value into a field as a user does, and leaves the field.
export async function fill(page, path, value) {
  await page.until(field(path));
  await page.value(`${field(path)}.focus(), ${field(path)}.select()`);
  await page.type(value);
  await page.press("Tab");
}

/// Chooses a value of a list.
export async function choose(page, list, value) {
  await page.until(list);
  await page.value(`(() => { const list = ${list}; list.focus(); list.value = ${JSON.stringify(value)};
    list.dispatchEvent(new Event("change")); })()`);
}

/// A check that a later one has overtaken is answered by 409, which the browser notes.
export const expectNoComplaints = (page) => assert.deepEqual(page.complaints.filter((one) => !one.includes("409")), []);
