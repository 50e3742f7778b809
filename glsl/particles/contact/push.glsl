// Correction of the positions of two balls that overlap. Compiles as GLSL and as C++ (the CPU twin of the tests). The
// including file provides particles/contact/model.glsl and collide/model.glsl.

// Displacement of a ball by another, and the angle that it turns times its radius, m.
struct BallPush {
  vec3 way;
  vec3 roll;
};

// Returns the displacement of ball a by ball b. The displacements of a and b are in the inverse ratio of their masses:
// dx_a = (depth n - held slid) / m_a / (n_a / m_a + n_b / m_b).
// n is the normal, m_a and m_b are the masses, and n_a and n_b are the factors of ballShare() by which contacts share a
// mass (mass splitting), so that all pairs together converge. `i` and `j` are the indices of the balls. `slid` is the
// tangential part of the relative displacement in the substep. Coulomb friction undoes the fraction `held` of it, at
// most the length mu depth. `rolls` is the sum of the angles that both have turned, times their radii.
FUNCTION BallPush ballPush(Ball a, Ball b, float perMass, int i, int j, vec3 rolls) {
  BallPush none;
  none.way = vec3(0.0f);
  none.roll = vec3(0.0f);
  precise float reach = a.start.w + b.start.w;
  if (!ballsMayOverlap(vec3(a.place), vec3(b.place), reach)) return none;
  BallOverlap o = ballOverlap(vec3(a.place), vec3(b.place), reach, i, j);
  precise vec3 way = (vec3(a.place) - vec3(a.start)) - (vec3(b.place) - vec3(b.start));
  float through = exactDot(way, o.normal);
  precise vec3 slid = way - o.normal * through;
#ifdef ROLLS
  if (stepData.balls.rolls != 0) slid = rollingSlip(slid, rolls, o.normal);
#endif
  precise float maximum = stepData.balls.friction * max(o.depth, 0.0f);
  precise float held = 1.0f - leftByFriction(slid, maximum);
  precise float shares = a.place.w + b.place.w;
  precise float part = perMass * exactReciprocal(shares);
  precise vec3 push = (o.normal * o.depth - slid * held) * part;
  if (o.depth <= 0.0f) return none;
  BallPush pushed;
  pushed.way = push;
  pushed.roll = none.roll;
#ifdef ROLLS
  precise vec3 undone = slid * held * part;
  if (stepData.balls.rolls != 0) pushed.roll = rolledBy(none.roll, o.normal, undone);
#endif
  return pushed;
}

// Returns the displacement of a ball by all its neighbours. It is at most the radius, so that no push takes the ball's
// centre through the surface of a solid.
FUNCTION vec3 ballPushes(vec3 sum, float radius) {
  float squared = exactDot(sum, sum);
  precise float maximum = radius * radius;
  precise vec3 limited = sum * (radius * exactInverseSqrt(max(squared, 1e-20f)));
  return squared > maximum ? limited : sum;
}
