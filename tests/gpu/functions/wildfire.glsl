#include "spread/wildfire/types.glsl"

WildfireStep stepData;

// Returns a climb factor that is linear in i, from 0 to 4. Any table would be suitable for the test.
FUNCTION float climbFactor(int i) {
  precise float factor = float(i) * 0.0078125f;
  return factor;
}

#include "spread/wildfire/gale.glsl"
#include "spread/wildfire/model.glsl"

FUNCTION vec4 asked(int i) {
  stepData.spread[0] = uvec4(uint(someOf(i, 1, 65537)), 65536u, 20000u, 0u);
  stepData.spread[1] = uvec4(40000u, uint(someOf(i, 2, 65537)), 1u, 30000u);
  stepData.emberReach = 31.25f;
  stepData.emberSpread = someOf(i, 3, 256);
  uvec3 bits = diced(i, 4);
  // One component in three exceeds the wind's range, so that it does not fit into the bits of the gale.
  vec3 wind = 20.0f * somePlace(i, 5);
  uint gale = i % 16 == 1 ? uint(i % 3) : i % 4 == 0 ? stillAir : galeOf(wind.x, wind.y, 1.0f);
  uint incline = i % 3 == 0 ? evenGround : bits.x & 0xffffu;
  uint caught = catchChance(bits.y & 255u, fuelWeight(bits.z & 255u), incline, gale);
  ivec2 longest = galeFlight(gale);
  ivec2 flown = emberFlight(bits, longest);
  return vec4(float(int(caught)), float(longest.x), float(longest.y), float(flown.x * 4096 + flown.y));
}
