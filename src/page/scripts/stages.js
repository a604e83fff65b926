/// The chains of the stages of a study.

/// The stages that are not the matrix of another one: the final results of the study.
export function stagesOfInterest(study) {
  const isMatrix = (stage) => study.stages.some((other) => other.matrix === stage.name);
  return study.stages.filter((stage) => !isMatrix(stage));
}

/// The stage that is the matrix of a stage; undefined where that is a material.
export function matrixStageOf(study, stage) {
  return study.stages.find((other) => other.name === stage.matrix);
}

/// The material at the end of a chain of matrices: the binder of a stage.
export function binderOf(study, stageName) {
  let stage = study.stages.find((one) => one.name === stageName);
  for (let links = 0; links < study.stages.length; ++links) stage = matrixStageOf(study, stage) ?? stage;
  return study.materials.find((material) => material.name === stage.matrix);
}
