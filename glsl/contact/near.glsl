// Closest points of a vertex and a face, and of two edges: barycentric weights, normal, distance. Compiles as GLSL and
// as C++ as part of model.glsl.

// Returns the barycentric weights of the point of a triangle that is closest to p (Ericson, Real-Time Collision
// Detection, 5.1.5). Ericson uses the first matching region; here, the tests run in reverse order, so that the last
// assignment is used.
FUNCTION vec3 closestOnTriangle(vec3 p, vec3 a, vec3 b, vec3 c) {
  precise vec3 ab = b - a;
  precise vec3 ac = c - a;
  precise vec3 ap = p - a;
  precise vec3 bp = p - b;
  precise vec3 cp = p - c;
  float d1 = exactDot(ab, ap), d2 = exactDot(ac, ap), d3 = exactDot(ab, bp), d4 = exactDot(ac, bp), d5 = exactDot(ab, cp),
        d6 = exactDot(ac, cp);
  precise float va = d3 * d6 - d5 * d4;
  precise float vb = d5 * d2 - d1 * d6;
  precise float vc = d1 * d4 - d3 * d2;
  precise float area = va + vb + vc;
  precise vec3 shares = vec3(va, vb, vc) * exactReciprocal(max(area, 1e-30f));
  precise float toC = d4 - d3;
  precise float toB = d5 - d6;
  precise float bc = toC + toB;
  precise float t = toC * exactReciprocal(max(bc, 1e-30f));
  precise vec3 onBC = vec3(0.0f, 1.0f - t, t);
  shares = va <= 0.0f && toC >= 0.0f && toB >= 0.0f ? onBC : shares;
  precise float acac = d2 - d6;
  precise float u = d2 * exactReciprocal(max(acac, 1e-30f));
  precise vec3 onAC = vec3(1.0f - u, 0.0f, u);
  shares = vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f ? onAC : shares;
  shares = d6 >= 0.0f && d5 <= d6 ? vec3(0.0f, 0.0f, 1.0f) : shares;
  precise float abab = d1 - d3;
  precise float v = d1 * exactReciprocal(max(abab, 1e-30f));
  precise vec3 onAB = vec3(1.0f - v, v, 0.0f);
  shares = vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f ? onAB : shares;
  shares = d3 >= 0.0f && d4 <= d3 ? vec3(0.0f, 1.0f, 0.0f) : shares;
  shares = d1 <= 0.0f && d2 <= 0.0f ? vec3(1.0f, 0.0f, 0.0f) : shares;
  return shares;
}

// Returns the parameters (0 to 1) of the closest points on the segments a-b and c-d (Ericson, 5.1.9).
FUNCTION vec2 closestOfEdges(vec3 a, vec3 b, vec3 c, vec3 d) {
  precise vec3 along = b - a;
  precise vec3 other = d - c;
  precise vec3 between = a - c;
  float aa = exactDot(along, along), ee = exactDot(other, other), ff = exactDot(other, between), cc = exactDot(along, between),
        bb = exactDot(along, other);
  precise float slope = aa * ee - bb * bb;
  precise float parallel = aa * ee * 1e-6f;
  precise float s = (bb * ff - cc * ee) * exactReciprocal(max(slope, 1e-30f));
  s = slope <= parallel ? 0.5f : clamp(s, 0.0f, 1.0f);
  precise float t = (bb * s + ff) * exactReciprocal(max(ee, 1e-30f));
  float held = clamp(t, 0.0f, 1.0f);
  precise float again = (bb * held - cc) * exactReciprocal(max(aa, 1e-30f));
  s = held == t ? s : clamp(again, 0.0f, 1.0f);
  return vec2(s, held);
}

FUNCTION vec3 weighted(vec4 shares, vec3 a, vec3 b, vec3 c, vec3 d) {
  precise vec3 sum = a * shares.x + b * shares.y + c * shares.z + d * shares.w;
  return sum;
}

// Builds a Near. `across` is the normal of the face or the common normal of both edges, or zero if a closest point is
// on a border. It is accurate at any distance, whereas the vector between very close points would consist of rounding
// errors.
FUNCTION Near nearOf(ivec4 corners, vec4 shares, vec3 separation, vec3 across) {
  float squared = exactDot(separation, separation), size = exactDot(across, across);
  float inverse = exactInverseSqrt(max(squared, 1e-24f));
  precise vec3 direct = separation * inverse;
  precise vec3 unit = across * exactInverseSqrt(max(size, 1e-24f));
  float side = exactDot(unit, separation);
  bool has = size > 1e-24f;
  precise float distance = has ? abs(side) : squared * inverse;
  vec3 normal = has ? (side < 0.0f ? -unit : unit) : direct;
  Near near;
  near.corners = corners;
  near.shares = shares;
  near.normal = squared < 1e-18f ? vec4(0.0f) : vec4(normal, distance);
  return near;
}
FUNCTION Near nearOfVertex(ivec4 corners, vec3 p, vec3 a, vec3 b, vec3 c) {
  vec3 shares = closestOnTriangle(p, a, b, c);
  precise vec3 ab = b - a;
  precise vec3 ac = c - a;
  precise vec3 ap = p - a;
  precise vec3 separation = ap - ab * shares.y - ac * shares.z;
  bool inside = shares.x > 0.0f && shares.y > 0.0f && shares.z > 0.0f;
  return nearOf(corners, vec4(1.0f, -shares.x, -shares.y, -shares.z), separation, inside ? exactCross(ab, ac) : vec3(0.0f));
}
FUNCTION Near nearOfEdges(ivec4 corners, vec3 a, vec3 b, vec3 c, vec3 d) {
  vec2 at = closestOfEdges(a, b, c, d);
  precise vec3 along = b - a;
  precise vec3 other = d - c;
  precise vec3 between = a - c;
  precise vec3 separation = between + along * at.x - other * at.y;
  precise float fromA = 1.0f - at.x;
  precise float fromC = at.y - 1.0f;
  bool inside = at.x > 0.0f && at.x < 1.0f && at.y > 0.0f && at.y < 1.0f;
  float size = exactDot(along, along), otherSize = exactDot(other, other);
  vec3 across = exactCross(along, other);
  precise float parallel = size * otherSize * 1e-6f;
  inside = inside && exactDot(across, across) > parallel;
  return nearOf(ivec4(corners.x, ~corners.y, corners.z, corners.w), vec4(fromA, at.x, fromC, -at.y), separation,
                inside ? across : vec3(0.0f));
}

FUNCTION bool isOfEdges(Near near) {
  return near.corners.y < 0;
}
FUNCTION ivec4 cornersOf(Near near) {
  return ivec4(near.corners.x, isOfEdges(near) ? ~near.corners.y : near.corners.y, near.corners.z, near.corners.w);
}
