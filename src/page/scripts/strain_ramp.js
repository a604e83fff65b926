/// Share of the load, 0 to 1, that a dynamic run has applied at a time [s], counted from the middle of its ramp; `ramp`
/// is the duration of the ramp [s]. The raised cosine of docs/theory.md, Eq. 13, as in the class StrainRamp.
export function shareOfLoad(time, ramp) {
  if (time >= ramp / 2) return 1;
  if (time <= -ramp / 2) return 0;
  const x = time / ramp;
  return 0.5 + x + Math.sin(2 * Math.PI * x) / (2 * Math.PI);
}
