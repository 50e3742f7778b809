// Constraints that are relaxed pair by pair, a family after the other, each in two colours that keep pairs apart: the
// diagonal ones, from where the particles would go, or those of BENDS along both axes, from what is left by these. A group has a
// tile of the sheet in shared memory and leaves the middle of it (relax_tile.glsl), so none waits for another between colours.
#include "cloth/kernel.glsl"
#include "cloth/relax_tile.glsl"
layout(local_size_x = relaxGroupX, local_size_y = relaxGroupY) in;
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
const int rounds = relaxTileY / relaxGroupY;
const int half_ = relaxTileX / 2;

// Even columns, then odd ones: a colour's pairs then are neighbours in memory, too.
int place(int x, int y) {
  return y * relaxTileX + (x & 1) * half_ + x / 2;
}

bool isInside(ivec2 at) {
  return at.x >= 0 && at.y >= 0 && at.x < size.x && at.y < size.y;
}

// At the substep's beginning. Only fabrics are damped, and have no constraints of bending.
vec4 begun(ivec2 within) {
  return loadPosition((corner.y + within.y) * size.x + corner.x + within.x);
}

void relax(ivec2 from, ivec2 reach, int kind) {
  ivec2 to = from + reach;
  bool within = to.x >= 0 && to.x < relaxTileX && to.y < relaxTileY;
  if (!within || !isInside(corner + from) || !isInside(corner + to)) return;
  int i = place(from.x, from.y), j = place(to.x, to.y);
  vec4 a = tile[i], b = tile[j];
  float kept = 0.0f;
#if DAMPED
  kept = keptStretch(begun(from), begun(to), springLength(kind));
#endif
  vec3 shift = constraintShift(a, b, springLength(kind), scaledCompliance(kind), kept);
  precise vec3 newA = a.xyz - shift * a.w;
  precise vec3 newB = b.xyz + shift * b.w;
  tile[i] = vec4(newA, a.w);
  tile[j] = vec4(newB, b.w);
}

// The i-th number of those whose multiple of `pace` is even (color 0) or odd.
int numbered(int i, int pace, int color) {
  return (i / pace * 2 + color) * pace + i % pace;
}

bool isOwn(int x, int y) {
  return x >= relaxHalo && x < relaxTileX - relaxHalo && y >= relaxHalo && y < relaxTileY - relaxHalo;
}

vec4 taken(int x, int y) {
  ivec2 at = corner + ivec2(x, y);
  if (!isInside(at)) return vec4(0.0f);
  int i = at.y * size.x + at.x;
  vec4 here = loadPosition(i);
#ifdef BENDS
  return here;
#else
  vec4 velocity = LOAD_INPUT(velocities, i);
  Motion m = advance(at, here, velocity, LOAD_INPUT(trends, i).xyz, false, AIR, FABRIC, false, false, false);
  if (isOwn(x, y)) STORE_STATE(aims, i, vec4(m.velocity, velocity.w));
  return vec4(m.position, here.w);
#endif
}

void main() {
  ivec2 me = ivec2(gl_LocalInvocationID.xy);
  corner = ivec2(gl_WorkGroupID.xy) * ivec2(relaxInnerX, relaxInnerY) - relaxHalo;
  for (int r = 0; r < rounds; ++r) {
    int y = me.y + r * relaxGroupY;
    tile[place(me.x, y)] = taken(me.x, y);
    tile[place(me.x + half_, y)] = taken(me.x + half_, y);
  }
  barrier();
#ifdef BENDS
  const int pace = 2, kind = 2;
  const ivec2 first = ivec2(2, 0), second = ivec2(0, 2);
#else
  const int pace = 1, kind = 1;
  const ivec2 first = ivec2(1, 1), second = ivec2(-1, 1);
#endif
  for (int color = 0; color < 2; ++color) {
    int x = numbered(me.x, pace, color);
    for (int r = 0; r < rounds; ++r) relax(ivec2(x, me.y + r * relaxGroupY), first, kind);
    barrier();
  }
  for (int color = 0; color < 2; ++color) {
    for (int r = 0; r < rounds; ++r) {
      int t = me.y + r * relaxGroupY;  // a row of pairs by halves
      int y = numbered(t / 2, pace, color);
      relax(ivec2(me.x + t % 2 * half_, y), second, kind);
    }
    barrier();
  }
  for (int r = 0; r < rounds; ++r)
    for (int side = 0; side < 2; ++side) {
      int x = me.x + side * half_, y = me.y + r * relaxGroupY;
      ivec2 at = corner + ivec2(x, y);
      if (isOwn(x, y) && isInside(at)) STORE_STATE(nextPositions, at.y * size.x + at.x, tile[place(x, y)]);
    }
}
