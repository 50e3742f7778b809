// Velocities with which balls leave their contacts. Compiles as GLSL and as C++ (the CPU twin of the tests). The including
// file provides `stepData` (ParticleStep), common/exact.glsl and particles/contact/model.glsl.

// Motion of a ball before and after the corrections.
struct BallMotion {
  vec3 guess;     // Position before the corrections, m
  vec3 velocity;  // Velocity before the corrections, m/s
  vec4 place;     // Corrected position, as in Ball
  vec3 after;     // Velocity after the corrections, m/s
};

// Returns the motion of a ball with the velocity that the corrections imply, v + (x - guess) / dt.
FUNCTION BallMotion ballMotion(vec3 guess, vec3 velocity, vec4 place) {
  precise vec3 after = velocity + (vec3(place) - guess) * stepData.balls.perDt;
  BallMotion m;
  m.guess = guess;
  m.velocity = velocity;
  m.place = place;
  m.after = after;
  return m;
}

// Velocity of a ball while its contacts are visited.
struct BallLeaving {
  vec3 velocity;  // in m/s
  float fastest;  // Greatest speed of approach in a contact before the corrections, m/s; not negative
  bool touches;   // True if the ball has a contact
};

FUNCTION BallLeaving ballLeaving(BallMotion a) {
  BallLeaving leaving;
  leaving.velocity = a.after;
  leaving.fastest = 0.0f;
  leaving.touches = false;
  return leaving;
}

// Adds the contact of ball a with ball b. A pair that overlapped before the corrections leaves with the fraction e of its
// approach speed, or with 0 if it approached slower than `bounceFrom`. The correction of an overlap leaves no velocity
// behind: a pair that separates faster is slowed down, by at most the speed of the correction. `i` and
// `j` are the indices of the balls.
FUNCTION BallLeaving ballBounce(BallLeaving leaving, BallMotion a, BallMotion b, float reach, float perMass, int i, int j) {
  if (!ballsMayOverlap(a.guess, b.guess, reach)) return leaving;
  BallOverlap before = ballOverlap(a.guess, b.guess, reach, i, j);
  BallOverlap now = ballOverlap(vec3(a.place), vec3(b.place), reach, i, j);
  precise vec3 relative = a.velocity - b.velocity;
  precise vec3 left = a.after - b.after;
  float approach = exactDot(relative, now.normal);
  float leaves = exactDot(left, now.normal);
  precise float returned = approach * -stepData.balls.restitution;
  float wanted = approach < -stepData.balls.bounceFrom ? returned : max(approach, 0.0f);
  precise float slowest = before.depth * -stepData.balls.perDt;
  precise float difference = wanted - leaves;
  float change = max(difference, slowest);
  precise float shares = a.place.w + b.place.w;
  precise float part = perMass * exactReciprocal(shares);
  precise vec3 velocity = leaving.velocity + now.normal * (change * part);
  if (before.depth > 0.0f) {
    leaving.velocity = velocity;
    leaving.fastest = max(leaving.fastest, -approach);
    leaving.touches = true;
  }
  return leaving;
}

// Returns the velocity after all contacts. The corrections change the velocity of a ball that touches another by at most
// its fastest approach and twice the speed that the uniform acceleration adds in a substep. So balls that overlap for
// another reason, as when they were placed inside each other, are not thrown apart.
FUNCTION vec3 ballLeft(BallLeaving leaving, BallMotion a) {
  precise vec3 change = leaving.velocity - a.velocity;
  precise float maximum = stepData.balls.restSpeed * 2.0f + leaving.fastest;
  precise float squaredMost = maximum * maximum;
  float squared = exactDot(change, change);
  precise vec3 limited = change * (maximum * exactInverseSqrt(max(squared, 1e-20f))) + a.velocity;
  return leaving.touches && squared > squaredMost ? limited : leaving.velocity;
}

// True if a ball in contact stays where it was. Friction without memory lets a heap creep, by less than the speed that
// the uniform acceleration adds in a substep. Below that speed the place is kept and the velocity decays (ballIdle); a
// force that is not balanced soon exceeds it.
FUNCTION bool ballRests(vec3 start, vec3 place, vec3 velocity) {
  precise vec3 way = (place - start) * stepData.balls.perDt;
  precise float maximum = stepData.balls.restSpeed * stepData.balls.restSpeed;
  return exactDot(way, way) < maximum && exactDot(velocity, velocity) < maximum;
}
FUNCTION vec3 ballIdle(vec3 velocity) {
  precise vec3 slower = velocity * 0.9f;
  return slower;
}

// Returns the angular velocity (rad/s) of a ball of the radius `radius` that has turned by the angle `roll` / radius in the
// substep.
FUNCTION vec3 ballSpin(vec3 roll, float radius) {
  precise vec3 spin = roll * (stepData.balls.perDt * exactReciprocal(max(radius, 1e-20f)));
  return spin;
}

// Returns the orientation (unit quaternion x, y, z, w) after a substep with the angular velocity `spin`, in rad/s.
FUNCTION vec4 ballTurned(vec4 turn, vec3 spin) {
  float squared = exactDot(spin, spin);
  if (squared < 1e-12f) return turn;
  float perSpeed = exactInverseSqrt(squared);
  precise float half_ = squared * perSpeed * stepData.dt * 0.5f;
  half_ = min(half_, 1e3f);
  precise vec3 axis = spin * (perSpeed * exactSin(half_));
  float cosine = exactCos(half_);
  vec3 before = vec3(turn);
  precise vec3 v = before * cosine + axis * turn.w + exactCross(axis, before);
  precise float w = turn.w * cosine - exactDot(axis, before);
  vec4 after = vec4(v, w);
  precise vec4 unit_ = after * exactInverseSqrt(max(exactDot(after, after), 1e-20f));
  return unit_;
}
