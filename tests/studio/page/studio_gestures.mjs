/// Single gestures on the form of a deck: where the focus goes, what one step of undo is, what a choice writes.

import assert from "node:assert/strict";
import {cp} from "node:fs/promises";
import {join} from "node:path";
import {after, before, test} from "node:test";

import {button, choose, expectNoComplaints, field, fill, look, StudioSession} from "./studio_session.mjs";

let session = null;
before(async () => { session = await StudioSession.start(); });
after(() => session.end());

const labelled = (label) => `[...document.querySelectorAll("button")].find((one) => one.ariaLabel === ${JSON.stringify(label)})`;
const focused = (page) => page.value("document.activeElement?.dataset?.focus ?? document.activeElement?.tagName");

/// Removes something by its cross, as by the keyboard, and returns the path that has the focus afterwards.
async function removed(page, label, isGone) {
  await page.until(labelled(label));
  await page.value(`${labelled(label)}.focus()`);
  await page.press("Enter");
  await page.until(isGone);
  await page.until("document.activeElement !== document.body");
  return JSON.parse(await focused(page));
}

test("after something is removed the focus is at what takes its place", {timeout: 120000}, async () => {
  const page = await session.openStarter("focus");
  const filler = ["stages", 0, "filler"];
  const terms = ["materials", "binder", "shear", "terms"];
  assert.deepEqual(await removed(page, "remove row 2", `!${field([...terms, 2, "time"])}`), [...terms, 1, "time"]);
  assert.deepEqual(await removed(page, "remove row 2", `!${field([...terms, 1, "time"])}`), [...terms, 0, "time"]);
  assert.deepEqual(await removed(page, "remove gap", `!${field([...filler, "gap"])}`), [...filler, "sizes", "form"]);
  await page.value(`${button("Add another filler")}.click()`);
  await page.until(field([...filler, 1, "material"]));
  assert.deepEqual(await removed(page, "remove filler 2", `!${field([...filler, 1, "material"])}`), [...filler, 0, "material"]);
  assert.deepEqual((await removed(page, "remove material particle", `!${field(["materials", "particle", "name"])}`)).slice(0, 2),
    ["materials", "binder"]);
  assert.deepEqual(await removed(page, "remove stage composite", `!${field(["stages", 0, "name"])}`), ["stages", "add"]);
  expectNoComplaints(page);
});

test("a choice that writes several keys is one step of undo", {timeout: 120000}, async () => {
  const page = await session.openStarter("one-step");
  const text = await session.deckOnDisk("one-step.toml");
  await choose(page, field(["stages", 0, "packing", "method"]), '"regular"');
  const regular = await session.deckThat("one-step.toml", /columns = 8, rows = 8/);
  assert.doesNotMatch(regular, /fraction|seed =|gap =/);
  await page.until("document.querySelector('.right').innerText.includes('together about')");
  await page.value(`${button("Undo")}.click()`);
  await session.deckThat("one-step.toml", /fraction = 0\.50/);
  assert.equal(await session.deckOnDisk("one-step.toml"), text);
  await page.until("document.querySelector('.mistakes').hidden");
  expectNoComplaints(page);
});

test("an image asks for its file first, and says where it cannot be a stack", {timeout: 120000}, async () => {
  await cp(new URL("../../../examples/image/micrograph.png", import.meta.url), join(session.folder, "micrograph.png"));
  const page = await session.openStarter("picture");
  const text = await session.deckOnDisk("picture.toml");
  await choose(page, field(["stages", 0, "packing", "method"]), '"image"');
  const question = "[...document.querySelectorAll('.question')].find((one) => one.offsetParent)?.querySelector('select')";
  await page.until(question);
  assert.equal(await session.deckOnDisk("picture.toml"), text);
  await look(page, "question");
  await choose(page, question, "micrograph.png");
  await session.deckThat("picture.toml", /labels = \{ dark = "binder", bright = "particle" \}/);
  await page.until("document.querySelector('.right').innerText.includes('together about')");
  const model = field(["dimensions"]);
  assert.ok(await page.value(`${model}.disabled`));
  assert.match(await page.value(`${model}.closest(".field").innerText`), /A PNG is one picture/);
  // The part of the picture begins with all of it.
  await choose(page, field(["stages", 0, "packing", "add"]), "crop");
  await page.value(`${field(["stages", 0, "packing", "add"])}.nextElementSibling.click()`);
  await session.deckThat("picture.toml", /crop = \{ left = 0, top = 0, width = 400, height = 400 \}/);
  await look(page, "image");
  expectNoComplaints(page);
});

