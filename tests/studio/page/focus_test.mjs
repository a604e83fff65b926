/// Where the focus goes once something of the deck is removed.

import assert from "node:assert/strict";
import {test} from "node:test";

import {placesAfterRemoval} from "../../../src/studio/page/focus_after_change.js";

test("the focus goes to what follows, or stands before, or adds another one", () => {
  const materials = [["materials", "a"], ["materials", "b"], ["materials", "c"], ["stages", 0]];
  const after = (path, siblings) => placesAfterRemoval(path, siblings).slice(0, 3);
  assert.deepEqual(after(["materials", "b"], materials), [["materials", "c"], ["materials", "a"], ["materials", "add"]]);
  assert.deepEqual(after(["materials", "c"], materials), [["materials", "b"], ["materials", "add"], ["materials"]]);
  assert.deepEqual(after(["stages", 0], materials), [["stages", 0], ["stages", "add"], ["stages"]]);
  // The element that follows has the index of the one that is removed.
  const fillers = [0, 1, 2].map((i) => ["stages", 0, "filler", i]);
  assert.deepEqual(after(fillers[1], fillers), [fillers[1], fillers[0], ["stages", 0, "filler", "add"]]);
  const places = placesAfterRemoval(["stages", 0, "filler", "gap"], [["stages", 0, "filler", "gap"]]);
  assert.deepEqual(places.slice(0, 4), [["stages", 0, "filler", "add"], ["stages", 0, "filler"], ["stages", 0, "add"], ["stages", 0]]);
  assert.deepEqual(places.at(-1), ["add"]);
});
