/// The colours of figures: they follow the reader's light or dark scheme, and are light on paper.

const printing = {now: false};

export function isDark() {
  return !printing.now && matchMedia("(prefers-color-scheme: dark)").matches;
}

/// Whether figures are drawn for paper.
export function isPrinting() {
  return printing.now;
}

/// Switches to the colours of paper, or back to those of the screen. Figures must be drawn anew.
export function setPrinting(now) {
  printing.now = now;
}

const inks = {
  light: {paper: "#ffffff", ink: "#1c2226", faint: "#5b666d", line: "#e2e6e8"},
  dark: {paper: "#14191c", ink: "#e4e9ec", faint: "#9aa7ae", line: "#2b3439"},
};

/// Colours of the background, of text and measured curves, of secondary text, and of grid lines.
export function currentInks() {
  return isDark() ? inks.dark : inks.light;
}
