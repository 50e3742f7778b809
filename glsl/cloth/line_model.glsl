// Constraints along a line of particles, solved together. Compiles as GLSL and as C++. Whoever includes it provides
// lineLinks, the number of links between particles, lineRest (m), lineCompliance (compliance / h^2) and lineGive, beside
// common/exact.glsl; lineKept, what damping keeps of a link's stretch over the substep (glsl/cloth/model.glsl).
//
// XPBD's constraint k ties particles k and k + 1. With its direction n_k, its stretch C_k and its multiplier l_k, particle k
// moves by w_k (n_k-1 l_k-1 - n_k l_k); every C_k vanishes at once, to first order, where
//   -w_k (n_k-1.n_k) l_k-1 + (w_k + w_k+1 + compliance / h^2) l_k - w_k+1 (n_k.n_k+1) l_k+1 = -C_k.
// So what pulls at one end is felt at the other in the same step, however long the line is, where constraints one after
// the other carry it a link a step. Lines are cut into segments of segmentLinks: the last link of each, its separator, is
// found first, from a system of separators alone; then all segments at once are solved between theirs.
#include "cloth/segment_links.glsl"

struct Link {
  vec3 along;     // unit; none: 0
  float stretch;  // m
};

// lower l_k-1 + diagonal l_k + upper l_k+1 = right
struct LineRow {
  float lower, diagonal, upper, right;
};

// l = fixed_ - left l_left - right l_right, of links far apart.
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

// The least compliance of each link, as a ratio to its weights. A line that is taut between two pins has a
// multiplier too many, which 2^-15 decides. One that is held further apart than it is long, by s of its length, cannot
// be satisfied at all: where both its ends are pinned, with 1.7 s it pulls evenly, by 0.29 m L / h^2, so that it does not begin to
// swing sideways (w dt = 1.63, cloth/motion.glsl). Other lines get what they lack sooner with 0.6 s, by 5/6 m L / h^2 at most,
// which they do not keep up. Softer lines are as soft as they are. Those that keep energy have keptGive (cloth/segment.glsl) instead.
FUNCTION float giveOf(float stretch, bool pinned) {
  float part = pinned ? 1.7f : 0.6f;
  precise float rest = float(lineLinks) * lineRest;
  precise float give = stretch * exactReciprocal(rest) * part;
  return max(give, 3.0517578125e-5f);
}

// Of a link by what its row has beside the diagonal and on the right, and the inverse masses of its ends.
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

// 1 / pivot of the link whose row this is; `before` is of the link before it.
FUNCTION float pivotInverse(LineRow row, Reach before) {
  precise float pivot = row.diagonal - row.lower * before.right;
  return exactReciprocal(pivot);
}
// Of that link by what is left of the segment and the next link.
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
// By the link before it and the segment's last; `after` is of the link after it.
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
// Before the first link, and after the last.
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

// Of a separator between those of its neighbours: `mine` is the last link of its segment, `next` the first one of the next.
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

// l_k = onto - from l_k+1
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
