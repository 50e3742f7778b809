// Coefficients of a damped leapfrog step. Compiles as GLSL and as C++, after common/exact.glsl and
// particles/types.glsl.

// Returns the coefficients for a step of t = `seconds` with the damping r = `rate`: x first kick, y drift, z fraction
// of the velocity that remains, w second kick. They are used as
//   u = v + a x,   p' = p + u y,   v' = u z + a' w.
// With z = r t, phi = (1 - e^-z)/z and psi = (1 - phi)/z, the solution of v' = a - r v for constant a is
//   p' = p + v t phi + a t^2 psi,   v' = v e^-z + a t phi,
// so y = t phi, x = t psi/phi, w = t phi - x e^-z. The step is exact for constant a and any t. Without damping, the
// coefficients are t/2, t, 1, t/2.
FUNCTION Pace paceOf(float seconds, float rate) {
  precise float z = seconds * rate;
  // For z < 1, 1 - e^-z cancels, so psi is computed by the series 1/2! + w/3! + w^2/4! + ... with w = -z. The other
  // values follow from psi.
  precise float w = -z;
  precise float near = ((w * 2.5052108e-8f + 2.7557319e-7f) * w + 2.7557319e-6f) * w + 2.4801587e-5f;
  near = ((near * w + 1.9841270e-4f) * w + 1.3888889e-3f) * w + 8.3333333e-3f;
  near = ((near * w + 4.1666667e-2f) * w + 0.16666667f) * w + 0.5f;
  precise float nearPhi = 1.0f - near * z;
  precise float nearKept = 1.0f - nearPhi * z;
  float inverse = exactReciprocal(max(z, 1.0f));
  float farKept = exactExp(w);
  precise float farPhi = (1.0f - farKept) * inverse;
  precise float far = (1.0f - farPhi) * inverse;
  bool small = z < 1.0f;
  precise float kept = small ? nearKept : farKept;
  precise float drift = small ? nearPhi : farPhi;
  precise float first = small ? near : far;
  if (z > 0.0f) first = first * exactReciprocal(drift);
  first = first * seconds;
  drift = drift * seconds;
  precise float second = drift - first * kept;
  Pace pace;
  pace.firstKick = first;
  pace.drift = drift;
  pace.kept = kept;
  pace.secondKick = second;
  return pace;
}
