// Solves the structural constraints of all rows (if ROWS is set) or all columns together (line_model.glsl). A workgroup
// has LINES lines of SEGMENTS segments; one invocation solves one segment. If LAST is defined, also computes the final
// positions and velocities of the substep. If KEEPS is defined, uses the positions at the start of the substep, so that
// rows and columns are independent of each other.
#include "cloth/kernel.glsl"
layout(local_size_x = LINES, local_size_y = SEGMENTS) in;
#if defined(LAST) || DAMPED || KEEPS
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
#endif
#if defined(LAST) || KEEPS
STATE_ARRAY(velocitiesBinding, VelocityBlock, velocities)  // On input: velocities after forces alone
#endif
#if defined(LAST) && !KEEPS
STATE_ARRAY(trendsBinding, TrendBlock, trends)
#endif
STATE_ARRAY(nextPositionsBinding, NextBlock, nextPositions)
uniform int lines;
int lineLinks = 0, lineStart = 0, linePace = 1;
float lineRest = 0.0f, lineCompliance = 0.0f, lineGive = 0.0f, lineKept = 0.0f, lineSoftening = 1.0f;

vec4 loadPosition(int i) {
#ifdef LAST
  return LOAD_INPUT(positions, i);
#else
  return LOAD_ONCE(nextPositions, i);
#endif
}
#include "cloth/model.glsl"

vec4 lineParticle(int k) {
#if KEEPS
  return LOAD_INPUT(positions, lineStart + k * linePace);
#else
  return LOAD_ONCE(nextPositions, lineStart + k * linePace);
#endif
}
vec4 lineBefore(int k) {
#if DAMPED
  return LOAD_INPUT(positions, lineStart + k * linePace);
#else
  return vec4(0.0f);
#endif
}
#include "cloth/line_model.glsl"
float lineLower[segmentLinks + 1], lineMass[segmentLinks + 1], lineStretch[segmentLinks];
#include "cloth/segment.glsl"

// For each segment, `separators` first holds the sum of the stretches (with KEEPS, the number of pinned particles),
// then the separator's row, then the separator's multiplier in x. The arrays first* hold the Reach of the segment's
// first link.
shared vec4 separators[SEGMENTS * LINES];
shared float firstFixed[SEGMENTS * LINES], firstLeft[SEGMENTS * LINES], firstRight[SEGMENTS * LINES];

#if KEEPS
void leaveKept(int k, vec3 pullBefore, vec3 pull) {
  int i = lineStart + k * linePace;
  vec4 before = lineParticle(k), velocity = LOAD_ONCE(velocities, i);
  vec3 v = sped(velocity.xyz, before.w, pullBefore, pull);
#ifdef LAST
  vec4 here = LOAD_ONCE(nextPositions, i);
  Motion m = forced(before, here, v, HEIGHTS == 1, WALLS == 1);
  if (isLost(m)) noteLost(uint(stepData.substep), uint(i));
  STORE_STATE(nextPositions, i, vec4(m.position, here.w));
  v = m.velocity;
#endif
  STORE_STATE(velocities, i, vec4(v, velocity.w));
}

// Applies the pulls of the segment's links, and of the link before the segment, to the segment's particles. The
// adjacent segments have stored multipliers in shared memory: firstFixed holds the first multiplier of a segment,
// firstLeft the multiplier before its last one.
void leaveSegment(int segment, int segments, int first, int last, int me, float leftOne) {
  float beyond = segment + 1 < segments ? firstFixed[me + LINES] : 0.0f;
  float before = leftOne;
  vec3 pullBefore = vec3(0.0f);
  if (segment > 0) pullBefore = keptPull(first - 1, firstLeft[me - LINES], leftOne, lineStretch[0]);
  for (int k = first; k <= last; ++k) {
    float one = lineStretch[k - first], after = beyond;
    if (k < last) after = lineStretch[k - first + 1];
    vec3 pull = keptPull(k, before, one, after);
    leaveKept(k, pullBefore, pull);
    pullBefore = pull;
    before = one;
  }
  if (segment == segments - 1) leaveKept(lineLinks, pullBefore, vec3(0.0f));
}
#else
void leave(int k, vec4 here) {
  int i = lineStart + k * linePace;
#ifdef LAST
  vec4 velocity = LOAD_ONCE(velocities, i), trend = LOAD_ONCE(trends, i);
  Settled s = settled(loadPosition(i), here, velocity.xyz, trend.xyz, HEIGHTS == 1, WALLS == 1);
  Motion m = s.motion;
  if (isLost(m)) noteLost(uint(stepData.substep), uint(i));
  STORE_STATE(trends, i, vec4(s.trend, 0.0f));
  STORE_STATE(nextPositions, i, vec4(m.position, here.w));
  STORE_STATE(velocities, i, vec4(m.velocity, velocity.w));
#else
  STORE_STATE(nextPositions, i, here);
#endif
}
#endif