test("materials and stages are renamed and change places", {timeout: 120000}, async () => {
  const page = await session.openStarter("names");
  await fill(page, ["materials", "binder", "name"], "rubber");
  assert.match(await session.deckThat("names.toml", /^matrix {2}= "rubber"/m), /^\[materials\.rubber\] {18}# "binder"/m);
  await page.until("document.activeElement !== document.body");
  assert.deepEqual(JSON.parse(await focused(page)).slice(0, 2), ["materials", "rubber"]);
  await fill(page, ["materials", "rubber", "name"], "particle");
  await page.until("document.querySelector('.field.wrong .mistake:not([hidden])')");
  assert.match(await page.value("document.querySelector('.field.wrong').innerText"), /there is a material particle already/);
  await fill(page, ["materials", "rubber", "name"], "rubber");

  await page.value(`${field(["stages", "add"])}.focus()`);
  await page.type("mortar");
  await page.press("Enter");
  await session.deckThat("names.toml", /^matrix += "composite"/m);
  await fill(page, ["stages", 0, "name"], "mastic");
  await session.deckThat("names.toml", /^matrix += "mastic"/m);
  // A stage stays before that of which it is the matrix.
  assert.ok(await page.value(`${field(["stages", 1, "up"])}.disabled`));
  assert.match(await page.value(`${field(["stages", 1, "up"])}.title`), /has mastic as its matrix/);
  await choose(page, field(["stages", 1, "matrix"]), '"rubber"');
  await page.until(`!${field(["stages", 1, "up"])}.disabled`);
  await page.value(`${field(["stages", 1, "up"])}.focus()`);
  await page.press("Enter");
  await session.deckThat("names.toml", /name += "mortar"[^]*name += "mastic"/);
  await page.until(`document.activeElement === ${field(["stages", 0, "down"])}`);
  await page.value(`${field(["materials", "particle", "up"])}.click()`);
  assert.match(await session.deckThat("names.toml", /materials\.particle[^]*materials\.rubber/), /# the material of the particles/);
  await look(page, "names");
  await page.until("document.querySelector('.right').innerText.includes('together about')");
});

test("a deck that could not be saved says why, and is not tried again for ever", {timeout: 120000}, async () => {
  const page = await session.openStarter("unsaved");
  await page.value(`(() => { const real = window.fetch; window.saves = 0; window.isFull = true;
    window.fetch = (address, options) => address !== "api/deck" || !window.isFull ? real(address, options)
      : (++window.saves, Promise.resolve(new Response('{"error": "the disk is full"}', {status: 500}))); })()`);
  await fill(page, ["stages", 0, "box"], "18 mm");
  await page.until(button("Try again"));
  assert.match(await page.value(`${button("Try again")}.closest(".notice").innerText`), /could not be saved: the disk is full\./);
  const saves = await page.value("window.saves");
  // Other requests go on, and do not save it.
  await page.value("fetch('api/state').then(() => new Promise((done) => setTimeout(done, 2500)))");
  assert.equal(await page.value("window.saves"), saves);
  await page.value("window.isFull = false");
  await page.value(`${button("Try again")}.click()`);
  await session.deckThat("unsaved.toml", /^box {5}= "18 mm"/m);
  await page.until(`!${button("Try again")}`);
});

test("what was refused in a table goes with the table", {timeout: 120000}, async () => {
  const page = await session.openStarter("refused");
  await fill(page, ["stages", 0, "filler", "fraction"], "[0.3");
  await page.until("document.querySelector('.mistakes').innerText.includes('fraction')");
  await page.value(`${labelled("remove filler")}.click()`);
  await page.until(`!${field(["stages", 0, "filler", "fraction"])}`);
  await page.until("!document.querySelector('.mistakes').innerText.includes('fraction')");
  await session.deckThat("refused.toml", /^cells .*\n(#.*\n)+packing/m);
});
