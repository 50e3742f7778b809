// Constraints of cloth that nothing damps, as forces of a potential, so that what a swing loses to flutter stays in the sheet.
// Compiles as GLSL and as C++, after springForce of cloth/model.glsl.
//
// With the stretch C = |d| - L0 of each link, its direction n, and W the inverse masses, a family of constraints has the energy
//   V(x) = 1/2 C^T B^-1 C,   B = compliance + softening dt^2 A(x),   A = G W G^T of the links' gradients G,
// and the forces are all of its gradient at the substep's beginning: semi-implicit Euler then is symplectic, so there is an
// energy near this one that it keeps. What is stretched evenly has its compliance, however long the line is; what would vibrate
// faster than substeps follow is softer, by w dt < 1 / sqrt(softening). Lines have the whole of A and are solved as
// line_model.glsl has it, of where they are; pairs its diagonal, at least four times, since many of them meet at a particle.
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
