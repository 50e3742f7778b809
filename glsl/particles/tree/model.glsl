// Arithmetic of the gravity tree: keys, nodes and forces. Compiles as GLSL and as C++ (the CPU twin of the tests). The
// including file provides loadBody(int), which returns the bodies in sorted order (xyz m, w kg; all zero for an
// excluded body), and first includes particles/tree/types.glsl and common/exact.glsl.

// Returns true if a body takes part: its coordinates are below 1e18 m and its mass is between 1e-30 and 1e30 kg. The
// bits are compared, because the bits of positive floats compare like the floats, and NaN has larger bits.
FUNCTION bool takesPart(vec4 body) {
  int x = floatBitsToInt(body.x) & 0x7fffffff;
  int y = floatBitsToInt(body.y) & 0x7fffffff;
  int z = floatBitsToInt(body.z) & 0x7fffffff;
  int mass = floatBitsToInt(body.w);
  return x < 0x5d5e0b6b && y < 0x5d5e0b6b && z < 0x5d5e0b6b && mass > 0x0da24260 && mass < 0x7149f2ca;
}

// ---- Sort keys

#include "common/space_curve.glsl"

// ---- Nodes

// Moments of a node's bodies. The spread is 3 sum_j (m_j/M) s_j s_j^T in m^2, where m_j are the masses, M is their sum,
// and s_j = x_j - center. It does not contain the total mass, so that it stays in the range of floats both for a galaxy
// and for a marble.
struct Node {
  vec3 low;     // Minimum and maximum corner of the bounding box, m
  vec3 high;
  vec3 center;  // Centre of mass, m
  float mass;   // Total mass, kg; 0 if the node has no bodies
  vec3 along;   // xx, yy, zz components of the spread
  vec3 across;  // xy, xz, yz components of the spread
};

FUNCTION Node emptyNode() {
  Node node;
  node.low = vec3(1e30f);
  node.high = vec3(-1e30f);
  node.center = vec3(0.0f);
  node.mass = 0.0f;
  node.along = vec3(0.0f);
  node.across = vec3(0.0f);
  return node;
}

FUNCTION vec3 flushed(vec3 v) {
  return vec3(exactFlush(v.x), exactFlush(v.y), exactFlush(v.z));
}

// Adds fraction * (spread + 3 s s^T) to the node's spread. `along` and `across` are the components of the added spread.
FUNCTION Node withSpread(Node node, float fraction, vec3 s, vec3 along, vec3 across) {
  Node result = node;
  precise vec3 weighted = s * 3.0f;
  precise vec3 a = (weighted * s + along) * fraction + node.along;
  precise vec3 b =
      (vec3(weighted.x * s.y, weighted.x * s.z, weighted.y * s.z) + across) * fraction + node.across;
  result.along = a;
  result.across = b;
  return result;
}

FUNCTION Node leafNode(int first) {
  Node node = emptyNode();
  precise float mass = 0.0f;
  for (int i = 0; i < leafBodies; ++i) {
    vec4 body = loadBody(first + i);
    if (body.w > 0.0f) {
      node.low = min(node.low, vec3(body));
      node.high = max(node.high, vec3(body));
      mass = mass + body.w;
    }
  }
  if (mass == 0.0f) return node;
  node.mass = mass;
  float perMass = exactReciprocal(mass);
  precise vec3 center = vec3(0.0f);
  for (int i = 0; i < leafBodies; ++i) {
    vec4 body = loadBody(first + i);
    precise float fraction = body.w * perMass;
    center = center + (vec3(body) - node.low) * fraction;
  }
  center = center + node.low;
  node.center = center;
  for (int i = 0; i < leafBodies; ++i) {
    vec4 body = loadBody(first + i);
    precise float fraction = body.w * perMass;
    precise vec3 s = vec3(body) - center;
    if (body.w > 0.0f) node = withSpread(node, fraction, s, vec3(0.0f), vec3(0.0f));
  }
  node.along = flushed(node.along);
  node.across = flushed(node.across);
  return node;
}

FUNCTION Node parentNode(Node left, Node right) {
  if (right.mass == 0.0f) return left;
  if (left.mass == 0.0f) return right;
  Node node = emptyNode();
  node.low = min(left.low, right.low);
  node.high = max(left.high, right.high);
  precise float mass = left.mass + right.mass;
  node.mass = mass;
  float perMass = exactReciprocal(mass);
  precise float leftFraction = left.mass * perMass;
  precise float rightFraction = right.mass * perMass;
  precise vec3 center = left.center + (right.center - left.center) * rightFraction;
  node.center = center;
  precise vec3 toLeft = left.center - center;
  precise vec3 toRight = right.center - center;
  node = withSpread(node, leftFraction, toLeft, left.along, left.across);
  node = withSpread(node, rightFraction, toRight, right.along, right.across);
  node.along = flushed(node.along);
  node.across = flushed(node.across);
  return node;
}

// Returns the squared distance from a node's centre of mass beyond which the node's moments replace its bodies. The
// distance is side/opening + |centre of mass - middle of the box| (Barnes 1994). Returns -1 if all bodies are at one
// point or if the node is empty, because its moments are then exact at any distance.
FUNCTION float openingRadius2(Node node, float perOpening) {
  precise vec3 size = node.high - node.low;
  float side = max(size.x, max(size.y, size.z));
  if (side <= 0.0f) return -1.0f;
  precise vec3 offset = node.center - (node.low + size * 0.5f);
  precise float radius = side * perOpening + exactSqrt(exactDot(offset, offset));
  precise float squared = radius * radius;
  return squared;
}

