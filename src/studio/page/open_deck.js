/// The deck that is open: its text, the tree that the server reads in it, and its version on the disk. The form and the
/// text beside it change it through here, one change after the other; each is saved at once.

import * as api from "./api.js";
import {TextsHistory} from "./texts_history.js";

export class OpenDeck {
  /// `deck` is a DECK of the server. `changed(what)` is called after each change, with "text", "tree", "saved",
  /// "conflict", "refused" or "unsaved".
  constructor(deck, changed) {
    this.name = deck.name;
    this.changed = changed;
    this.text = deck.text;
    this.version = deck.version;
    this.savedText = deck.text;
    this.tree = deck.tree;
    this.isToml = deck.tree !== null;   // whether the tree is that of the text, not of an earlier one
    this.mistakes = deck.mistakes;
    this.refusals = new Map();      // what the server says of values that it could not write, by path as JSON
    this.pending = new Map();       // numbers of changes on their way to the server, by path as JSON
    this.unsent = new Map();        // changes that no server has taken, by path as JSON: [path, value]
    this.conflict = null;
    this.history = new TextsHistory(deck.text);
    this.work = Promise.resolve();
    this.timer = 0;
  }

  get isSaved() {
    return this.text === this.savedText && this.unsent.size === 0;
  }

  /// Replaces the value at a path by a source of TOML; null removes it. Resolves to whether it was done.
  edit(path, value) {
    const place = JSON.stringify(path);
    const count = (by) => this.pending.set(place, (this.pending.get(place) ?? 0) + by);
    count(1);
    const done = this.work.then(() => this.#edit(path, value)).finally(() => count(-1));
    this.work = done.catch(() => {});
    return done;
  }

  /// Whether a field shows what was typed into it, not what the deck has: it is on its way, or was refused.
  keepsTyped(path) {
    const place = JSON.stringify(path);
    return this.pending.get(place) > 0 || this.refusals.has(place);
  }

  async #edit(path, value) {
    const place = JSON.stringify(path);
    try {
      let [answer, sent] = [null, null];
      // What is typed into the text meanwhile is not overwritten: the change is made in the later text, too.
      while (this.text !== sent) {
        sent = this.text;
        answer = await api.editDeck({text: sent, path, value});
      }
      this.unsent.delete(place);
      if (answer.tree === null) throw new Error(answer.mistakes[0]?.message ?? "this is no value of TOML");
      this.refusals.delete(place);
      this.#take(answer, place);
      await this.#save();
      return true;
    } catch (error) {
      if (error instanceof api.Ended) this.unsent.set(place, [path, value]);
      this.refusals.set(place, {line: 0, message: error.message});
      this.changed("refused");
      return false;
    }
  }

  #take({text, tree, mistakes}, place) {
    this.text = text;
    this.tree = tree;
    this.isToml = true;
    this.mistakes = mistakes;
    this.history.add(text, place);
    this.changed("text");
    this.changed("tree");
  }

  /// Takes a text as it is typed. It is saved, and its tree read, after a pause.
  type(text, pause = 600) {
    if (text === this.text) return;
    this.text = text;
    this.history.add(text, "text");
    this.changed("text");
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.save(), pause);
  }

  /// Goes to the earlier (-1) or the later (1) text.
  step(by) {
    this.work = this.work.then(() => {
      this.text = this.history.step(by);
      this.refusals.clear();
      this.unsent.clear();
      this.changed("text");
      return this.#save();
    }).catch(() => {});
    return this.work;
  }

  /// Saves what is not yet saved, and sends changes again that no server has taken.
  save() {
    clearTimeout(this.timer);
    for (const [path, value] of this.unsent.values()) this.edit(path, value);
    this.work = this.work.then(() => this.#save()).catch(() => {});
    return this.work;
  }

  async #save() {
    if (this.conflict !== null || this.text === this.savedText) return;
    const text = this.text;
    try {
      this.#saved(await api.saveDeck({name: this.name, text, version: this.version}));
    } catch (error) {
      if (error.status === 409) {
        this.conflict = {message: error.message, version: error.answer.version};
        this.changed("conflict");
      } else {
        this.changed("unsaved");
      }
    }
  }

  #saved(deck) {
    this.version = deck.version;
    this.savedText = deck.text;
    if (deck.text === this.text) {
      this.tree = deck.tree ?? this.tree;
      this.isToml = deck.tree !== null;
      this.mistakes = deck.mistakes;
      this.changed("tree");
    }
    this.changed("saved");
  }

  /// After a conflict: keeps the text of the page, which then replaces that on the disk.
  keepMine() {
    this.version = this.conflict.version;
    this.conflict = null;
    this.savedText = null;
    return this.save();
  }

  /// After a conflict: takes the text that is on the disk. The one of the page is a step back.
  async takeTheirs() {
    const deck = await api.getDeck(this.name);
    this.conflict = null;
    this.text = deck.text;
    this.history.add(deck.text, null);
    this.changed("text");
    this.#saved(deck);
  }

  /// The mistakes to show: those of the deck, and those of values that the server could not write.
  get allMistakes() {
    return [...this.mistakes, ...this.refusals.values()];
  }
}
