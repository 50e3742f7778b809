// Constraints that are relaxed pair by pair, a family after the other, each in two colours that keep pairs apart: the
// diagonal ones, from where the particles would go, or those of BENDS along both axes, from what is left by these. A group has a
// tile of the sheet in shared memory and leaves the middle of it (relax_tile.glsl), so none waits for another between colours.
// Pairs of bending are loaded by the invocations that relax them by their first colour and stored by those of the last one. Diagonal
// ones, which lie in every second column there, would come and go more slowly than particles side by side.
#include "cloth/kernel.glsl"
#include "cloth/relax_tile.glsl"
layout(local_size_x = relaxTileX / 2, local_size_y = relaxTileY) in;
INPUT_ARRAY(positionsBinding, PositionBlock, positions)  // BENDS: what the diagonal ones left
STATE_ARRAY(nextPositionsBinding, NextBlock, nextPositions)
#ifndef BENDS
INPUT_ARRAY(velocitiesBinding, VelocityBlock, velocities)
INPUT_ARRAY(trendsBinding, TrendBlock, trends)
STATE_ARRAY(aimsBinding, AimBlock, aims)
#endif

vec4 loadPosition(int i) {
  return LOAD_INPUT(positions, i);
}
#include "cloth/model.glsl"

shared vec4 tile[relaxTileX * relaxTileY];
ivec2 corner = ivec2(0);  // of the tile in the sheet: both even, and multiples of four along which pairs reach two
const int half_ = relaxTileX / 2;
#ifdef BENDS
const int pace = 2, kind = 2, halo = relaxBendHalo;
const ivec2 first = ivec2(2, 0), second = ivec2(0, 2);
#else
const int pace = 1, kind = 1, halo = relaxDiagonalHalo;
const ivec2 first = ivec2(1, 1), second = ivec2(-1, 1);
#endif

// Even columns, then odd ones: a colour's pairs then are neighbours in memory, too.
int place(ivec2 within) {
  return within.y * relaxTileX + (within.x & 1) * half_ + within.x / 2;
}

// Of the sheet.
int indexOf(ivec2 within) {
  return (corner.y + within.y) * size.x + corner.x + within.x;
}

// In the tile and in the sheet.
bool isInside(ivec2 within) {
  ivec2 at = corner + within;
  bool inTile = within.x >= 0 && within.y >= 0 && within.x < relaxTileX && within.y < relaxTileY;
  return inTile && at.x >= 0 && at.y >= 0 && at.x < size.x && at.y < size.y;
}

// What the group leaves.
bool isOwn(ivec2 within) {
  ivec2 end = ivec2(relaxTileX, relaxTileY) - halo;
  return within.x >= halo && within.y >= halo && within.x < end.x && within.y < end.y && isInside(within);
}

ivec2 nearestInside(ivec2 within) {
  return clamp(corner + within, ivec2(0), size - 1) - corner;
}

// Both ends of a pair are inside.
void relax(inout vec4 a, inout vec4 b, ivec2 from, ivec2 to) {
  float kept = 0.0f;
#if DAMPED
  // At the substep's beginning. Only fabrics are damped, and have no constraints of bending.
  kept = keptStretch(loadPosition(indexOf(from)), loadPosition(indexOf(to)), springLength(kind));
#endif
  vec3 shift = constraintShift(a, b, springLength(kind), scaledCompliance(kind), kept);
  precise vec3 newA = a.xyz - shift * a.w;
  precise vec3 newB = b.xyz + shift * b.w;
  a.xyz = newA;
  b.xyz = newB;
}

void relaxInTile(ivec2 from, ivec2 reach) {
  ivec2 to = from + reach;
  if (!isInside(from) || !isInside(to)) return;
  int i = place(from), j = place(to);
  vec4 a = tile[i], b = tile[j];
  relax(a, b, from, to);
  tile[i] = a;
  tile[j] = b;
}

// The i-th number of those whose multiple of `pace` is even (color 0) or odd.
int numbered(int i, int color) {
  return (i / pace * 2 + color) * pace + i % pace;
}

// Where the invocation's pair of a colour begins, of the first family and of the second one.
ivec2 firstPair(int color) {
  ivec2 me = ivec2(gl_LocalInvocationID.xy);
  return ivec2(numbered(me.x, color), me.y);
}
ivec2 secondPair(int color) {
  ivec2 me = ivec2(gl_LocalInvocationID.xy);
  return ivec2(me.x + me.y % 2 * half_, numbered(me.y / 2, color));  // a row of pairs by halves
}

#ifdef BENDS
// With the first colour done.
void fill() {
  ivec2 from = firstPair(0), to = from + first;
  vec4 a = loadPosition(indexOf(nearestInside(from))), b = loadPosition(indexOf(nearestInside(to)));
  if (isInside(from) && isInside(to)) relax(a, b, from, to);
  tile[place(from)] = a;
  tile[place(to)] = b;
}

// With the last colour done.
void leave() {
  ivec2 from = secondPair(1), to = from + second;
  bool there = isInside(from), beyond = isInside(to);
  vec4 a = vec4(0.0f), b = vec4(0.0f);
  if (there) a = tile[place(from)];
  if (beyond) b = tile[place(to)];
  if (there && beyond) relax(a, b, from, to);
  if (isOwn(from)) STORE_STATE(nextPositions, indexOf(from), a);
  if (isOwn(to)) STORE_STATE(nextPositions, indexOf(to), b);
}
#else
// All loads first, so that none waits for another.
void fill() {
  ivec2 within = ivec2(gl_LocalInvocationID.xy), other = within + ivec2(half_, 0);
  ivec2 a = nearestInside(within), b = nearestInside(other);
  int i = indexOf(a), j = indexOf(b);
  vec4 here = loadPosition(i), there = loadPosition(j);
  vec4 velocity = LOAD_INPUT(velocities, i), otherVelocity = LOAD_INPUT(velocities, j);
  vec4 trend = LOAD_INPUT(trends, i), otherTrend = LOAD_INPUT(trends, j);
  Motion m = advance(corner + a, here, velocity, trend.xyz, false, AIR == 1, FABRIC == 1, false, false, false);
  Motion n = advance(corner + b, there, otherVelocity, otherTrend.xyz, false, AIR == 1, FABRIC == 1, false, false, false);
  tile[place(within)] = vec4(m.position, here.w);
  tile[place(other)] = vec4(n.position, there.w);
  if (isOwn(within)) STORE_STATE(aims, i, vec4(m.velocity, velocity.w));
  if (isOwn(other)) STORE_STATE(aims, j, vec4(n.velocity, otherVelocity.w));
  barrier();
  relaxInTile(firstPair(0), first);
}

void leave() {
  relaxInTile(secondPair(1), second);
  barrier();
  ivec2 within = ivec2(gl_LocalInvocationID.xy), other = within + ivec2(half_, 0);
  if (isOwn(within)) STORE_STATE(nextPositions, indexOf(within), tile[place(within)]);
  if (isOwn(other)) STORE_STATE(nextPositions, indexOf(other), tile[place(other)]);
}
#endif

void main() {
  corner = ivec2(gl_WorkGroupID.xy) * (ivec2(relaxTileX, relaxTileY) - 2 * halo) - relaxBefore;
  fill();
  barrier();
  relaxInTile(firstPair(1), first);
  barrier();
  relaxInTile(secondPair(0), second);
  barrier();
  leave();
}