// Node data for the walk: nodeCell() returns the centre of mass and the squared opening radius; nodeMoments0() and
// nodeMoments1() return mass and spread.
FUNCTION vec4 nodeCell(Node node, float perOpening) {
  float radius2 = openingRadius2(node, perOpening);
  // If all bodies are at one point, the centre must equal that point exactly, so that their pull on each other is zero.
  vec3 center = radius2 < 0.0f && node.mass > 0.0f ? node.low : node.center;
  return vec4(center, radius2);
}
FUNCTION vec4 nodeMoments0(Node node) {
  return vec4(node.mass, node.along.x, node.across.x, node.across.y);
}
FUNCTION vec4 nodeMoments1(Node node) {
  precise float trace = (node.along.x + node.along.y + node.along.z) * 0.5f;
  return vec4(node.along.y, node.across.z, node.along.z, trace);
}
FUNCTION Node unpackNode(vec4 low, vec4 high, vec4 cell, vec4 moments0, vec4 moments1) {
  Node node;
  node.low = vec3(low);
  node.high = vec3(high);
  node.center = vec3(cell);
  node.mass = moments0.x;
  node.along = vec3(moments0.y, moments1.x, moments1.z);
  node.across = vec3(moments0.z, moments0.w, moments1.y);
  return node;
}

// ---- Forces, on as many bodies in parallel as a REAL has components

struct Pull {
  REAL x;
  REAL y;
  REAL z;
};

// Mass, spread and half the trace of the spread of a node, as packed by nodeMoments0 and nodeMoments1.
struct Moments {
  REAL mass;
  REAL xx;
  REAL xy;
  REAL xz;
  REAL yy;
  REAL yz;
  REAL zz;
  REAL halfTrace;
};

FUNCTION REAL softenedSquare(REAL dx, REAL dy, REAL dz, float softening2) {
  precise REAL sum = dx * dx + dy * dy + dz * dz + softening2;
  return sum;
}

FUNCTION Pull pullOf(REAL x, REAL y, REAL z) {
  Pull p;
  p.x = x;
  p.y = y;
  p.z = z;
  return p;
}
FUNCTION Pull plusPull(Pull sum, Pull more) {
  precise REAL x = sum.x + more.x;
  precise REAL y = sum.y + more.y;
  precise REAL z = sum.z + more.z;
  return pullOf(x, y, z);
}

// Returns the pull m d / R^3 of a body, where R^2 = |d|^2 + eps^2 and d is the vector to the body.
FUNCTION Pull bodyPull(REAL dx, REAL dy, REAL dz, REAL mass, float softening2) {
  REAL inverse = exactInverseSqrt(softenedSquare(dx, dy, dz, softening2));
  precise REAL k = mass * inverse * inverse * inverse;
  precise REAL x = dx * k;
  precise REAL y = dy * k;
  precise REAL z = dz * k;
  return pullOf(x, y, z);
}
FUNCTION Pull plusBody(Pull sum, REAL x, REAL y, REAL z, vec4 body, float softening2) {
  precise REAL dx = body.x - x;
  precise REAL dy = body.y - y;
  precise REAL dz = body.z - z;
  return plusPull(sum, bodyPull(dx, dy, dz, REAL(body.w), softening2));
}

// Returns the pull of a node to second order. The potential of its bodies about the centre of mass, with the mass M and
// the spread A, is -M [1/R + (d.A d / R^5 - tr A / (3 R^3)) / 2]. Its gradient is M/R^3 [(1 + (5/2 d.w - tr A / 2) /
// R^2) d - w] with w = A d / R^2. This also holds with softening, because the trace term is not dropped.
FUNCTION Pull nodePull(REAL dx, REAL dy, REAL dz, Moments a, float softening2) {
  REAL inverse = exactInverseSqrt(softenedSquare(dx, dy, dz, softening2));
  precise REAL inverse2 = inverse * inverse;
  precise REAL wx = (a.xx * dx + a.xy * dy + a.xz * dz) * inverse2;
  precise REAL wy = (a.xy * dx + a.yy * dy + a.yz * dz) * inverse2;
  precise REAL wz = (a.xz * dx + a.yz * dy + a.zz * dz) * inverse2;
  precise REAL scale = ((dx * wx + dy * wy + dz * wz) * 2.5f - a.halfTrace) * inverse2 + 1.0f;
  precise REAL k = a.mass * inverse * inverse2;
  precise REAL x = (dx * scale - wx) * k;
  precise REAL y = (dy * scale - wy) * k;
  precise REAL z = (dz * scale - wz) * k;
  return pullOf(x, y, z);
}
FUNCTION Pull plusNode(Pull sum, REAL x, REAL y, REAL z, vec3 center, vec4 m0, vec4 m1, float softening2) {
  precise REAL dx = center.x - x;
  precise REAL dy = center.y - y;
  precise REAL dz = center.z - z;
  Moments a;
  a.mass = REAL(m0.x);
  a.xx = REAL(m0.y);
  a.xy = REAL(m0.z);
  a.xz = REAL(m0.w);
  a.yy = REAL(m1.x);
  a.yz = REAL(m1.y);
  a.zz = REAL(m1.z);
  a.halfTrace = REAL(m1.w);
  return plusPull(sum, nodePull(dx, dy, dz, a, softening2));
}

// Returns true if a node is far from a group's box, given by the centre of the box and half its size.
FUNCTION bool isFar(vec4 cell, vec3 middle, vec3 halfSize) {
  precise vec3 offset = vec3(cell) - middle;
  precise vec3 away = abs(offset) - halfSize;
  away = max(away, vec3(0.0f));
  return exactDot(away, away) > cell.w;
}

// Returns the next node of the preorder walk after the subtree of `node`, or 1 at the end of the tree.
FUNCTION int nodeAfter(int node) {
  int next = node + 1;
  return next >> findLSB(next);
}
