// A segment of a line, of links `first` to `last`. Compiles as GLSL and as C++, after line_model.glsl. Whoever includes it
// provides lineParticle(int), xyz and inverse mass of the k-th particle of the line, lineBefore(int), the same at the substep's
// beginning, lineSoftening, which weighs the masses of lines that keep energy (cloth/keeping.glsl; 1 of others), and, of the invocation, which arrays a
// compiler keeps where it is cheap: lineLower[segmentLinks + 1], lineMass[segmentLinks + 1], lineStretch[segmentLinks].

// How much of the stretch of link k is to be undone.
FUNCTION float undone(int k, float stretch) {
  float all = stretch;
  if (lineKept > 0.0f) {
    Link past = linkBetween(lineBefore(k), lineBefore(k + 1), true);
    precise float some = stretch - past.stretch * lineKept;
    all = some;
  }
  return all;
}

// Makes the row of every link of the segment: into lineLower what it has before the diagonal, which the row before has after it,
// into lineStretch the right side, and lineMass. How much longer than at rest all of them are together (m).
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

// How many particles of a segment that was read are pinned; its first one is the last of the segment before.
FUNCTION float pinsOf(int first, int links) {
  int pins = first == 0 && lineMass[0] == 0.0f ? 1 : 0;
  for (int i = 1; i <= links; ++i) pins = lineMass[i] == 0.0f ? pins + 1 : pins;
  return float(pins);
}

// giveOf of a line that keeps energy, of nothing that a substep changes, so that it still is a potential. A line between pins has a
// multiplier too many where it is straight, and what swings through there would meet a wall: it stretches by dt^2 / 4m a link and
// newton, at least. Held s of its length too far apart it pulls by m L / (6 softening dt^2) (w dt = 0.82 / sqrt(softening)).
FUNCTION float keptGive(float pins) {
  vec4 a = lineParticle(0), b = lineParticle(lineLinks);
  Link ends = linkBetween(a, b, true);
  precise float rest = float(lineLinks) * lineRest;
  precise float beyond = ends.stretch + lineRest - rest;
  precise float held = beyond * exactReciprocal(rest) * 3.0f;
  precise float least = exactReciprocal(lineSoftening) * 0.125f;
  bool ended = a.w == 0.0f && b.w == 0.0f;
  return pins < 2.0f ? 3.0517578125e-5f : ended ? max(held, least) : least;
}

// Of the i-th link of the segment.
FUNCTION LineRow segmentRow(int i) {
  return lineRow(lineLower[i], lineStretch[i], lineLower[i + 1], lineMass[i], lineMass[i + 1]);
}

// The first link of a segment by what is to the left of the segment and its last link.
FUNCTION Reach firstOfSegment(int links) {
  Reach reach = reachAtEnd();
  for (int i = links - 2; i >= 0; --i) reach = reachBack(segmentRow(i), reach);
  return reach;
}

// The last link of a segment by what is to the left of the segment and the link to its right. Leaves the pivots' reciprocals in
// lineMass, which is no longer needed: solveSegment has the same pivots.
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

// The multipliers of a segment between its separators, after lastOfSegment: into lineStretch, which is no longer needed.
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

// What the link from a to b does to a's position for each of its inverse mass, less; to b's, more. At most what is stable
// (giveOf), should a part of a line be held too far apart, or substeps be too few.
FUNCTION vec3 pullBetween(vec4 a, vec4 b, bool there, float multiplier) {
  Link link = linkBetween(a, b, there);
  precise float weight = a.w + b.w;
  precise float most = lineRest * 1.95f * exactReciprocal(max(weight, 1e-20f));
  float held = clamp(multiplier, -most, most);
  precise vec3 pull = link.along * held;
  return pull;
}

// The same of a line that keeps energy, of its link k between two others: B turns with the links, so that of the gradient of
// 1/2 C^T B^-1 C there is -1/2 l^T dB l, too.
FUNCTION vec3 keptPull(int k, float multiplierBefore, float multiplier, float multiplierAfter) {
  vec4 a = lineParticle(k), b = lineParticle(k + 1);
  Link before = linkBetween(lineParticle(max(k - 1, 0)), a, k > 0);
  Link here = linkBetween(a, b, true);
  Link after = linkBetween(b, lineParticle(min(k + 2, lineLinks)), k + 1 < lineLinks);
  precise vec3 turnBefore = before.along - here.along * exactDot(before.along, here.along);
  precise vec3 turnAfter = after.along - here.along * exactDot(after.along, here.along);
  precise float whole = here.stretch + lineRest;
  precise float least = lineRest * 0.125f;
  float length_ = max(whole, least);
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
