// Light of a uniformly bright ball. Compiles as GLSL and as C++.
// A ball of radius R and luminance L has the luminous intensity I = pi R^2 L in every direction. A surface that faces
// the ball at distance d from its centre has the illuminance E = pi L (R/d)^2 = I / d^2. This is exact, down to the
// ball's surface (Lambert 1760; form factor of a sphere, for instance Howell, "A Catalog of Radiation Heat Transfer
// Configuration Factors", B-38). Inside the ball, E is constant, I / R^2. A surface turned by theta gets E cos theta as
// long as the whole ball is above the surface's horizon.
#include "draw/arithmetic.glsl"

struct Arrival {
  vec3 towards;   // unit vector to the ball's centre
  float perArea;  // illuminance per candela on a surface that faces the ball: 1/d^2 (1/m^2)
  float spread;   // sine of half the angle that the ball subtends
};

// Returns the light of a ball at the point p. `ball` holds the centre (xyz) and the radius (w) in metres. `perRadius2`
// is 1 / radius^2.
FUNCTION Arrival arrivalAt(vec3 p, vec4 ball, float perRadius2) {
  ROUNDED vec3 to = vec3(ball) - p;
  float perDistance = inverseRoot(max(dotted(to, to), 1e-12f));
  ROUNDED vec3 towards = to * perDistance;
  ROUNDED float perArea = perDistance * perDistance;
  ROUNDED float spread = ball.w * perDistance;
  Arrival arrival;  // members are assigned one by one, because C++ before P0960 cannot initialize a struct with
                    // parentheses
  arrival.towards = towards;
  arrival.perArea = min(perArea, perRadius2);
  arrival.spread = min(spread, 1.0f);
  return arrival;
}

// Returns the fraction of light that a spotlight's cone lets through in the direction -towards. The fraction is 1 in
// the middle and 0 beyond the edge; between them it is the square of a linear function of the angle's cosine. `cone` is
// Lamp.cone.
FUNCTION float coneShare(vec3 towards, vec4 cone) {
  ROUNDED float line = cone.w - dotted(towards, vec3(cone));
  float share = clamp(line, 0.0f, 1.0f);
  ROUNDED float squared = share * share;
  return squared;
}

// Returns the GGX alpha of a lobe that is lit by a ball instead of a point. The half vectors spread by half the angle
// of the light, and the variances of the two spreads add up. The widened lobe is still a GGX lobe, so energy is
// preserved.
FUNCTION float widenedAlpha(float alpha, float spread) {
  ROUNDED float square = alpha * alpha + 0.25f * spread * spread;
  return root(square);
}
