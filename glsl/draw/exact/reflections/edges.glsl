// Edges of objects in the nearness of half pixels. Half pixels at an object's edge also show what is behind the object.
// Reflections therefore take the object's light from inside the edge. Compiles as GLSL and as C++.

// Returns how much a half pixel differs from its farther neighbours to the right and below (negative: to the left and
// above), relative to its nearness. The change of nearness towards the opposite neighbour and a part `allowed` of the
// nearness do not count. `around`: nearness to the left, to the right, above and below.
FUNCTION vec2 edgeAt(vec4 around, float here, float allowed) {
  vec4 opposite = vec4(around.y, around.x, around.w, around.z);
  precise vec4 farther = here - around;
  precise vec4 nearer = opposite - here;
  precise vec4 differs = max(farther, vec4(0.0f)) - max(nearer, vec4(0.0f)) - allowed * here;
  vec4 edge = max(differs, vec4(0.0f));
  precise vec2 change = vec2(edge.x - edge.y, edge.z - edge.w);
  precise vec2 part = change * exactReciprocal(max(here, 1e-9f));
  return part;
}

// Returns the way from a half pixel at an object's edge to the inside of the object, half a half pixel away from farther half
// pixels. The way is 0 where the change of nearness differs by less than 2% between both sides.
FUNCTION vec2 wayInwards(vec4 around, float here) {
  precise vec2 part = 24.0f * edgeAt(around, here, 0.02f);
  precise vec2 inwards = 0.5f * clamp(part, vec2(-1.0f), vec2(1.0f));
  return inwards;
}

// Returns the offset of the half pixel whose light is used for a half pixel. It is a neighbour inside the object if the
// half pixel is at the object's edge, and 0 otherwise.
FUNCTION ivec2 insideEdge(vec4 around, float here) {
  const float least = 0.002f;
  vec2 edge = edgeAt(around, here, 0.01f);
  return ivec2(edge.x > least ? 1 : edge.x < -least ? -1 : 0, edge.y > least ? 1 : edge.y < -least ? -1 : 0);
}

// Returns true if a neighbour shows the same object, which differs by less than 4% in nearness.
FUNCTION bool sameObject(float beside, float here) {
  precise float difference = here - beside;
  precise float maximum = 0.04f * here;
  return abs(difference) < maximum;
}

// Returns the light of a cell of the next level: the mean of four cells with the nearness `nears`. Objects behind the
// nearest one do not count, so that the blurred light of an object contains no light from behind it. Empty cells count as
// cells without light.
FUNCTION vec4 meanOfNearest(vec4 nears, vec4 a, vec4 b, vec4 c, vec4 d) {
  float near = max(max(nears.x, nears.y), max(nears.z, nears.w));
  vec4 counts = vec4(nears.x == 0.0f || sameObject(nears.x, near) ? 1.0f : 0.0f,
                     nears.y == 0.0f || sameObject(nears.y, near) ? 1.0f : 0.0f,
                     nears.z == 0.0f || sameObject(nears.z, near) ? 1.0f : 0.0f,
                     nears.w == 0.0f || sameObject(nears.w, near) ? 1.0f : 0.0f);
  precise float sum = (counts.x + counts.y) + (counts.z + counts.w);
  float perSum = sum > 3.5f ? 0.25f : sum > 2.5f ? 0.33333334f : sum > 1.5f ? 0.5f : 1.0f;
  precise vec4 mean = perSum * ((counts.x * a + counts.y * b) + (counts.z * c + counts.w * d));
  return mean;
}