// Solves the system of separators of one line of the workgroup and writes the multipliers to separators[].x. The values
// for the next iteration are loaded early, to hide the load latency.
void solveSeparators(int slot, int segments) {
  Eliminated eliminated = Eliminated(0.0f, 0.0f);
  vec4 row = separators[slot];
  for (int s = 0; s < segments; ++s) {
    int i = s * LINES + slot;
    vec4 next = separators[min(s + 1, segments - 1) * LINES + slot];
    eliminated = eliminate(LineRow(row.x, row.y, row.z, row.w), eliminated);
    separators[i].xy = vec2(eliminated.onto, eliminated.from);
    row = next;
  }
  float after = 0.0f;
  for (int s = segments - 1; s >= 0; --s) {
    int i = s * LINES + slot, j = max(s - 1, 0) * LINES + slot;
    vec2 next = separators[j].xy;
    after = substituted(eliminated.onto, eliminated.from, after);
    separators[i].x = after;
    eliminated = Eliminated(next.x, next.y);
  }
}

void main() {
  int slot = int(gl_LocalInvocationID.x), segment = int(gl_LocalInvocationID.y), me = segment * LINES + slot;
  int line = int(gl_WorkGroupID.x) * LINES + slot;
#ifdef ROWS
  lineLinks = size.x - 1;
  lineStart = line * size.x;
  linePace = 1;
#else
  lineLinks = size.y - 1;
  lineStart = line;
  linePace = size.x;
#endif
  lineRest = springLength(0);
#if DAMPED
  lineKept = stepData.dampedPart;
#endif
#if KEEPS
  lineSoftening = stepData.softening;
#endif
#ifdef ROWS
  lineCompliance = FABRIC == 1 ? fabricCompliance(true, line) : scaledCompliance(0);
#else
  lineCompliance = FABRIC == 1 ? fabricCompliance(false, line) : scaledCompliance(0);
#endif
  int segments = (lineLinks + segmentLinks - 1) / segmentLinks;
  int first = segment * segmentLinks, last = min(first + segmentLinks, lineLinks) - 1;
  int links = last - first + 1;
  bool mine = line < lines && segment < segments;
  if (mine) separators[me].x = readSegment(first, last);
#if KEEPS
  if (mine) separators[me].x = pinsOf(first, links);
#endif
  barrier();
  if (mine && segment == 0) {
    precise float sum = 0.0f;
    for (int s = 0; s < segments; ++s) sum = sum + separators[s * LINES + slot].x;
    bool pinned = lineParticle(0).w == 0.0f && lineParticle(lineLinks).w == 0.0f;
#if KEEPS
    firstFixed[slot] = minCompliance(sum);
#else
    firstFixed[slot] = edgeComplianceOf(sum, pinned);
#endif
  }
  barrier();
  if (mine) lineGive = firstFixed[slot];
  barrier();
  Reach end = reachAtStart();
  if (mine) {
    Reach begin = firstOfSegment(links);
    end = lastOfSegment(links);
    firstFixed[me] = begin.fixed_;
    firstLeft[me] = begin.left;
    firstRight[me] = begin.right;
  }
  barrier();
  if (mine) {
    Reach next = Reach(0.0f, 0.0f, 0.0f);
    if (segment + 1 < segments) next = Reach(firstFixed[me + LINES], firstLeft[me + LINES], firstRight[me + LINES]);
    LineRow row = separatorRow(end, next);
    separators[me] = vec4(row.lower, row.diagonal, row.upper, row.right);
  }
  barrier();
  if (mine && segment == 0) solveSeparators(slot, segments);
  barrier();
  vec4 before = vec4(0.0f), beyond = vec4(0.0f);
  float leftOne = 0.0f;
  if (mine) {
    if (segment > 0) leftOne = separators[me - LINES].x;
    solveSegment(links, leftOne, separators[me].x);
    // The particles of adjacent segments are loaded before the barrier, because the neighbours move them after it.
    before = LOAD_STATE(nextPositions, lineStart + max(first - 1, 0) * linePace);
    beyond = LOAD_STATE(nextPositions, lineStart + (last + 1) * linePace);
  }
#if KEEPS
  if (mine) {
    firstFixed[me] = lineStretch[0];
    firstLeft[me] = links > 1 ? lineStretch[links - 2] : leftOne;
  }
#endif
  barrier();  // After this barrier, the adjacent segments move their particles.
  if (!mine) return;
#if KEEPS
  leaveSegment(segment, segments, first, last, me, leftOne);
#else
  vec4 here = lineParticle(first);
  vec3 pullBefore = pullBetween(before, here, first > 0, leftOne);
  for (int k = first; k <= last; ++k) {
    vec4 next = beyond;
    if (k < last) next = lineParticle(k + 1);
    vec3 pull = pullBetween(here, next, true, lineStretch[k - first]);
    leave(k, pulled(here, pullBefore, pull));
    here = next;
    pullBefore = pull;
  }
  if (segment == segments - 1) leave(lineLinks, pulled(here, pullBefore, vec3(0.0f)));
#endif
}
