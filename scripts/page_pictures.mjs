/// Takes the pictures of pages in docs/figures, in Chromium (scripts/figures):
///
///   node scripts/page_pictures.mjs BRECCIA

import {mkdtemp, rm, writeFile} from "node:fs/promises";
import {tmpdir} from "node:os";
import {join, resolve} from "node:path";
import {spawnSync} from "node:child_process";

import {Browser} from "../tests/studio/page/browser.mjs";
import {Studio} from "../tests/studio/page/studio_process.mjs";

const program = resolve(process.argv[2]);
const figures = resolve(import.meta.dirname ?? new URL(".", import.meta.url).pathname, "../docs/figures");
const folder = await mkdtemp(join(tmpdir(), "breccia-pictures-"));
const browser = await Browser.start("chromium");
const pause = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));

/// Takes a picture of the beginning of a page, once it is drawn.
async function take(page, name, width, height) {
  await page.resize(width, height);
  await pause(3000);
  await writeFile(join(figures, name), await page.picture({width, height}));
}

try {
  const deck = resolve(figures, "../../examples/materials/concrete/concrete.toml");
  const out = join(folder, "concrete");
  const {status} = spawnSync(program, ["run", deck, "--out", out], {stdio: "inherit"});
  if (status !== 0) throw new Error(`breccia run ${deck} has ended with ${status}`);
  await take(await browser.open(`file://${out}/report.html`), "page-concrete.png", 1240, 880);

  const studio = await Studio.start(program, folder);
  await studio.ask("api/new", {name: "composite.toml", example: null});
  await studio.end();
  const opened = await Studio.start(program, folder, ["composite.toml"]);
  const page = await browser.open(opened.address);
  await page.resize(1240, 900);
  await page.until("document.querySelector('.right img')?.naturalWidth > 0");
  await page.value("document.getElementById('folder').textContent = '~/composites'");  // not that of this machine
  await take(page, "studio.png", 1240, 900);
  await opened.end();
} finally {
  await browser.end();
  await rm(folder, {recursive: true, force: true, maxRetries: 5});
}
