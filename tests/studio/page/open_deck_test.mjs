/// The deck that is open, against a studio that answers what a test wants.

import assert from "node:assert/strict";
import {beforeEach, test} from "node:test";

import {OpenDeck} from "../../../src/studio/page/open_deck.js";

/// What the studio does with a request, by its address: (request) => answer, or a status with an error.
let studio = {};
let requests = [];

globalThis.fetch = async (address, options) => {
  const request = options.body === undefined ? {} : JSON.parse(options.body);
  requests.push([address, request]);
  const answer = studio[address](request);
  return {ok: answer.error === undefined, status: answer.status ?? 200, json: async () => answer};
};

const treeOf = (keys) => ({type: "table", entries: keys.map((key) => ({key, value: {type: "table", entries: []}}))});

beforeEach(() => {
  requests = [];
  studio = {
    "api/edit": ({text, changes}) => ({text: `${text}|${changes.map(({value}) => value).join("+")}`, tree: treeOf(["a", "b"]),
      mistakes: [], command: null}),
    "api/deck": ({text, version}) => ({text, version: `${version}+`, tree: treeOf(["a", "b"]), mistakes: []}),
  };
});

const open = () => new OpenDeck({name: "a.toml", text: "x", version: "1", tree: treeOf(["a", "b"]), mistakes: []}, () => {});

test("several changes are one step of undo", async () => {
  const deck = open();
  assert.ok(await deck.change([{path: ["a"], value: "1"}, {path: ["b"], value: "2"}]));
  assert.deepEqual([deck.text, deck.savedText, requests.length], ["x|1+2", "x|1+2", 2]);
  await deck.step(-1);
  assert.equal(deck.text, "x");
  // What is chosen right after another choice at the same place is a step of its own.
  await deck.change([{path: ["a"], value: "3"}]);
  await deck.change([{path: ["a"], value: "4"}]);
  await deck.step(-1);
  assert.equal(deck.text, "x|3");
});

test("a failed save says why, and is tried again by the next change or on demand alone", async () => {
  const deck = open();
  studio["api/deck"] = () => ({status: 500, error: "the disk is full"});
  await deck.edit(["a"], "1");
  assert.deepEqual([deck.failure, deck.isSaved], ["the disk is full", false]);
  const saves = () => requests.filter(([address]) => address === "api/deck").length;
  assert.equal(saves(), 1);
  await deck.edit(["a"], "2");
  assert.equal(saves(), 2);
  studio["api/deck"] = ({text, version}) => ({text, version, tree: treeOf(["a", "b"]), mistakes: []});
  await deck.save();
  assert.deepEqual([deck.failure, deck.isSaved], [null, true]);
});

test("a refused value is forgotten with the table in which it was", async () => {
  const deck = open();
  const edit = studio["api/edit"];
  studio["api/edit"] = () => ({status: 400, error: "no value of TOML"});
  for (const path of [["a", "x"], ["s", 0, "x"], ["s", 1, "x"], ["t", "x"]]) assert.equal(await deck.edit(path, "]"), null);
  assert.equal(deck.allMistakes.length, 4);
  studio["api/edit"] = (request) => ({...edit(request), tree: treeOf(["a", "b", "s", "t"])});
  studio["api/deck"] = ({text, version}) => ({text, version, tree: treeOf(["a", "b", "s", "t"]), mistakes: []});
  await deck.change([{path: ["a"], value: null}]);
  assert.deepEqual([...deck.refusals.values()].map(({path}) => path[0]), ["t"]);   // the tree has no s.0 and no s.1
  // By the text, too.
  studio["api/deck"] = ({text, version}) => ({text, version, tree: treeOf(["a"]), mistakes: []});
  deck.type("other");
  await deck.save();
  assert.deepEqual(deck.allMistakes, []);
});

test("what was refused in an element of an array is forgotten once the elements have other places", async () => {
  const deck = open();
  const items = {type: "table", entries: [{key: "s", value: {type: "array", items: [treeOf([]), treeOf([])]}}]};
  const edit = studio["api/edit"];
  studio["api/edit"] = () => ({status: 400, error: "no value of TOML"});
  await deck.edit(["s", 1, "x"], "]");
  studio["api/edit"] = (request) => ({...edit(request), tree: items});
  studio["api/deck"] = ({text, version}) => ({text, version, tree: items, mistakes: []});
  await deck.edit(["s", 0, "y"], "1");
  assert.equal(deck.allMistakes.length, 1);
  await deck.change([{path: ["s", 0], exchange: ["s", 1]}]);
  assert.deepEqual(deck.allMistakes, []);
});
