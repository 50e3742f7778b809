// Constraints along a line of particles, solved together. Compiles as GLSL and as C++. Whoever includes it provides
// lineParticle(int), xyz and inverse mass of the k-th particle of the line, lineLinks, the number of links between them,
// lineRest (m), lineCompliance (compliance / dt^2) and lineGive, beside common/exact.glsl; lineKept, what damping keeps of a
// link's stretch over the substep (glsl/cloth/model.glsl), and lineBefore(int), the particle at the substep's beginning.
//
// XPBD's constraint k ties particles k and k + 1. With its direction n_k, its stretch C_k and its multiplier l_k, particle k
// moves by w_k (n_k-1 l_k-1 - n_k l_k); every C_k vanishes at once, to first order, where
//   -w_k (n_k-1.n_k) l_k-1 + (w_k + w_k+1 + compliance / dt^2) l_k - w_k+1 (n_k.n_k+1) l_k+1 = -C_k.
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

// How much longer than at rest the links of a segment are together (m).
FUNCTION float stretchOfSegment(int first, int last) {
  precise float sum = 0.0f;
  vec4 a = lineParticle(first);
  for (int k = first; k <= last; ++k) {
    vec4 b = lineParticle(k + 1);
    Link link = linkBetween(a, b, true);
    sum = sum + link.stretch;
    a = b;
  }
  return sum;
}

// What is added to the compliance of each link, as a ratio to its weights. A line that is taut between two pins has a
// multiplier too many, which 2^-15 decides. One that is held further apart than it is long, by s of its length, cannot
// be satisfied at all: with 0.6 s it pulls evenly, by 5/6 m L / dt^2. A straight line swings sideways with
// w^2 = 4 T / (m L) at most, which is stable while T < m L / dt^2.
FUNCTION float giveOf(float stretch) {
  precise float rest = float(lineLinks) * lineRest;
  precise float give = stretch * exactReciprocal(rest) * 0.6f;
  return max(give, 3.0517578125e-5f);
}

// Of the k-th link, from a to b.
FUNCTION LineRow lineRow(int k, Link before, Link here, Link after, vec4 a, vec4 b) {
  precise float weight = a.w + b.w;
  precise float diagonal = weight + weight * lineGive + lineCompliance;
  float fromBefore = exactDot(before.along, here.along);
  float fromAfter = exactDot(here.along, after.along);
  precise float lower = fromBefore * -a.w;
  precise float upper = fromAfter * -b.w;
  LineRow row;
  row.lower = lower;
  row.diagonal = weight > 0.0f ? diagonal : 1.0f;
  row.upper = upper;
  float stretch = here.stretch;
  if (lineKept > 0.0f) {
    Link past = linkBetween(lineBefore(k), lineBefore(k + 1), true);
    precise float undone = stretch - past.stretch * lineKept;
    stretch = undone;
  }
  row.right = weight > 0.0f ? -stretch : 0.0f;
  return row;
}

// The last link of a segment by what is to the left of the segment and the link to its right.
FUNCTION Reach lastOfSegment(int first, int last) {
  vec4 a = lineParticle(first);
  vec4 b = lineParticle(first + 1);
  Link before = linkBetween(lineParticle(max(first - 1, 0)), a, first > 0);
  Link here = linkBetween(a, b, true);
  Reach reach;
  reach.fixed_ = 0.0f;
  reach.left = -1.0f;
  reach.right = 0.0f;
  for (int k = first; k <= last; ++k) {
    vec4 c = lineParticle(min(k + 2, lineLinks));
    Link after = linkBetween(b, c, k + 1 < lineLinks);
    LineRow row = lineRow(k, before, here, after, a, b);
    precise float pivot = row.diagonal - row.lower * reach.right;
    float inverse = exactReciprocal(pivot);
    precise float fixed_ = (row.right - row.lower * reach.fixed_) * inverse;
    precise float left = row.lower * reach.left * -inverse;
    precise float right = row.upper * inverse;
    reach.fixed_ = fixed_;
    reach.left = left;
    reach.right = right;
    a = b;
    b = c;
    before = here;
    here = after;
  }
  return reach;
}

// The first link of a segment by what is to the left of the segment and its last link.
FUNCTION Reach firstOfSegment(int first, int last) {
  vec4 b = lineParticle(last);
  Link after = linkBetween(b, lineParticle(last + 1), true);
  vec4 a = lineParticle(max(last - 1, 0));
  Link here = linkBetween(a, b, true);
  Reach reach;
  reach.fixed_ = 0.0f;
  reach.left = 0.0f;
  reach.right = -1.0f;
  for (int k = last - 1; k >= first; --k) {
    vec4 z = lineParticle(max(k - 1, 0));
    Link before = linkBetween(z, a, k > 0);
    LineRow row = lineRow(k, before, here, after, a, b);
    precise float pivot = row.diagonal - row.upper * reach.left;
    float inverse = exactReciprocal(pivot);
    precise float fixed_ = (row.right - row.upper * reach.fixed_) * inverse;
    precise float left = row.lower * inverse;
    precise float right = row.upper * reach.right * -inverse;
    reach.fixed_ = fixed_;
    reach.left = left;
    reach.right = right;
    b = a;
    a = z;
    after = here;
    here = before;
  }
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
