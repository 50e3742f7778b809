// Solution of one segment of a line, with the links `first` to `last`. Compiles as GLSL and as C++, after
// line_model.glsl. The including file provides:
// - lineParticle(k): position (xyz) and inverse mass (w) of the line's k-th particle; lineBefore(k): the same at the
//   start of the substep;
// - lineSoftening: the factor on the inverse masses for lines that conserve energy (cloth/keeping.glsl), otherwise 1;
// - lineLower[segmentLinks + 1], lineMass[segmentLinks + 1], lineStretch[segmentLinks]: arrays that are private to the
//   invocation.

// Returns the part of link k's stretch that the constraint removes: the whole stretch minus the part that damping
// preserves.
FUNCTION float undone(int k, float stretch) {
  float all = stretch;
  if (lineKept > 0.0f) {
    Link past = linkBetween(lineBefore(k), lineBefore(k + 1), true);
    precise float some = stretch - past.stretch * lineKept;
    all = some;
  }
  return all;
}

// Builds the rows of the segment's links. lineLower receives the off-diagonal entries; the matrix is symmetric, so a
// row's upper entry is the next row's lower entry. lineStretch receives the right-hand sides and lineMass the inverse
// masses. Returns the sum of the links' stretches in metres.
FUNCTION float readSegment(int first, int last) {
  precise float sum = 0.0f;
  vec4 a = lineParticle(first);
  vec4 b = lineParticle(first + 1);
  Link before = linkBetween(lineParticle(max(first - 1, 0)), a, first > 0);
  Link here = linkBetween(a, b, true);
  float cosine = exactDot(before.along, here.along);
  precise float mass = a.w * lineSoftening;
  precise float lower = cosine * -mass;
  lineLower[0] = lower;
  lineMass[0] = mass;
  for (int k = first; k <= last; ++k) {
    vec4 c = lineParticle(min(k + 2, lineLinks));
    Link after = linkBetween(b, c, k + 1 < lineLinks);
    cosine = exactDot(here.along, after.along);
    precise float next = b.w * lineSoftening;
    precise float upper = cosine * -next;
    lineLower[k - first + 1] = upper;
    lineMass[k - first + 1] = next;
    precise float weight = mass + next;
    lineStretch[k - first] = weight > 0.0f ? -undone(k, here.stretch) : 0.0f;
    mass = next;
    sum = sum + here.stretch;
    b = c;
    here = after;
  }
  return sum;
}

// Returns the number of pinned particles of a segment. Call it after readSegment(). The segment's first particle counts
// for the previous segment, if there is one.
FUNCTION float pinsOf(int first, int links) {
  int pins = first == 0 && lineMass[0] == 0.0f ? 1 : 0;
  for (int i = 1; i <= links; ++i) pins = lineMass[i] == 0.0f ? pins + 1 : pins;
  return float(pins);
}

// Replaces edgeComplianceOf() for lines that conserve energy. It depends only on quantities that a substep does not change, so
// that the forces have a potential. A straight line between pins has one undetermined multiplier, and a swing through
// the straight position would be stopped abruptly. Therefore, each link yields at least dt^2 / (4 m) metres per newton,
// where m is the particle mass. If the pins of a line are further apart than its length by a fraction s, it pulls by m
// L / (6 softening dt^2), with w dt = 0.82 / sqrt(softening).
FUNCTION float minCompliance(float pins) {
  vec4 a = lineParticle(0), b = lineParticle(lineLinks);
  Link ends = linkBetween(a, b, true);
  precise float rest = float(lineLinks) * lineRest;
  precise float beyond = ends.stretch + lineRest - rest;
  precise float held = beyond * exactReciprocal(rest) * 3.0f;
  precise float minimum = exactReciprocal(lineSoftening) * 0.125f;
  bool ended = a.w == 0.0f && b.w == 0.0f;
  return pins < 2.0f ? 3.0517578125e-5f : ended ? max(held, minimum) : minimum;
}

// Returns the row of link i of the segment.
FUNCTION LineRow segmentRow(int i) {
  return lineRow(lineLower[i], lineStretch[i], lineLower[i + 1], lineMass[i], lineMass[i + 1]);
}

