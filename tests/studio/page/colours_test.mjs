/// The colours of the page can be told apart, in light and in dark.

import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import {test} from "node:test";

const style = readFileSync(new URL("../../../src/studio/page/studio.css", import.meta.url), "utf8");
const schemes = [...style.matchAll(/:root \{([^}]*)\}/g)].map(([, text]) => new Map(
  [...text.matchAll(/--([\w-]+): (#[0-9a-f]+)/g)].map(([, name, colour]) => [name, colour])));

/// The relative luminance of a colour, and the contrast of two (WCAG 2.1).
function luminance(colour) {
  const digits = colour.length === 4 ? colour.slice(1).replace(/./g, "$&$&") : colour.slice(1);
  const [red, green, blue] = [0, 2, 4].map((at) => parseInt(digits.slice(at, at + 2), 16) / 255)
    .map((share) => share <= 0.03928 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4);
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

function contrast(one, other) {
  const [dark, light] = [luminance(one), luminance(other)].sort((a, b) => a - b);
  return (light + 0.05) / (dark + 0.05);
}

test("texts, borders of controls and lines stand out", () => {
  assert.equal(schemes.length, 2);
  for (const colours of schemes) {
    for (const paper of ["paper", "panel"]) {
      const of = (name) => contrast(colours.get(name), colours.get(paper));
      for (const text of ["ink", "faint", "accent", "wrong", "warning"]) assert.ok(of(text) >= 4.5, `${text} on ${paper}`);
      assert.ok(of("field") >= 3, `field on ${paper}: ${of("field")}`);
    }
    assert.ok(contrast(colours.get("line"), colours.get("paper")) >= 1.6);
  }
});
