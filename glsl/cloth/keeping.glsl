// Constraints of undamped cloth as conservative forces. Their purpose is that the energy which a swing loses to flutter
// stays in the sheet instead of vanishing. Compiles as GLSL and as C++, after springForce of cloth/model.glsl.
//
// C = |d| - L0 is the stretch of each link, n the link's direction, and W the inverse masses. A family of constraints
// has the energy
//   V(x) = 1/2 C^T B^-1 C,   B = compliance + softening dt^2 A(x),   A = G W G^T,
// where G are the gradients of C. The forces are the complete negative gradient of V at the start of the substep.
// Semi-implicit Euler is therefore symplectic and conserves an energy close to V plus the kinetic energy. An even
// stretch meets only the compliance, however long the line is. Vibrations that are too fast for the substep become
// softer, so that w dt < 1 / sqrt(softening), where w is their frequency. Structural lines use the full matrix A and
// are solved as in line_model.glsl at the current positions. Shear and bending pairs use only the diagonal of A, with a
// softening of at least 4, because many pairs have a particle in common.
FUNCTION vec3 pairTo(ivec2 at, vec4 here, int dx, int dy, int kind) {
  vec4 there = loadPosition(neighbour(at, dx, dy));
  precise vec3 d = vec3(there) - vec3(here);
  precise float give = scaledCompliance(kind) + (here.w + there.w) * max(stepData.softening, 4.0f);
  precise float stiffness = stepData.perDt * stepData.perDt * exactReciprocal(give);
  return springForce(d, springLength(kind), stiffness);
}

FUNCTION vec3 pairForces(ivec2 at, vec4 here, bool fabric) {
  precise vec3 sum =
      pairTo(at, here, -1, -1, 1) + pairTo(at, here, 1, -1, 1) + pairTo(at, here, -1, 1, 1) + pairTo(at, here, 1, 1, 1);
  if (!fabric)
    sum = sum + pairTo(at, here, -2, 0, 2) + pairTo(at, here, 2, 0, 2) + pairTo(at, here, 0, -2, 2) + pairTo(at, here, 0, 2, 2);
  return sum;
}
