// Adds the impulses of each near pair to the tallies of its corners. One invocation per near pair.
#include "contact/kernel.glsl"
#include "contact/near_list.glsl"

void add(int vertex, ivec3 quanta) {
  if (isSolid(vertex)) return;
  int i = impulseTally(vertex);
  atomicAdd(tallies[i].x, quanta.x);
  atomicAdd(tallies[i].y, quanta.y);
  atomicAdd(tallies[i].z, quanta.z);
}

void main() {
  int i = nearIndex();
  if (i >= nearsThere()) return;
  vec4 way = LOAD_ONCE(nears, 3 * i + 2);
  if (way.w == 0.0f) return;
  Near near = nearAt(i);
  ivec4 c = cornersOf(near);
  vec4 weights;
  for (int k = 0; k < 4; ++k) weights[k] = weightOf(pointAt(nowSection, c[k]).w, LOAD_TALLY(impulseTally(c[k])).w);
  vec3 impulse = impulseOf(near.shares, weights, way.xyz);
  ivec3 rest = ivec3(0);
  for (int k = 0; k < 3; ++k) {
    ivec3 quanta = quantaOf(impulse, near.shares[k]);
    add(c[k], quanta);
    rest -= quanta;
  }
  add(c.w, rest);
}
