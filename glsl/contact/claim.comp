// Computes the correction of each near pair and adds the pair's claims to the tallies of its corners. One invocation
// per near pair.
#include "contact/kernel.glsl"
#include "contact/near_list.glsl"

void main() {
  int i = nearIndex();
  if (i >= nearsThere()) return;
  Near near = nearAt(i);
  ivec4 c = cornersOf(near);
  vec3 slide = weighted(near.shares, wayOf(c.x), wayOf(c.y), wayOf(c.z), wayOf(c.w));
  float friction = frictionBetween(pointAt(skinSection, c.x).y, pointAt(skinSection, c.w).y);
  float thick = thicknessOf(c), back = -1e30f;
  bool pushes = isInside(near);
  if (isBall(c.x)) {
    pushes = pushesBall(near, intBitsToFloat(LOAD_TALLY(nearestTally(c.x)).w));
    vec3 led = weighted(near.shares, ledOf(c.x), ledOf(c.y), ledOf(c.z), ledOf(c.w));
    back = givenBack(near, led, thick, pointAt(skinSection, c.x).z);
  }
  vec3 way = correctionOf(near, slide, thick, friction, back, pushes);
  bool touching = way != vec3(0.0f);
  STORE_STATE(nears, 3 * i + 2, vec4(way, touching ? 1.0f : 0.0f));
  if (!touching) return;
  for (int k = 0; k < 4; ++k)
    if (!isSolid(c[k])) atomicAdd(tallies[impulseTally(c[k])].w, massWeightOf(near.shares[k]));
}
