// The multipliers of a segment between its separators: into lineOnto. Compiles as GLSL and as C++, after line_model.glsl;
// lineOnto and lineFrom are float[segmentLinks] of the invocation.
FUNCTION void solveSegment(int first, int last, float leftOne, float lastOne) {
  vec4 a = lineParticle(first);
  vec4 b = lineParticle(first + 1);
  Link before = linkBetween(lineParticle(max(first - 1, 0)), a, first > 0);
  Link here = linkBetween(a, b, true);
  Eliminated eliminated;
  eliminated.onto = leftOne;
  eliminated.from = 0.0f;
  for (int k = first; k < last; ++k) {
    vec4 c = lineParticle(k + 2);
    Link after = linkBetween(b, c, true);
    eliminated = eliminate(lineRow(k, before, here, after, a, b), eliminated);
    lineOnto[k - first] = eliminated.onto;
    lineFrom[k - first] = eliminated.from;
    a = b;
    b = c;
    before = here;
    here = after;
  }
  lineOnto[last - first] = lastOne;
  float after = lastOne;
  for (int k = last - first - 1; k >= 0; --k) {
    after = substituted(lineOnto[k], lineFrom[k], after);
    lineOnto[k] = after;
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

FUNCTION vec4 pulled(vec4 here, vec3 before, vec3 after) {
  precise vec3 moved = vec3(here) + (before - after) * here.w;
  return vec4(moved, here.w);
}
