// Solves XPBD constraints pair by pair, one family after another, each in two colours whose pairs have no particle in
// common. Without BENDS, solves both diagonal families, starting from the predicted positions. With BENDS, solves the
// bending families along both axes, starting from the result of the diagonal families. A workgroup loads a tile of the
// sheet into shared memory and writes only the tile's interior (relax_tile.glsl), so the colours need no separate
// dispatches. With BENDS, each invocation loads the particles of its pair of the first colour and stores those of its
// pair of the last colour. Without BENDS, it loads and stores adjacent particles, because a colour's diagonal pairs lie
// in every second column and would be slower to access.
#include "cloth/kernel.glsl"
#include "cloth/relax_tile.glsl"
layout(local_size_x = relaxTileX / 2, local_size_y = relaxTileY) in;
INPUT_ARRAY(positionsBinding, PositionBlock, positions)  // With BENDS, this array holds the result of the diagonal
                                                         // families.
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
// Position of the tile's corner in the sheet. Both coordinates are even, and multiples of four for families with a
// reach of 2.
ivec2 corner = ivec2(0);
const int half_ = relaxTileX / 2;
#ifdef BENDS
const int pace = 2, kind = 2, halo = relaxBendHalo;
const ivec2 first = ivec2(2, 0), second = ivec2(0, 2);
#else
const int pace = 1, kind = 1, halo = relaxDiagonalHalo;
const ivec2 first = ivec2(1, 1), second = ivec2(-1, 1);
#endif

// Returns the index of a particle in the shared tile. Even columns come first, then odd columns, so that the pairs of a
// colour are adjacent in memory.
int place(ivec2 within) {
  return within.y * relaxTileX + (within.x & 1) * half_ + within.x / 2;
}

// Returns the index of a tile position in the sheet's arrays.
int indexOf(ivec2 within) {
  return (corner.y + within.y) * size.x + corner.x + within.x;
}

// Returns true if the position is both in the tile and in the sheet.
bool isInside(ivec2 within) {
  ivec2 at = corner + within;
  bool inTile = within.x >= 0 && within.y >= 0 && within.x < relaxTileX && within.y < relaxTileY;
  return inTile && at.x >= 0 && at.y >= 0 && at.x < size.x && at.y < size.y;
}

// Returns true if the workgroup writes this position: it is in the sheet, and in the tile without its halo.
bool isSuppliedByStage(ivec2 within) {
  ivec2 end = ivec2(relaxTileX, relaxTileY) - halo;
  return within.x >= halo && within.y >= halo && within.x < end.x && within.y < end.y && isInside(within);
}

ivec2 nearestInside(ivec2 within) {
  return clamp(corner + within, ivec2(0), size - 1) - corner;
}

// Solves one pair. isInside() must be true for both ends.
void relax(inout vec4 a, inout vec4 b, ivec2 from, ivec2 to) {
  float kept = 0.0f;
#if DAMPED
  // `kept` is computed from the stretch at the start of the substep. Only fabrics are damped, and fabrics have no
  // bending constraints.
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

// Returns the i-th of the numbers n for which n / pace is even (color 0) or odd (color 1).
int numbered(int i, int color) {
  return (i / pace * 2 + color) * pace + i % pace;
}

// firstPair() and secondPair() return the first particle of this invocation's pair of a colour, in the first and in the
// second family.
ivec2 firstPair(int color) {
  ivec2 me = ivec2(gl_LocalInvocationID.xy);
  return ivec2(numbered(me.x, color), me.y);
}
ivec2 secondPair(int color) {
  ivec2 me = ivec2(gl_LocalInvocationID.xy);
  // The two halves of a row of invocations process two different rows of pairs.
  return ivec2(me.x + me.y % 2 * half_, numbered(me.y / 2, color));
}

#ifdef BENDS
// Loads the tile and solves the first colour.
void fill() {
  ivec2 from = firstPair(0), to = from + first;
  vec4 a = loadPosition(indexOf(nearestInside(from))), b = loadPosition(indexOf(nearestInside(to)));
  if (isInside(from) && isInside(to)) relax(a, b, from, to);
  tile[place(from)] = a;
  tile[place(to)] = b;
}

// Solves the last colour and stores the results.
void leave() {
  ivec2 from = secondPair(1), to = from + second;
  bool there = isInside(from), beyond = isInside(to);
  vec4 a = vec4(0.0f), b = vec4(0.0f);
  if (there) a = tile[place(from)];
  if (beyond) b = tile[place(to)];
  if (there && beyond) relax(a, b, from, to);
  if (isSuppliedByStage(from)) STORE_STATE(nextPositions, indexOf(from), a);
  if (isSuppliedByStage(to)) STORE_STATE(nextPositions, indexOf(to), b);
}
#else
// All loads are issued first, so that they overlap.
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
  if (isSuppliedByStage(within)) STORE_STATE(aims, i, vec4(m.velocity, velocity.w));
  if (isSuppliedByStage(other)) STORE_STATE(aims, j, vec4(n.velocity, otherVelocity.w));
  barrier();
  relaxInTile(firstPair(0), first);
}

void leave() {
  relaxInTile(secondPair(1), second);
  barrier();
  ivec2 within = ivec2(gl_LocalInvocationID.xy), other = within + ivec2(half_, 0);
  if (isSuppliedByStage(within)) STORE_STATE(nextPositions, indexOf(within), tile[place(within)]);
  if (isSuppliedByStage(other)) STORE_STATE(nextPositions, indexOf(other), tile[place(other)]);
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
