// Solves all constraints along a line of particles together. Compiles as GLSL and as C++. The including file provides
// common/exact.glsl and these variables: lineLinks (number of links between particles), lineRest (rest length in
// metres), lineCompliance (compliance / h^2), lineGive (minimum compliance, see edgeComplianceOf), lineKept (fraction of a link's
// stretch that damping preserves over the substep, see keptStretch in cloth/model.glsl).
//
// The XPBD constraint k links the particles k and k + 1. It has the direction n_k, the stretch C_k and the multiplier
// l_k. Particle k has the inverse mass w_k and moves by w_k (n_k-1 l_k-1 - n_k l_k). To first order, all C_k vanish
// simultaneously if
//   -w_k (n_k-1.n_k) l_k-1 + (w_k + w_k+1 + compliance / h^2) l_k - w_k+1 (n_k.n_k+1) l_k+1 = -C_k.
// A pull at one end therefore reaches the other end in the same step, however long the line is; constraints solved one
// after another would move it by one link per step. A line is divided into segments of segmentLinks links, and the last
// link of a segment is its separator. A small system of the separators is solved first; then all segments are solved in
// parallel between their separators.
#include "cloth/segment_links.glsl"

struct Link {
  vec3 along;     // Unit vector, or zero if the link does not exist
  float stretch;  // Length minus rest length, in metres
};

// Row of the tridiagonal system: lower l_k-1 + diagonal l_k + upper l_k+1 = right.
struct LineRow {
  float lower, diagonal, upper, right;
};

// Expression for a multiplier in terms of the multipliers l_left and l_right of links further away: l = fixed_ - left
// l_left - right l_right.
struct Reach {
  float fixed_, left, right;
};

FUNCTION Link linkBetween(vec4 a, vec4 b, bool there) {
  precise vec3 d = vec3(b) - vec3(a);
  float squared = max(exactDot(d, d), 1e-12f);
  float inverse = exactInverseSqrt(squared);
  precise vec3 along = d * inverse;
  precise float stretch = squared * inverse - lineRest;
  Link link;
  link.along = there ? along : vec3(0.0f);
  link.stretch = stretch;
  return link;
}

// Returns the minimum compliance of every link of a line, as a ratio to the link's inverse masses. `stretch` is the sum
// of the link's stretches in metres; `pinned` is true if the line has two pins. A line that is taut between two pins
// has one undetermined multiplier; the minimum ratio 2^-15 regularizes the system. If the pins are further apart than
// the line's length by a fraction s of the length, the system has no solution. The ratio 1.7 s then makes the line pull
// evenly by 0.29 m L / h^2 (particle mass m, rest length L), which keeps sideways swings stable (w dt = 1.63,
// cloth/motion.glsl). Lines without two pins use 0.6 s and pull by at most 5/6 m L / h^2; they contract faster, and the
// pull does not last. A link whose compliance is larger keeps that compliance. Lines that conserve energy use minCompliance
// (cloth/segment.glsl) instead.
FUNCTION float edgeComplianceOf(float stretch, bool pinned) {
  float part = pinned ? 1.7f : 0.6f;
  precise float rest = float(lineLinks) * lineRest;
  precise float give = stretch * exactReciprocal(rest) * part;
  return max(give, 3.0517578125e-5f);
}

// Builds the row of a link from its off-diagonal entries `lower` and `upper`, its right-hand side, and the inverse
// masses of its two ends.
FUNCTION LineRow lineRow(float lower, float right, float upper, float massA, float massB) {
  precise float weight = massA + massB;
  precise float give = weight * lineGive;
  precise float diagonal = weight + max(give, lineCompliance);
  LineRow row;
  row.lower = lower;
  row.diagonal = weight > 0.0f ? diagonal : 1.0f;
  row.upper = upper;
  row.right = right;
  return row;
}

// Returns the reciprocal pivot of the link with this row. `before` is the elimination result of the previous link.
FUNCTION float pivotInverse(LineRow row, Reach before) {
  precise float pivot = row.diagonal - row.lower * before.right;
  return exactReciprocal(pivot);
}
// Expresses the link's multiplier in terms of the last multiplier before the segment and the next link's multiplier.
FUNCTION Reach reachAhead(LineRow row, Reach before, float inverse) {
  precise float fixed_ = (row.right - row.lower * before.fixed_) * inverse;
  precise float left = row.lower * before.left * -inverse;
  precise float right = row.upper * inverse;
  Reach reach;
  reach.fixed_ = fixed_;
  reach.left = left;
  reach.right = right;
  return reach;
}
// Expresses the link's multiplier in terms of the previous link's multiplier and the segment's last multiplier. `after`
// is the result for the next link.
FUNCTION Reach reachBack(LineRow row, Reach after) {
  precise float pivot = row.diagonal - row.upper * after.left;
  float inverse = exactReciprocal(pivot);
  precise float fixed_ = (row.right - row.upper * after.fixed_) * inverse;
  precise float left = row.lower * inverse;
  precise float right = row.upper * after.right * -inverse;
  Reach reach;
  reach.fixed_ = fixed_;
  reach.left = left;
  reach.right = right;
  return reach;
}
// Boundary values of the elimination: reachAtStart() before the segment's first link, reachAtEnd() after its last link.
FUNCTION Reach reachAtStart() {
  Reach reach;
  reach.fixed_ = 0.0f;
  reach.left = -1.0f;
  reach.right = 0.0f;
  return reach;
}
FUNCTION Reach reachAtEnd() {
  Reach reach;
  reach.fixed_ = 0.0f;
  reach.left = 0.0f;
  reach.right = -1.0f;
  return reach;
}

// Builds the row of a separator in the system of separators. `mine` belongs to the last link of the segment, `next` to
// the first link of the next segment.
FUNCTION LineRow separatorRow(Reach mine, Reach next) {
  precise float diagonal = 1.0f - mine.right * next.left;
  precise float upper = mine.right * -next.right;
  precise float right = mine.fixed_ - mine.right * next.fixed_;
  LineRow row;
  row.lower = mine.left;
  row.diagonal = diagonal;
  row.upper = upper;
  row.right = right;
  return row;
}

// Result of the forward elimination: l_k = onto - from l_k+1.
struct Eliminated {
  float onto, from;
};

FUNCTION Eliminated eliminate(LineRow row, Eliminated before) {
  precise float pivot = row.diagonal - row.lower * before.from;
  float inverse = exactReciprocal(pivot);
  precise float onto = (row.right - row.lower * before.onto) * inverse;
  precise float from = row.upper * inverse;
  Eliminated eliminated;
  eliminated.onto = onto;
  eliminated.from = from;
  return eliminated;
}

FUNCTION float substituted(float onto, float from, float after) {
  precise float multiplier = onto - from * after;
  return multiplier;
}
