// How far one step of a damped leapfrog goes. Compiles as GLSL and as C++; common/exact.glsl comes before it.

// For `seconds` t and a damping of `rate` r: x first kick, y drift, z share of velocity kept, w second kick, to be used as
//   u = v + a x,  p' = p + u y,  v' = u z + a' w.
// From v' = a - r v with a = const, z = r t, phi = (1 - e^-z)/z and psi = (1 - phi)/z,
//   p' = p + v t phi + a t^2 psi,  v' = v e^-z + a t phi,
// so y = t phi, x = t psi/phi, w = t phi - x e^-z: exact while a stays, whatever t. Without damping t/2, t, 1, t/2.
FUNCTION vec4 paceOf(float seconds, float rate) {
  precise float z = seconds * rate;
  // Below 1, where 1 - e^-z cancels: psi = 1/2! + w/3! + w^2/4! + ..., w = -z, and the others from it.
  precise float near = z * -2.5052108e-8f;
  near = near + 2.7557319e-7f;
  near = near * -z;
  near = near + 2.7557319e-6f;
  near = near * -z;
  near = near + 2.4801587e-5f;
  near = near * -z;
  near = near + 1.9841270e-4f;
  near = near * -z;
  near = near + 1.3888889e-3f;
  near = near * -z;
  near = near + 8.3333333e-3f;
  near = near * -z;
  near = near + 4.1666667e-2f;
  near = near * -z;
  near = near + 0.16666667f;
  near = near * -z;
  near = near + 0.5f;
  precise float nearPhi = near * z;
  nearPhi = 1.0f - nearPhi;
  precise float nearKept = nearPhi * z;
  nearKept = 1.0f - nearKept;
  float inverse = exactReciprocal(max(z, 1.0f));
  float farKept = exactExp(-z);
  precise float farPhi = 1.0f - farKept;
  farPhi = farPhi * inverse;
  precise float far = 1.0f - farPhi;
  far = far * inverse;
  bool small = z < 1.0f;
  precise float kept = small ? nearKept : farKept;
  precise float drift = small ? nearPhi : farPhi;
  precise float first = small ? near : far;
  if (z > 0.0f) first = first * exactReciprocal(drift);
  first = first * seconds;
  drift = drift * seconds;
  precise float second = first * kept;
  second = drift - second;
  return vec4(first, drift, kept, second);
}
