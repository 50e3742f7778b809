// Light of an evenly shining ball, as functions of values alone. Compiles as GLSL and as C++.
//
// A ball of radius R and luminance L has the luminous intensity I = pi R^2 L in every direction, and what faces it at
// the distance d from its middle has the illuminance E = pi L (R/d)^2 = I / d^2, exactly, all the way down to its surface
// (Lambert 1760; the form factor of a sphere, for instance in Howell, "A Catalog of Radiation Heat Transfer Configuration
// Factors", B-38). Inside it E stays I / R^2. A surface turned by theta gets E cos theta, which holds while no part
// of the ball lies below its horizon.
#include "draw/arithmetic.glsl"

struct Arrival {
  vec3 towards;   // the ball's middle; unit
  float perArea;  // illuminance of what faces it, for each candela: 1/d^2 (1/m^2)
  float spread;   // sine of the angle that its radius spans
};

// `ball`: xyz its middle, w radius (m); `perRadius2` = 1 / radius^2.
FUNCTION Arrival arrivalAt(vec3 p, vec4 ball, float perRadius2) {
  ROUNDED vec3 to = vec3(ball) - p;
  float perDistance = inverseRoot(max(dotted(to, to), 1e-12f));
  ROUNDED vec3 towards = to * perDistance;
  ROUNDED float perArea = perDistance * perDistance;
  ROUNDED float spread = ball.w * perDistance;
  Arrival arrival;  // by its members: C++ before P0960 has no parentheses for this
  arrival.towards = towards;
  arrival.perArea = min(perArea, perRadius2);
  arrival.spread = min(spread, 1.0f);
  return arrival;
}

// What a cone lets through in the direction from the light, -towards: all of it in the middle, none beyond the edge, and in
// between the square of a straight line in the angle's cosine. `cone`: Lamp.cone.
FUNCTION float coneShare(vec3 towards, vec4 cone) {
  ROUNDED float line = cone.w - dotted(towards, vec3(cone));
  float share = clamp(line, 0.0f, 1.0f);
  ROUNDED float squared = share * share;
  return squared;
}

// The alpha of a GGX lobe seen by a ball instead of a point: half vectors spread by half the angle of the light, and the
// variances of the two spreads add up. The lobe stays one of GGX, so it keeps its energy.
FUNCTION float widenedAlpha(float alpha, float spread) {
  ROUNDED float square = alpha * alpha + 0.25f * spread * spread;
  return root(square);
}
