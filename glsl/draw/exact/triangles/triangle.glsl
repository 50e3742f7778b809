// A triangle on the picture: which samples it covers, and how near it is there. Compiles as GLSL and as C++.
//
// Corners are rounded to 1/256 pixel; from there on coverage is in integers. With an edge from p to q, and the triangle's
// inside on its left, E(s) = (q - p) x (s - p) is not negative inside; a sample on an edge belongs to the triangle
// for which that is a top or left one, so of two that share it exactly one has it.
#ifndef EXACT_TRIANGLE
#define EXACT_TRIANGLE
#include "draw/exact/fixed.glsl"

// A corner as the vertex kernels leave it: pixels times depth to the right and down, and depth (m).
struct Corner {
  ivec2 at;    // 1/256 pixel
  float near;  // nearest plane / depth, 0 to 1: affine on the picture
};

struct Edge {
  ivec2 from;  // 1/256 pixel
  ivec2 step_;  // to the other end
  int bias;    // 0 where the edge belongs to the triangle, else -1
};

struct Triangle {
  Edge edges[3];
  ivec2 low, high;     // its box (1/256 pixel)
  float near;          // at edges[0].from,
  float acrossNear;    // what 1/256 pixel to the right adds to it,
  float downNear;      // and downwards
  float least, most;   // of its corners
  bool turned;         // seen from behind
  bool empty;          // of no area
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
  // Inside is to the left of the way seen with y up, so with y down: left edges go down, top edges to the left.
  edge.bias = edge.step_.y > 0 || (edge.step_.y == 0 && edge.step_.x < 0) ? 0 : -1;
  return edge;
}

// The sign of u x v, for whole numbers whose products do not fit in 32 bits.
FUNCTION int crossSign(ivec2 u, ivec2 v) {
  int high1, low1, high2, low2;
  imulExtended(u.x, v.y, high1, low1);
  imulExtended(u.y, v.x, high2, low2);
  if (high1 != high2) return high1 > high2 ? 1 : -1;
  return uint(low1) > uint(low2) ? 1 : low1 == low2 ? 0 : -1;
}

// Whichever way round the corners come, the edges have the inside to their left.
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
  t.least = min(a.near, min(b.near, c.near));
  t.most = max(a.near, max(b.near, c.near));
  // The plane through the three: near = a + gradient . (place - a), by Cramer's rule.
  precise vec2 ab = vec2(b.at - a.at);
  precise vec2 ac = vec2(c.at - a.at);
  precise float up = b.near - a.near;
  precise float side = c.near - a.near;
  precise float area = ab.x * ac.y - ab.y * ac.x;
  float perArea = area < 0.0f ? exactReciprocal(area) : 0.0f;  // slivers of none are flat
  precise float acrossNear = (up * ac.y - side * ab.y) * perArea;
  precise float downNear = (side * ab.x - up * ac.x) * perArea;
  t.near = a.near;
  t.acrossNear = acrossNear;
  t.downNear = downNear;
  return t;
}

// How near the triangle is at a place (1/256 pixel): between its corners, so that slivers do not stab.
FUNCTION float nearAt(Triangle t, ivec2 at) {
  precise vec2 from = vec2(at - t.edges[0].from);
  precise float near = t.near + (t.acrossNear * from.x + t.downNear * from.y);
  return clamp(near, t.least, t.most);
}

// Keys of samples: nearer is less, empty is the most.
FUNCTION uint nearKey(float near) {
  return 0x7fffffffu - uint(floatBitsToInt(near));
}

// E of an edge at a place, for triangles of at most 64 pixels: below 2^30.
FUNCTION int edgeAt(Edge edge, ivec2 at) {
  ivec2 to = at - edge.from;
  return edge.step_.y * to.x - edge.step_.x * to.y + edge.bias;
}

// E / 16, rounded down, at a place, held where no sample of a tile around it could change the sign. With a place
// 16 h + l from the edge's beginning it is step x h + floor((step x l + bias) / 16): below 2^30 in 32 bits, whatever its parts
// are, and floats say well enough whether it is.
FUNCTION int edgeOverSixteen(Edge edge, ivec2 at) {
  const int most = 0x3fffffff;
  ivec2 to = at - edge.from;
  ivec2 high = ivec2(to.x >> 4, to.y >> 4), low = ivec2(to.x & 15, to.y & 15);
  precise float about = float(edge.step_.y) * float(high.x) - float(edge.step_.x) * float(high.y);
  uint whole = uint(edge.step_.y) * uint(high.x) - uint(edge.step_.x) * uint(high.y);
  int sixteenth = int(whole + uint((edge.step_.y * low.x - edge.step_.x * low.y + edge.bias) >> 4));
  if (about >= 536870912.0f) sixteenth = most;
  if (about <= -536870912.0f) sixteenth = -most;
  return sixteenth;
}

// E / 16 of a sample `aside` (1/16 pixel) from there.
FUNCTION int edgeAside(Edge edge, int middle, ivec2 aside) {
  return middle + edge.step_.y * aside.x - edge.step_.x * aside.y;
}
#endif
