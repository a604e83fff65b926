/// What a user does with the studio in a browser, against the program itself.

import assert from "node:assert/strict";
import {writeFile} from "node:fs/promises";
import {join} from "node:path";
import {after, before, test} from "node:test";

import {button, expectNoComplaints, field, fill, look, StudioSession} from "./studio_session.mjs";

let session = null;
before(async () => { session = await StudioSession.start(); });
after(() => session.end());

test("from nothing to a result", {timeout: 300000}, async () => {
  const page = await session.openStarter("first");
  await look(page, "start");
  await fill(page, ["stages", 0, "filler", "fraction"], "0.3");
  await fill(page, ["stages", 0, "box"], "8 mm");
  await fill(page, ["stages", 0, "cells"], "[16, 32]");
  const text = await session.deckThat("first.toml", /^cells {3}= \[16, 32\]/m);
  assert.match(text, /fraction = 0\.3,/);
  assert.match(text, /^box {5}= "8 mm" +# side of the box/m);
  assert.match(text, /# A deck to begin with/);

  await page.until("document.querySelector('.right').innerText.includes('together about')");
  await page.until("document.querySelector('.right img')?.naturalWidth > 0");
  await look(page, "compose");
  await page.value(`${button("Run")}.click()`);
  await page.until(button("Open the result"), 240);
  await page.value(`${button("Open the result")}.click()`);
  await page.until("document.querySelector('#results iframe')?.offsetHeight > 0");
  assert.match(await page.value("document.querySelector('#results iframe').src"), /files\/results\/first\/report\.html/);
  assert.equal(await page.value("document.querySelector('#results iframe').getAttribute('sandbox')"),
    "allow-scripts allow-downloads allow-popups");
  await page.until("/Pa.* at 1.ms/.test(document.getElementById('results').innerText)");
  await look(page, "result");
  expectNoComplaints(page);
});

test("boxes and grids are chosen for an error, in three dimensions and with E", {timeout: 120000}, async () => {
  const page = await session.openStarter("chosen");
  await page.value(`${button("Choose boxes and grids for an error of 5 %")}.click()`);
  const text = await session.deckThat("chosen.toml", /^accuracy = "5 %"/m);
  assert.doesNotMatch(text, /^(box|cells) /m);
  await page.until("document.querySelector('.right').innerText.includes('together about')");
  await page.value(`${button("Also E, K and Poisson's ratio")}.click()`);
  await session.deckThat("chosen.toml", /^loads += \["isotropic", "bulk"\]/m);
  await page.value(`(() => { const list = ${field(["dimensions"])}; list.value = "3";
    list.dispatchEvent(new Event("change")); })()`);
  await session.deckThat("chosen.toml", /^dimensions = 3/m);
  expectNoComplaints(page);
});

test("mistakes stand at their fields, and what was typed stays", {timeout: 120000}, async () => {
  const page = await session.openStarter("mistakes");
  await fill(page, ["stages", 0, "box"], "8 kg");
  const mistake = "document.querySelector('.field.wrong .mistake:not([hidden])')";
  await page.until(mistake);
  assert.match(await page.value(`${mistake}.innerText`), /expected a length/);
  assert.equal(await page.value(`${field(["stages", 0, "box"])}.value`), "8 kg");
  assert.match(await page.value("document.querySelector('.mistakes').innerText"), /One mistake in the deck/);
  await fill(page, ["stages", 0, "box"], "8 mm");
  await page.until("document.querySelector('.mistakes').hidden");
  // By hand in the text.
  await page.value("document.querySelector('#text').open = true");
  await page.value("(() => { const area = document.getElementById('deck-text'); area.focus(); area.setSelectionRange(0, 0); })()");
  await page.type("foo = 1\n");
  await page.until("document.querySelector('.mistakes').innerText.includes('foo')");
  await session.deckThat("mistakes.toml", /^foo = 1\n/);
  expectNoComplaints(page);
});

test("a slow answer overwrites nothing, and shows nothing of an earlier text", {timeout: 120000}, async () => {
  const page = await session.openStarter("slow");
  await page.until("document.querySelector('.right').innerText.includes('13 cells across')");
  await page.value(`(() => { const fast = window.fetch; window.fetch = (address, options) => /api\\/(edit|check)/.test(address)
    ? new Promise((done) => setTimeout(done, 700)).then(() => fast(address, options)) : fast(address, options); })()`);
  await page.value("document.querySelector('#text').open = true");
  await fill(page, ["stages", 0, "filler", "fraction"], "0.3");
  await page.value("(() => { const area = document.getElementById('deck-text'); area.focus(); area.setSelectionRange(0, 0); })()");
  await page.type("# typed meanwhile\n");
  assert.match(await session.deckThat("slow.toml", /fraction = 0\.3,/), /^# typed meanwhile\n/);
  // Undo while the plan of another text is under way.
  await fill(page, ["stages", 0, "cells"], "[16, 32]");
  await session.deckThat("slow.toml", /\[16, 32\]/);
  await page.until("document.querySelector('.right').innerText.includes('checking')");
  await page.value(`${button("Undo")}.click()`);
  await session.deckThat("slow.toml", /\[64, 128\]/);
  await page.until("!document.querySelector('.right').innerText.includes('checking')");
  assert.match(await page.value("document.querySelector('.right').innerText"), /13 cells across/);
});

test("two windows do not overwrite each other", {timeout: 120000}, async () => {
  const page = await session.openStarter("shared");
  await writeFile(join(session.folder, "shared.toml"), (await session.deckOnDisk("shared.toml")).replace("20 mm", "21 mm"));
  await fill(page, ["stages", 0, "filler", "fraction"], "0.4");
  await page.until(button("Keep what is on this page"));
  assert.match(await session.deckOnDisk("shared.toml"), /21 mm/);  // nothing has been overwritten
  // What is not saved is still there after another deck was open.
  const open = async (name) => {
    await page.value("document.getElementById('to-start').click()");
    const ofDeck = `[...document.querySelectorAll("button.deck")].find((one) => one.innerText.endsWith("${name}"))`;
    await page.until(ofDeck);
    await page.value(`${ofDeck}.click()`);
    await page.until(`document.getElementById("to-compose").textContent === "${name}"`);
  };
  await open("first.toml");
  await open("shared.toml");
  await page.until(button("Load what is on the disk"));
  // Another text than the one that is shown does not run.
  await page.value(`${button("Run")}.click()`);
  await page.until("document.querySelector('.run .mistake').innerText.includes('not saved')");
  await page.value(`${button("Load what is on the disk")}.click()`);
  await page.until(`${field(["stages", 0, "box"])}.value === "21 mm"`);
  assert.match(await session.deckOnDisk("shared.toml"), /fraction = 0\.50/);
});

test("measured data become a binder", {timeout: 180000}, async () => {
  const rows = Array.from({length: 25}, (_, i) => 10 ** (-3 + i / 4))
    .map((omega) => `${omega},${2e6 * omega ** 2 / (1 + omega ** 2) + 1e5},${2e6 * omega / (1 + omega ** 2)}`);
  await writeFile(join(session.folder, "rheometer.csv"),
    ["angular_frequency_rad_per_s,storage_modulus_Pa,loss_modulus_Pa", ...rows].join("\n"));
  const page = await session.openStarter("measured");
  const panel = "document.querySelector('details.fit')";
  await page.value(`${panel}.open = true`);
  await page.until(`[...${panel}.querySelectorAll("option")].some((one) => one.value === "rheometer.csv")`);
  await page.value(`(() => { const list = ${panel}.querySelector("select"); list.value = "rheometer.csv";
    list.dispatchEvent(new Event("change")); })()`);
  await page.until(button("Use it as shear of binder"));
  assert.match(await page.value(`${panel}.innerText`), /25 rows/);
  await look(page, "fit");
  // What was chosen after the fit is not what was fitted.
  await page.value(`(() => { const input = ${panel}.querySelector("input[type=text]"); input.value = "nonsense";
    input.dispatchEvent(new Event("input")); })()`);
  assert.ok(await page.value(`!${button("Use it as shear of binder")}`));
  await page.value(`(() => { const input = ${panel}.querySelector("input[type=text]"); input.value = ""; })()`);
  await page.value(`${button("Fit")}.click()`);
  await page.until(button("Use it as shear of binder"));
  await page.value(`${button("Use it as shear of binder")}.click()`);
  await session.deckThat("measured.toml", /shear {3}= \{ measured = "rheometer\.csv" \}/);
  await page.until("document.querySelector('.right').innerText.includes('together about')");
});

test("by keyboard alone, and in a narrow window", {timeout: 120000}, async () => {
  const page = await session.browser.open(session.studio.address);
  await page.resize(500, 900);
  await page.until("document.getElementById('new-name')?.offsetParent");
  const reach = async (expression) => {
    for (let presses = 0; presses < 400; ++presses) {
      if (await page.value(`document.activeElement === ${expression}`)) return;
      await page.press("Tab");
    }
    assert.fail(`not reached by the key Tab: ${expression}`);
  };
  await reach("document.getElementById('new-name')");
  await page.type("keyboard");
  await reach(button("Begin with the starter deck"));
  await page.press("Enter");
  await page.until(field(["stages", 0, "box"]));
  await reach(field(["stages", 0, "box"]));
  await page.press("a", 2);
  await page.type("9 mm");
  await page.press("Tab");
  await session.deckThat("keyboard.toml", /^box +=\s"9 mm"/m);
  assert.ok(await page.value("document.documentElement.scrollWidth <= 500"));
  await look(page, "narrow");
});

test("the end of the studio is said, and nothing is lost", {timeout: 120000}, async () => {
  const page = await session.openStarter("lost");
  await session.studio.end("SIGKILL");
  await fill(page, ["stages", 0, "box"], "7 mm");
  await page.until("!document.getElementById('ended').hidden");
  assert.equal(await page.value(`${field(["stages", 0, "box"])}.value`), "7 mm");
  await session.restart();
});
