/// Warnings of a study. Equal warnings of several stages are grouped.

import {listed} from "./names.js";

/// The text that all warnings of one kind have: without numbers, their units and the name of the stage.
function kindOf(text) {
  return text.replace(/[−-]?\d[\d.,]*(e[+-]?\d+)?( ?([fpnumkMGT]|µ)?(m|s|Pa)\b)?/g, "#").replace(/\bcells\b/g, "cell");
}

/// Groups warnings, in their order: [{stages, texts}]. A warning that begins with the name of a stage and a colon is
/// one on that stage; `stages` of a group are the names, and `texts` the whole warnings.
export function groupsOfWarnings(warnings, stageNames) {
  const groups = new Map();
  for (const warning of warnings) {
    const stage = stageNames.find((name) => warning.startsWith(`${name}: `));
    const text = stage === undefined ? warning : warning.slice(stage.length + 2);
    const kind = `${stage === undefined} ${kindOf(text)}`;
    if (!groups.has(kind)) groups.set(kind, {stages: [], texts: []});
    const group = groups.get(kind);
    if (stage !== undefined) group.stages.push(stage);
    group.texts.push(warning);
  }
  return [...groups.values()];
}

/// A line on a group of warnings: the first two clauses of the first warning without text in brackets (the finding and
/// its effect on the result), with its stage and the other stages that have a warning of this kind.
export function lineOnGroup({stages, texts}) {
  const [stage, ...others] = [...new Set(stages)];
  const whole = stage === undefined ? texts[0] : texts[0].slice(stage.length + 2);
  const clauses = whole.replace(/ \([^()]*\)/g, "").split("; ").slice(0, 2).join("; ");
  if (stage === undefined) return clauses;
  const isSame = texts.every((text, i) => text.slice(stages[i].length + 2) === whole);
  if (others.length === 0) return `Stage ${stage}: ${clauses}`;
  if (isSame) return `Stages ${listed([stage, ...others])}: ${clauses}`;
  return `Stage ${stage}: ${clauses}. Likewise ${listed(others)}.`;
}
