// Access to the list of near pairs. Each invocation processes one pair.
layout(local_size_x = 64) in;
INPUT_WORDS(cornersBinding, CornerBlock, corners)
STATE_ARRAY(nearsBinding, NearBlock, nears)
layout(std430, binding = talliesBinding) restrict buffer TallyBlock { ivec4 tallies[]; };
// Loads a word of the tallies that an earlier dispatch wrote and this dispatch does not change.
#ifdef TEXEL_PATH
layout(binding = tallyTexelsBinding) uniform usamplerBuffer tallyTexels;
#define LOAD_TALLY(i) ivec4(texelFetch(tallyTexels, i))
#else
#define LOAD_TALLY(i) tallies[i]
#endif

int nearIndex() {
  return int(gl_GlobalInvocationID.x);
}
int nearsThere() {
  return min(int(control.nearCount), contactStep.maxPairs);
}
Near nearAt(int i) {
  Near near;
  near.corners = ivec4(LOAD_INPUT_WORDS(corners, i));
  near.shares = LOAD_ONCE(nears, 3 * i);
  near.normal = LOAD_ONCE(nears, 3 * i + 1);
  return near;
}
vec3 wayOf(int vertex) {
  precise vec3 way = pointAt(wantedSection, vertex).xyz - pointAt(nowSection, vertex).xyz;
  return way;
}
// Returns the displacement of a vertex from its position at the substep's start to its prediction without contact.
vec3 ledOf(int vertex) {
  precise vec3 way = pointAt(nextSection, vertex).xyz - pointAt(nowSection, vertex).xyz;
  return way;
}
// startOf() returns the position to which a vertex can be held back. wayFromStart() returns the displacement of the
// vertex from that position.
vec3 startOf(int vertex) {
  return pointAt(isSolid(vertex) || nothingCarried() ? nowSection : startSection, vertex).xyz;
}
vec3 wayFromStart(int vertex) {
  precise vec3 way = pointAt(wantedSection, vertex).xyz - startOf(vertex);
  return way;
}
int impulseTally(int vertex) {
  return impulseSection * contactStep.vertices + vertex;
}
int pathFractionTally(int vertex) {
  return letSection * contactStep.vertices + vertex;
}
