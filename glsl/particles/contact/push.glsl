// Correction of the positions of two balls that overlap. Compiles as GLSL and as C++ (the CPU twin of the tests). The
// including file provides particles/contact/model.glsl and collide/model.glsl.

// Returns the displacement of ball a by ball b, and of b by a in the ratio of masses:
//   dx_a = (depth n - held slid) / m_a / (n_a / m_a + n_b / m_b).
// Each ball's mass is shared among its n contacts (mass splitting), so that all pairs together converge. `slid` is the
// tangential part of the relative displacement in the substep. Coulomb friction holds at most the length mu depth of it.
FUNCTION vec3 ballPush(Ball a, Ball b, float perMass, bool first) {
  precise float reach = a.start.w + b.start.w;
  BallOverlap o = ballOverlap(vec3(a.place), vec3(b.place), reach, first);
  precise vec3 way = (vec3(a.place) - vec3(a.start)) - (vec3(b.place) - vec3(b.start));
  float through = exactDot(way, o.normal);
  precise vec3 slid = way - o.normal * through;
  precise float most = stepData.balls.friction * max(o.depth, 0.0f);
  precise float held = 1.0f - leftByFriction(slid, most);
  precise float shares = a.place.w + b.place.w;
  precise float part = perMass * exactReciprocal(shares);
  precise vec3 push = (o.normal * o.depth - slid * held) * part;
  return o.depth > 0.0f ? push : vec3(0.0f);
}
