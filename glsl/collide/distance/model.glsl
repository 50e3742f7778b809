// Signed distance from a point to a closed mesh. Compiles as GLSL and as C++. The including file provides loadBox(int),
// loadFace(int), `firstLeaf`, common/exact.glsl and bindings.glsl.
//
// The tree of boxes is a complete binary tree: box n has the children 2n and 2n + 1. A box has two elements, its
// minimum corner and its maximum corner. w of the minimum corner is the box that follows the subtree of n in preorder
// (0 if none exists). w of the maximum corner is the first face of a leaf.

#include "collide/closest.glsl"

FUNCTION Closest closestOfFace(vec3 p, int face) {
  int i = face * faceElements;
  return closestOf(p, vec3(loadFace(i)), vec3(loadFace(i + 1)), vec3(loadFace(i + 2)));
}

// State of a nearest-face search.
struct Search {
  float squared;  // Squared distance to the nearest face found so far, m^2
  int face;
  int box;        // Next box to test; 0 if the search is finished
};

FUNCTION float boxSquared(vec3 p, vec4 low, vec4 high) {
  precise vec3 below = vec3(low) - p;
  precise vec3 above = p - vec3(high);
  vec3 beside = max(max(below, above), vec3(0.0f));
  return exactDot(beside, beside);
}

FUNCTION Search inLeaf(vec3 p, Search s, int first) {
  for (int k = 0; k < leafFaces; ++k) {
    float squared = closestOfFace(p, first + k).squared;
    s.face = squared < s.squared ? first + k : s.face;
    s.squared = min(squared, s.squared);
  }
  return s;
}

// Starts a search. Descends to a leaf near p and tests its faces, to get a first upper bound.
FUNCTION Search begun(vec3 p) {
  int box = 1;
  for (int k = 0; k < 30 && box < firstLeaf; ++k) {
    int child = 2 * box;
    float left = boxSquared(p, loadBox(2 * child), loadBox(2 * child + 1));
    float right = boxSquared(p, loadBox(2 * child + 2), loadBox(2 * child + 3));
    box = right < left ? child + 1 : child;
  }
  Search s;
  s.squared = 1e30f;
  s.face = 0;
  s.box = 1;
  return inLeaf(p, s, int(loadBox(2 * box + 1).w));
}

// Advances the search by one box in preorder. Skips a box that is not nearer than the nearest face found so far.
FUNCTION Search searched(vec3 p, Search s) {
  vec4 low = loadBox(2 * s.box);
  vec4 high = loadBox(2 * s.box + 1);
  bool nearer = boxSquared(p, low, high) < s.squared;
  bool leaf = s.box >= firstLeaf;
  int next = nearer && !leaf ? 2 * s.box : int(low.w);
  if (nearer && leaf) s = inLeaf(p, s, int(high.w));
  s.box = next;
  return s;
}

// Returns the signed distance to a mesh with the nearest face `face`, negative inside. The normal of an edge is the sum
// of its two faces' normals. The normal of a corner is the sum of its faces' normals, weighted by their angles. The
// sign is therefore right wherever the closest point is (Baerentzen and Aanaes 2005, "Signed distance computation using
// the angle weighted pseudonormal").
FUNCTION float signedDistance(vec3 p, int face) {
  Closest closest = closestOfFace(p, face);
  vec3 normal = vec3(loadFace(face * faceElements + 3 + closest.feature));
  float side = exactDot(closest.offset, normal);
  float size = exactSqrt(closest.squared);
  return side < 0.0f ? -size : size;
}

// Converts a distance to integer units, clamped to 16 bits.
FUNCTION int wholeUnits(float distance_, float perUnit) {
  precise float units = distance_ * perUnit + 0.5f;
  return clamp(int(floor(clamp(units, -40000.0f, 40000.0f))), -32767, 32767);
}

FUNCTION uint halves(int low, int high) {
  return (uint(low) & 0xffffu) | (uint(high) << 16u);
}
