// How far one step of a damped leapfrog goes. Compiles as GLSL and as C++; common/exact.glsl and particles/types.glsl
// come before it.

// For `seconds` t and a damping of `rate` r: x first kick, y drift, z fraction of velocity kept, w second kick, to be
// used as
//   u = v + a x,  p' = p + u y,  v' = u z + a' w.
// From v' = a - r v with a = const, z = r t, phi = (1 - e^-z)/z and psi = (1 - phi)/z,
//   p' = p + v t phi + a t^2 psi,  v' = v e^-z + a t phi,
// so y = t phi, x = t psi/phi, w = t phi - x e^-z: exact while a stays, whatever t. Without damping t/2, t, 1, t/2.
FUNCTION Pace paceOf(float seconds, float rate) {
  precise float z = seconds * rate;
  // Below 1, where 1 - e^-z cancels: psi = 1/2! + w/3! + w^2/4! + ..., w = -z, and the others from it.
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
