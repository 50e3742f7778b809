// Impacts of two balls. Compiles as GLSL and as C++ (the CPU twin of the tests). The including file provides `stepData`
// (ParticleStep), common/exact.glsl and collide/friction.glsl.

// Straight path of a ball in a substep.
struct BallPath {
  vec3 end;       // Position at the end of the substep, m
  vec3 velocity;  // in m/s
};

FUNCTION BallPath ballPath(vec4 end, vec4 velocity) {
  BallPath path;
  path.end = vec3(end);
  path.velocity = vec3(velocity);
  return path;
}

// Impact of ball a on ball b.
struct BallImpact {
  float time;     // Seconds after the start of the substep; negative if there is none
  float speed;    // Speed of approach, m/s
  vec3 normal;    // Unit vector from b to a
  vec3 relative;  // Velocity of a relative to b, m/s
};

// Returns the first impact of two balls on their paths. Balls that overlap at the start and approach meet at once. An
// approach that is slower than `bounceFrom`, or slower than a ten-thousandth of the relative speed, is no impact: those
// pairs are left to the correction of positions.
FUNCTION BallImpact ballImpact(BallPath a, BallPath b, float reach) {
  BallImpact hit;
  precise vec3 relative = a.velocity - b.velocity;
  float squaredSpeed = exactDot(relative, relative);
  hit.time = -1.0f;
  hit.speed = 0.0f;
  hit.normal = vec3(0.0f);
  hit.relative = relative;
  // The approach is not faster than the relative velocity, so most pairs of a heap need no root.
  precise float fewest = stepData.balls.bounceFrom * stepData.balls.bounceFrom * 0.999f;
  if (squaredSpeed < fewest) return hit;
  precise vec3 apart = (a.end - b.end) - relative * stepData.dt;
  float along = exactDot(apart, relative);
  if (along >= 0.0f) return hit;
  precise float beyond = exactDot(apart, apart) - reach * reach;
  precise float discriminant = along * along - squaredSpeed * beyond;
  if (discriminant < 0.0f) return hit;
  precise float divisor = exactSqrt(discriminant) - along;
  precise float meets = beyond * exactReciprocal(max(divisor, 1e-20f));
  hit.time = max(meets, 0.0f);
  precise vec3 there = relative * hit.time + apart;
  precise vec3 normal = there * exactInverseSqrt(max(exactDot(there, there), 1e-20f));
  hit.normal = normal;
  hit.speed = -exactDot(relative, normal);
  precise float squaredApproach = hit.speed * hit.speed;
  precise float minimum = squaredSpeed * 1e-8f;
  bool fast = hit.speed > stepData.balls.bounceFrom && squaredApproach > minimum;
  bool met = hit.time <= stepData.dt && fast;
  hit.time = met ? hit.time : -1.0f;
  return hit;
}

// Returns a number for a pair of balls that decides between impacts of the same time and speed.
FUNCTION uint ballTie(int a, int b) {
  return uint(min(a, b)) * 0x9e3779b1u ^ uint(max(a, b)) * 0x85ebca6bu;
}

// Returns true if the impact `a` happens before `b`, or at the same time and faster. `tieA`, `tieB`: ballTie() of the
// pairs.
FUNCTION bool ballSooner(BallImpact a, BallImpact b, uint tieA, uint tieB) {
  if (b.time < 0.0f) return a.time >= 0.0f;
  if (a.time != b.time) return a.time >= 0.0f && a.time < b.time;
  if (a.speed != b.speed) return a.speed > b.speed;
  return tieA < tieB;
}

// Path of a ball after an impact, and its angular velocity times its radius.
struct BallStruck {
  BallPath path;
  vec3 spin;
};

// Returns ball a after the impact. The pair leaves with the fraction e of its speed of approach. Friction removes
// sliding speed of the contact point, at most mu times the change along the normal (Coulomb). `spinA` and `spinB` are the
// angular velocities times the radii.
FUNCTION BallStruck ballStruck(BallPath a, BallImpact hit, float perMassA, float perMassB, vec3 spinA, vec3 spinB) {
  precise float along = (1.0f + stepData.balls.restitution) * hit.speed;
  precise vec3 sliding = hit.relative + hit.normal * hit.speed;
#ifdef ROLLS
  precise vec3 spins = spinA + spinB;
  if (stepData.balls.rolls != 0) sliding = rollingSlip(sliding, spins, hit.normal);
#endif
  precise float maximum = stepData.balls.friction * along;
  precise float held = 1.0f - leftByFriction(sliding, maximum);
  precise float perMasses = perMassA + perMassB;
  precise float part = perMassA * exactReciprocal(perMasses);
  precise vec3 change = (hit.normal * along - sliding * held) * part;
  precise float remains = stepData.dt - hit.time;
  precise vec3 end = a.end + change * remains;
  precise vec3 velocity = a.velocity + change;
  BallStruck after;
  after.path.end = end;
  after.path.velocity = velocity;
  after.spin = spinA;
#ifdef ROLLS
  precise vec3 rubbed = sliding * held * part;
  if (stepData.balls.rolls != 0) after.spin = rolledBy(spinA, hit.normal, rubbed);
#endif
  return after;
}
