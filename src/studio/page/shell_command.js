/// Commands as a user types them in a shell.

/// A word of a command, in quotes where a shell would take it apart.
export function word(text) {
  return /^[\w@%+=:,./-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`;
}

/// A command from its words.
export function command(...words) {
  return words.map(word).join(" ");
}

/// What a change of one value in the form is in a shell: `breccia run DECK --set PATH=VALUE`, which leaves the deck as
/// it is; without a value the key is removed.
export function overrideCommand(deck, path, source) {
  return command("breccia", "run", deck, "--set", `${path}=${source ?? ""}`);
}

/// `breccia fit` with the options of the studio.
export function fitCommand(file, {modulus = "", reference_temperature: reference = "", columns = []} = {}) {
  return command("breccia", "fit", file, ...modulus === "" ? [] : ["--modulus", modulus],
    ...reference === "" ? [] : ["--reference-temperature", reference],
    ...columns.flatMap((column) => ["--columns", column]));
}

/// `breccia run` of a deck with a number of packings.
export function runCommand(deck, seeds) {
  return command("breccia", "run", deck, "--resume", ...seeds > 1 ? ["--seeds", String(seeds)] : []);
}
