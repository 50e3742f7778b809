// Friction of balls that turn. Compiles as GLSL and as C++. Needs common/exact.glsl. A solid ball has the moment of
// inertia 2/5 m R^2. A tangential impulse J at the contact with the normal n (towards the ball) changes its velocity by
// J / m and its angular velocity times R by -5/2 n x J / m, so that the contact point changes its velocity by 7/2 J / m.

// Returns the change of the ball's velocity that ends the sliding of its contact point. `sliding` is the tangential
// velocity (or way) of the ball's centre, and `spin` its angular velocity (or angle) times the radius. For two balls,
// `sliding` is relative to the other ball, and `spin` is the sum of both.
FUNCTION vec3 rollingSlip(vec3 sliding, vec3 spin, vec3 normal) {
  precise vec3 slip = (sliding - exactCross(spin, normal)) * 0.2857143f;  // 2/7
  return slip;
}

// Returns the angular velocity (or angle) times the radius after friction has removed `rubbed` from the velocity (or
// way) of the centre.
FUNCTION vec3 rolledBy(vec3 spin, vec3 normal, vec3 rubbed) {
  precise vec3 after = spin + exactCross(normal, rubbed) * 2.5f;
  return after;
}
