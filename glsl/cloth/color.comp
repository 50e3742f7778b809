// Colours the vertices of a cloth by a quantity: colour in rgb, value in a. One invocation per vertex. If SPEED is 1,
// the quantity is the speed in m/s; otherwise it is the strain, the mean of length / rest length - 1 over the links to
// the neighbours. If MESH is 1, the vertices are the drawn vertices of a cloth made of triangles, whose links are
// listed; otherwise they are the particles of a grid.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "cloth/bindings.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
STATE_ARRAY(colorsBinding, ColorBlock, colors)
INPUT_ARRAY(stopsBinding, StopBlock, stops)
#if SPEED
INPUT_ARRAY(velocitiesBinding, VelocityBlock, velocities)
INPUT_ARRAY(beforeBinding, BeforeBlock, before)
INPUT_ARRAY(trendsBinding, TrendBlock, trends)
uniform float perDt;       // 1 / duration of a substep, 1/s
uniform float trendShare;  // Factor of the trend (cloth/motion.glsl) by which the stored velocity differs from the
                           // actual velocity
#endif
#if MESH
INPUT_WORDS(verticesBinding, VertexBlock, vertices)
#if !SPEED
INPUT_WORDS(edgesBinding, EdgeBlock, edges)
#endif
#elif !SPEED
uniform ivec2 size;
uniform float perSpacing;  // 1 / rest length, 1/m
#endif
uniform int count;
#include "common/color_map.glsl"

#if SPEED
// A pinned vertex has no velocity in the state, so its speed is computed from its displacement.
float valueAt(int i) {
  vec4 here = LOAD_INPUT(positions, i);
  precise vec3 way = (here.xyz - LOAD_INPUT(before, i).xyz) * perDt;
  precise vec3 velocity = LOAD_INPUT(velocities, i).xyz - LOAD_INPUT(trends, i).xyz * trendShare;
  vec3 actual = here.w == 0.0f ? way : velocity;
  return exactSqrt(exactDot(actual, actual));
}
#else
float strainTo(int other, vec3 here, float perRest) {
  precise vec3 d = LOAD_INPUT(positions, other).xyz - here;
  precise float strain = exactSqrt(exactDot(d, d)) * perRest - 1.0f;
  return strain;
}
#if MESH
float valueOf(uvec4 vertex) {
  vec3 here = LOAD_INPUT(positions, int(vertex.x)).xyz;
  precise float sum = 0.0f;
  for (uint k = 0u; k < vertex.z; ++k) {
    uvec4 edge = LOAD_INPUT_WORDS(edges, int(vertex.y + k));
    sum = sum + strainTo(int(edge.x), here, exactReciprocal(uintBitsToFloat(edge.y)));
  }
  precise float mean = sum * exactReciprocal(float(max(vertex.z, 1u)));
  return mean;
}
#else
float valueAt(int i) {
  vec3 here = LOAD_INPUT(positions, i).xyz;
  int x = i % size.x, y = i / size.x;
  precise float sum = 0.0f;
  if (x > 0) sum = sum + strainTo(i - 1, here, perSpacing);
  if (x + 1 < size.x) sum = sum + strainTo(i + 1, here, perSpacing);
  if (y > 0) sum = sum + strainTo(i - size.x, here, perSpacing);
  if (y + 1 < size.y) sum = sum + strainTo(i + size.x, here, perSpacing);
  int links = min(x, 1) + min(size.x - 1 - x, 1) + min(y, 1) + min(size.y - 1 - y, 1);
  precise float mean = sum * exactReciprocal(float(links));
  return mean;
}
#endif
#endif

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
#if !MESH
  float value = valueAt(i);
#elif SPEED
  float value = valueAt(int(LOAD_INPUT_WORDS(vertices, i).x));
#else
  float value = valueOf(LOAD_INPUT_WORDS(vertices, i));
#endif
  STORE_STATE(colors, i, vec4(mappedColor(value).xyz, value));
}
