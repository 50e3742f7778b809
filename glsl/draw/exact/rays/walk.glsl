// Stackless traversal of a hierarchy, nearest child first. The tree is complete, so the bits of `trail` can mark the
// levels above a node at which the sibling must still be visited. The macro defines a function NAME that reads NODES
// and calls TEST for the items of a leaf. The traversal ends early if WALK_OVER is true. Compiles as GLSL and as C++.
#include "draw/exact/rays/ray_shapes.glsl"
#include "draw/exact/rays/leaf.glsl"

// Returns the index of the lowest set bit. Uses the exponent of a float, because drivers expand findLSB to many
// operations.
FUNCTION int lowestBit(uint bits) {
  uint lowest = bits & (~bits + 1u);
  return (floatBitsToInt(float(int(lowest))) >> 23) - 127;
}

#define WALK(NAME, NODES, TEST)                                                                                \
  RayHit NAME(Ray ray, RayPlanes planes, RayHit best, int count, int leaves) {                                 \
    int end_ = 2 * leaves;                                                                                     \
    int node = count > 0 && best.t > 0.0f ? 1 : end_;                                                          \
    uint trail = 0u;                                                                                           \
    while (node < end_) {                                                                                      \
      while (node < leaves) {                                                                                  \
        uvec4 left = texelFetch(NODES, 2 * node), right = texelFetch(NODES, 2 * node + 1);                     \
        vec2 a = spanIn(planes, left.x, left.y, left.z), b = spanIn(planes, right.x, right.y, right.z);        \
        bool first = isWithin(a.x, a.y) && isWithin(a.x, best.t), second = isWithin(b.x, b.y) && isWithin(b.x, best.t);                                \
        bool rightFirst = second && !(first && isWithin(a.x, b.x)), down = first || second, over = trail == 0u;         \
        int up_ = over ? 0 : lowestBit(trail);                                                                   \
        int sibling = over ? end_ : (node >> up_) ^ 1;                                                         \
        node = down ? 2 * node + (rightFirst ? 1 : 0) : sibling;                                               \
        trail = down ? trail << 1 | (first && second ? 1u : 0u) : over ? 0u : (trail >> up_) ^ 1u;             \
      }                                                                                                        \
      ivec2 held = node < end_ ? heldBy(node - leaves, count, leaves) : ivec2(0);                              \
      for (int i = held.x; i < held.y; ++i) best = TEST(ray, planes, best, i);                                 \
      bool over = trail == 0u || WALK_OVER(best);                                                              \
      int up_ = over ? 0 : lowestBit(trail);                                                                     \
      node = over ? end_ : (node >> up_) ^ 1;                                                                  \
      trail = over ? 0u : (trail >> up_) ^ 1u;                                                                 \
    }                                                                                                          \
    return best;                                                                                               \
  }
