// A triangle in the picture: covered samples and nearness. Compiles as GLSL and as C++.
// Corners are rounded to 1/256 pixel. Coverage is then computed in integers. With y up and the triangle on the left of
// its edges, the edge function E(s) = (q - p) x (s - p) of an edge from p to q is not negative inside. In the code y
// points down, so its sign is reversed: E(s) = (s - p) x (q - p). A sample exactly on an edge belongs to the triangle
// for which the edge is a top or left edge, so exactly one of two triangles with a common edge covers the sample.
#ifndef EXACT_TRIANGLE
#define EXACT_TRIANGLE
#include "draw/exact/fixed.glsl"

// A corner of a triangle, computed from a projected vertex (pixels to the right and down, times depth, and depth in m).
struct Corner {
  ivec2 at;    // position of the corner in 1/256 pixel
  float near;  // nearness: near plane / depth, 0 to 1, affine in the picture position
};

struct Edge {
  ivec2 from;  // start of the edge in 1/256 pixel
  ivec2 step_;  // vector from the edge's start to its end
  int bias;    // 0 if samples on the edge belong to the triangle, otherwise -1
};

struct Triangle {
  Edge edges[3];
  ivec2 low, high;     // bounding box of the triangle in 1/256 pixel
  float near;          // nearness of the triangle at edges[0].from
  float acrossNear;    // change of nearness per 1/256 pixel to the right
  float downNear;      // change of nearness per 1/256 pixel downwards
  float minimum, maximum;   // min and max nearness of the corners
  bool turned;         // true if the triangle's back side is visible
  bool empty;          // true if the triangle's area is zero
};

FUNCTION Corner cornerOf(vec3 v, float nearest) {
  float perDepth = exactReciprocal(v.z);
  precise float x = v.x * perDepth * 256.0f + 0.5f;
  precise float y = v.y * perDepth * 256.0f + 0.5f;
  precise float near = nearest * perDepth;
  Corner corner;
  corner.at = ivec2(int(floor(x)), int(floor(y)));
  corner.near = near;
  return corner;
}

FUNCTION Edge edgeOf(ivec2 from, ivec2 to) {
  Edge edge;
  edge.from = from;
  edge.step_ = to - from;
  // Top-left rule: samples on a top edge or a left edge belong to the triangle. The edges run counterclockwise in the
  // picture, so a left edge runs downwards (y grows) and a top edge runs to the left (y is constant and x decreases).
  edge.bias = edge.step_.y > 0 || (edge.step_.y == 0 && edge.step_.x < 0) ? 0 : -1;
  return edge;
}

// Returns the sign of the cross product u x v, for integers whose products exceed 32 bits.
FUNCTION int crossSign(ivec2 u, ivec2 v) {
  int high1, low1, high2, low2;
  imulExtended(u.x, v.y, high1, low1);
  imulExtended(u.y, v.x, high2, low2);
  if (high1 != high2) return high1 > high2 ? 1 : -1;
  return uint(low1) > uint(low2) ? 1 : low1 == low2 ? 0 : -1;
}

// Sets up a triangle for corners in either order. Its edges run counterclockwise in the picture.
FUNCTION Triangle triangleOf(Corner a, Corner first, Corner second) {
  int sign_ = crossSign(first.at - a.at, second.at - a.at);
  Corner b = first, c = second;
  if (sign_ > 0) {
    b = second;
    c = first;
  }
  Triangle t;
  t.turned = sign_ > 0;
  t.empty = sign_ == 0;
  t.edges[0] = edgeOf(a.at, b.at);
  t.edges[1] = edgeOf(b.at, c.at);
  t.edges[2] = edgeOf(c.at, a.at);
  t.low = min(a.at, min(b.at, c.at));
  t.high = max(a.at, max(b.at, c.at));
  t.minimum = min(a.near, min(b.near, c.near));
  t.maximum = max(a.near, max(b.near, c.near));
  // Computes the plane through the three corners, near = a + gradient . (place - a), by Cramer's rule.
  precise vec2 ab = vec2(b.at - a.at);
  precise vec2 ac = vec2(c.at - a.at);
  precise float up = b.near - a.near;
  precise float side = c.near - a.near;
  precise float area = ab.x * ac.y - ab.y * ac.x;
  float perArea = area < 0.0f ? exactReciprocal(area) : 0.0f;  // degenerate triangles get a constant nearness
  precise float acrossNear = (up * ac.y - side * ab.y) * perArea;
  precise float downNear = (side * ab.x - up * ac.x) * perArea;
  t.near = a.near;
  t.acrossNear = acrossNear;
  t.downNear = downNear;
  return t;
}

// Returns the nearness at a position (1/256 pixel), clamped to the range of the corners so that slivers do not produce
// spikes.
FUNCTION float nearAt(Triangle t, ivec2 at) {
  precise vec2 from = vec2(at - t.edges[0].from);
  precise float near = t.near + (t.acrossNear * from.x + t.downNear * from.y);
  return clamp(near, t.minimum, t.maximum);
}

// Returns the depth key of a sample. Nearer samples have smaller keys; empty samples have the largest key.
FUNCTION uint nearKey(float near) {
  return 0x7fffffffu - uint(floatBitsToInt(near));
}

// Returns the edge function E at a position, for triangles of at most 64 pixels; the result is below 2^30.
FUNCTION int edgeAt(Edge edge, ivec2 at) {
  ivec2 to = at - edge.from;
  return edge.step_.y * to.x - edge.step_.x * to.y + edge.bias;
}

// Returns the edge function E / 16 at a position, rounded down. The result is clamped if all samples of a tile around
// the position have the same sign. For a position 16 h + l from the edge's start, the result is step x h + floor((step
// x l + bias) / 16). It is exact in 32 bits if it is below 2^30, even if partial products wrap around. Float arithmetic
// is precise enough to decide whether that holds.
FUNCTION int edgeOverSixteen(Edge edge, ivec2 at) {
  const int maximum = 0x3fffffff;
  ivec2 to = at - edge.from;
  ivec2 high = ivec2(to.x >> 4, to.y >> 4), low = ivec2(to.x & 15, to.y & 15);
  precise float about = float(edge.step_.y) * float(high.x) - float(edge.step_.x) * float(high.y);
  uint whole = uint(edge.step_.y) * uint(high.x) - uint(edge.step_.x) * uint(high.y);
  int sixteenth = int(whole + uint((edge.step_.y * low.x - edge.step_.x * low.y + edge.bias) >> 4));
  if (about >= 536870912.0f) sixteenth = maximum;
  if (about <= -536870912.0f) sixteenth = -maximum;
  return sixteenth;
}

// Returns the edge function E / 16 at a sample with the offset `aside` (1/16 pixel).
FUNCTION int edgeAside(Edge edge, int middle, ivec2 aside) {
  return middle + edge.step_.y * aside.x - edge.step_.x * aside.y;
}
#endif
