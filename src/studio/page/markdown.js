/// The parts of a Markdown document that the reference of keys is made of: headings, paragraphs and tables.

/// The blocks of a document in their order: {kind: "heading", text}, {kind: "paragraph", text} or
/// {kind: "table", heads, rows} with the cells as Markdown. Blocks of code are left out.
export function blocksOf(document) {
  const blocks = [];
  let isCode = false;
  for (const line of [...document.split("\n"), ""]) {
    const last = blocks.at(-1);
    if (line.startsWith("```")) isCode = !isCode;
    else if (isCode) continue;
    else if (line.startsWith("#")) blocks.push({kind: "heading", text: plain(line.replace(/^#+\s*/, ""))});
    else if (line.startsWith("|") && last?.kind === "table") last.rows.push(cellsOf(line));
    else if (line.startsWith("|")) blocks.push({kind: "table", heads: cellsOf(line), rows: []});
    else if (line.trim() === "") blocks.push({kind: "end"});
    else if (last?.kind === "paragraph") last.text += ` ${line.trim()}`;
    else blocks.push({kind: "paragraph", text: line.trim()});
  }
  // The line below the heads of a table has dashes alone.
  for (const block of blocks) {
    if (block.kind === "table") block.rows = block.rows.filter((row) => !row.every((cell) => /^:?-+:?$/.test(cell)));
  }
  return blocks.filter(({kind}) => kind !== "end");
}

/// The cells of a line of a table; a `\|` is a sign of its cell.
function cellsOf(line) {
  const cells = line.trim().replace(/^\||\|$/g, "").split(/(?<!\\)\|/);
  return cells.map((cell) => cell.replaceAll("\\|", "|").trim());
}

/// Markdown as plain text: links, emphasis and backticks become their words.
export function plain(markdown) {
  return markdown.replace(/!?\[([^\]]*)\]\([^)]*\)/g, "$1").replace(/\*\*([^*]+)\*\*/g, "$1")
    .replace(/(?<![\w*])\*([^*\s][^*]*)\*(?![\w*])/g, "$1").replaceAll("`", "").replace(/\\([*_|])/g, "$1").trim();
}

/// The first sentence of a plain text, without what follows in it behind a colon or semicolon if that is long.
export function firstSentence(text) {
  const end = /[.](?=\s+[A-Z"`{])/.exec(text.replace(/\b(e\.g|i\.e|al|Eq|Eqs)\./g, (short) => short.replaceAll(".", "_")));
  const sentence = end === null ? text : text.slice(0, end.index + 1);
  if (sentence.length <= 130) return sentence;
  const part = /[:;](?=\s)/.exec(sentence);
  const shorter = part !== null && part.index > 12 ? sentence.slice(0, part.index) : sentence;
  if (shorter.length <= 150) return shorter;
  return `${shorter.slice(0, 130).replace(/\s+\S*$/, "")} …`;
}

/// The pieces of code in a Markdown text, without their backticks.
export function codesIn(markdown) {
  return [...markdown.matchAll(/`([^`]+)`/g)].map(([, code]) => code);
}
