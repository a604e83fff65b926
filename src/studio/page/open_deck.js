/// The deck that is open: its text, the tree that the server reads in it, and its version on the disk. The form and the
/// text beside it change it through here, one change after the other; each is saved at once.

import * as api from "./api.js";
import {nodeAt} from "./deck_tree.js";
import {TextsHistory} from "./texts_history.js";

export class OpenDeck {
  /// `deck` is a DECK of the server. `changed(what, path)` is called after each change, with "text", "made" (with the
  /// path of the change), "tree", "saved", "conflict", "refused" or "unsaved".
  constructor(deck, changed) {
    this.name = deck.name;
    this.changed = changed;
    this.text = deck.text;
    this.version = deck.version;
    this.savedText = deck.text;
    this.tree = deck.tree;
    this.isToml = deck.tree !== null;   // whether the tree is that of the text, not of an earlier one
    this.mistakes = deck.mistakes;
    this.refusals = new Map();      // what the server says of changes that it could not make, by path as JSON
    this.pending = new Map();       // numbers of changes on their way to the server, by path as JSON
    this.unsent = new Map();        // changes that no server has taken, by path as JSON
    this.conflict = null;
    this.failure = null;            // why the text could not be saved; it is tried again after the next change alone
    this.history = new TextsHistory(deck.text);
    this.work = Promise.resolve();
    this.timer = 0;
  }

  get isSaved() {
    return this.text === this.savedText && this.unsent.size === 0;
  }

  /// Replaces the value at a path by a source of TOML; null removes it. What is typed in one place within a few seconds
  /// is one step of undo. Resolves to the answer of the server, or to null if it was refused.
  edit(path, value) {
    return this.#queue({path, changes: [{path, value}], step: JSON.stringify(path)});
  }

  /// Makes several changes (docs/studio.md) as one step of undo. What the server says against them is shown at `path`.
  change(changes, path = changes[0].path) {
    return this.#queue({path, changes, step: null});
  }

  #queue(wanted) {
    const place = JSON.stringify(wanted.path);
    const count = (by) => this.pending.set(place, (this.pending.get(place) ?? 0) + by);
    count(1);
    const done = this.work.then(() => this.#make(wanted)).finally(() => count(-1));
    this.work = done.catch(() => {});
    return done;
  }

  /// Whether a field shows what was typed into it, not what the deck has: it is on its way, or was refused.
  keepsTyped(path) {
    const place = JSON.stringify(path);
    return this.pending.get(place) > 0 || this.refusals.has(place);
  }

  async #make(wanted) {
    const {path, changes} = wanted;
    const place = JSON.stringify(path);
    try {
      let [answer, sent] = [null, null];
      // What is typed into the text meanwhile is not overwritten: the changes are made in the later text, too.
      while (this.text !== sent) {
        sent = this.text;
        answer = await api.editDeck({text: sent, name: this.name, changes});
      }
      this.unsent.delete(place);
      if (answer.tree === null) throw new Error(answer.mistakes[0]?.message ?? "this is no value of TOML");
      this.refusals.delete(place);
      changes.forEach((one) => this.#forgetWithin(one));
      this.#take(answer, wanted);
      await this.#save();
      return answer;
    } catch (error) {
      if (error instanceof api.Ended) this.unsent.set(place, wanted);
      this.refusals.set(place, {path, line: 0, message: error.message});
      this.changed("refused");
      return null;
    }
  }

  /// Forgets what was refused within a value that a change has replaced, removed, renamed or moved; in an array also
  /// what was refused in the other elements, whose indices may have changed.
  #forgetWithin({path, value = null}) {
    const isElement = typeof path.at(-1) === "number" && value === null;
    const around = isElement ? path.slice(0, -1) : path;
    for (const known of [this.refusals, this.unsent]) {
      for (const [place, {path: refused}] of known) {
        if (refused.length > around.length && around.every((part, i) => part === refused[i])) known.delete(place);
      }
    }
  }

  /// Forgets what was refused in tables that are not there any more.
  #forgetMissing() {
    for (const [place, {path}] of this.refusals) {
      if (path.length > 1 && nodeAt(this.tree, path.slice(0, -1)) === undefined) this.refusals.delete(place);
    }
  }

  #take({text, tree, mistakes}, {path, step}) {
    this.text = text;
    this.tree = tree;
    this.isToml = true;
    this.mistakes = mistakes;
    this.#forgetMissing();
    this.history.add(text, step);
    this.changed("text");
    this.changed("made", path);
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
    for (const wanted of this.unsent.values()) this.#queue(wanted);
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
        // Without a server the whole page says so, and saves once there is one again.
        this.failure = error instanceof api.Ended ? null : error.message;
        this.changed("unsaved");
      }
    }
  }

  #saved(deck) {
    this.version = deck.version;
    this.savedText = deck.text;
    this.failure = null;
    if (deck.text === this.text) {
      this.tree = deck.tree ?? this.tree;
      this.isToml = deck.tree !== null;
      this.mistakes = deck.mistakes;
      this.#forgetMissing();
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
