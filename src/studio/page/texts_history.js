/// The earlier and later texts of a deck, for undo and redo. Changes of one place that follow each other within a few
/// seconds, as while a number is typed, are one step.

const pause = 2500;

export class TextsHistory {
  constructor(text) {
    this.texts = [text];
    this.at = 0;
    this.place = null;
    this.time = 0;
  }

  /// Adds the text after a change at a place, which is any value that distinguishes places.
  add(text, place, time = Date.now()) {
    if (text === this.texts[this.at]) return;
    const isSameStep = place !== null && place === this.place && time - this.time < pause && this.at > 0
      && this.at === this.texts.length - 1;
    this.texts.length = this.at + 1;
    if (isSameStep) this.texts[this.at] = text;
    else this.texts.push(text);
    this.at = this.texts.length - 1;
    [this.place, this.time] = [place, time];
  }

  get canUndo() {
    return this.at > 0;
  }

  get canRedo() {
    return this.at < this.texts.length - 1;
  }

  /// The text one step earlier (-1) or later (1).
  step(by) {
    this.at = Math.min(Math.max(this.at + by, 0), this.texts.length - 1);
    this.place = null;
    return this.texts[this.at];
  }
}