// Expresses the segment's first multiplier in terms of the last multiplier before the segment and the segment's last
// multiplier.
FUNCTION Reach firstOfSegment(int links) {
  Reach reach = reachAtEnd();
  for (int i = links - 2; i >= 0; --i) reach = reachBack(segmentRow(i), reach);
  return reach;
}

// Expresses the segment's last multiplier in terms of the last multiplier before the segment and the first multiplier
// after it. Overwrites lineMass with the reciprocal pivots, because solveSegment() needs the same pivots and no masses.
FUNCTION Reach lastOfSegment(int links) {
  Reach reach = reachAtStart();
  for (int i = 0; i < links; ++i) {
    LineRow row = segmentRow(i);
    float inverse = pivotInverse(row, reach);
    reach = reachAhead(row, reach, inverse);
    lineMass[i] = inverse;
  }
  return reach;
}

// Computes the multipliers of a segment between its separators; call it after lastOfSegment(). Overwrites the
// right-hand sides in lineStretch with the multipliers.
FUNCTION void solveSegment(int links, float leftOne, float lastOne) {
  float before = leftOne;
  for (int i = 0; i < links - 1; ++i) {
    precise float onto = (lineStretch[i] - lineLower[i] * before) * lineMass[i];
    lineStretch[i] = onto;
    before = onto;
  }
  lineStretch[links - 1] = lastOne;
  float after = lastOne;
  for (int i = links - 2; i >= 0; --i) {
    precise float from = lineLower[i + 1] * lineMass[i];
    after = substituted(lineStretch[i], from, after);
    lineStretch[i] = after;
  }
}

// Returns the pull of the link from a to b. The caller subtracts it, times the inverse mass, from the position of a,
// and adds it to the position of b. The magnitude is limited to the stable value (see edgeComplianceOf()), in case the ends of a
// part of a line are pinned too far apart or the substeps are too long.
FUNCTION vec3 pullBetween(vec4 a, vec4 b, bool there, float multiplier) {
  Link link = linkBetween(a, b, there);
  precise float weight = a.w + b.w;
  precise float maximum = lineRest * 1.95f * exactReciprocal(max(weight, 1e-20f));
  float held = clamp(multiplier, -maximum, maximum);
  precise vec3 pull = link.along * held;
  return pull;
}

// Returns the pull of link k of a line that conserves energy. The matrix B changes when the links turn, so the gradient
// of 1/2 C^T B^-1 C has the additional term -1/2 l^T dB l, where l are the multipliers.
FUNCTION vec3 keptPull(int k, float multiplierBefore, float multiplier, float multiplierAfter) {
  vec4 a = lineParticle(k), b = lineParticle(k + 1);
  Link before = linkBetween(lineParticle(max(k - 1, 0)), a, k > 0);
  Link here = linkBetween(a, b, true);
  Link after = linkBetween(b, lineParticle(min(k + 2, lineLinks)), k + 1 < lineLinks);
  precise vec3 turnBefore = before.along - here.along * exactDot(before.along, here.along);
  precise vec3 turnAfter = after.along - here.along * exactDot(after.along, here.along);
  precise float whole = here.stretch + lineRest;
  precise float minimum = lineRest * 0.125f;
  float length_ = max(whole, minimum);
  precise float share = multiplier * lineSoftening * exactReciprocal(length_);
  precise float weightBefore = multiplierBefore * a.w;
  precise float weightAfter = multiplierAfter * b.w;
  precise vec3 turn = turnBefore * weightBefore + turnAfter * weightAfter;
  precise vec3 pull = pullBetween(a, b, true, multiplier) - turn * share;
  return pull;
}

FUNCTION vec3 sped(vec3 velocity, float inverseMass, vec3 before, vec3 after) {
  precise vec3 v = velocity + (before - after) * (inverseMass * stepData.perDt);
  return v;
}

FUNCTION vec4 pulled(vec4 here, vec3 before, vec3 after) {
  precise vec3 moved = vec3(here) + (before - after) * here.w;
  return vec4(moved, here.w);
}
