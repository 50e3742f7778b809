// Solves one family of XPBD constraints, both colours, for devices with slow stores (software drivers). The pairs of a
// family link the particles into lines; one invocation processes one line. It moves along the line and solves each pair
// of the second colour as soon as both adjacent pairs of the first colour are solved, so each particle is loaded and
// stored only once. FIRST is defined for the first family; it starts from the prediction of step.comp, computed here
// with the same bits.
#include "cloth/kernel.glsl"
layout(local_size_x = 8) in;
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
STATE_ARRAY(nextPositionsBinding, NextBlock, nextPositions)
#ifdef FIRST
INPUT_ARRAY(velocitiesBinding, VelocityBlock, velocities)
INPUT_ARRAY(trendsBinding, TrendBlock, trends)
STATE_ARRAY(aimsBinding, AimBlock, aims)
#endif
uniform ivec2 reach;  // Offset from one end of a pair to the other, in particles
uniform int kind;     // Kind of link: 0 structural, 1 shear, 2 bending
uniform int lines;

vec4 loadPosition(int i) {
  return LOAD_INPUT(positions, i);
}
#include "cloth/model.glsl"

vec4 taken(ivec2 at, int i) {
#ifdef FIRST
  vec4 here = loadPosition(i);
  vec4 velocity = LOAD_INPUT(velocities, i);
  Motion m = advance(at, here, velocity, LOAD_INPUT(trends, i).xyz, false, AIR == 1, FABRIC == 1, false, false, false);
  if (isLost(m)) noteLost(uint(stepData.substep), uint(i));
  STORE_STATE(aims, i, vec4(m.velocity, velocity.w));
  return vec4(m.position, here.w);
#else
  return LOAD_ONCE(nextPositions, i);
#endif
}

void leave(int i, vec4 here) {
  STORE_STATE(nextPositions, i, here);
}

void relax(inout vec4 a, inout vec4 b, int i, int j, float restLength, float compliance) {
  float kept = 0.0f;
#if DAMPED
  kept = keptStretch(loadPosition(i), loadPosition(j), restLength);
#endif
  vec3 shift = constraintShift(a, b, restLength, compliance, kept);
  precise vec3 newA = a.xyz - shift * a.w;
  precise vec3 newB = b.xyz + shift * b.w;
  a.xyz = newA;
  b.xyz = newB;
}

// Returns the first particle of a line: the particle that has no neighbour at the offset -reach.
ivec2 beginning(int line) {
  if (reach.y == 0) return ivec2(line % reach.x, line / reach.x);
  if (reach.x == 0) return ivec2(line % size.x, line / size.x);
  return line < size.x ? ivec2(line, 0) : ivec2(reach.x > 0 ? 0 : size.x - 1, line - size.x + 1);
}

int particlesFrom(ivec2 at) {
  int across = reach.x > 0 ? (size.x - 1 - at.x) / reach.x : at.x / max(-reach.x, 1);
  int down = (size.y - 1 - at.y) / max(reach.y, 1);
  return (reach.x == 0 ? down : reach.y == 0 ? across : min(across, down)) + 1;
}

void main() {
  int line = int(gl_GlobalInvocationID.x);
  if (line >= lines) return;
  ivec2 at = beginning(line);
  int count = particlesFrom(at);
  int place = at.y * size.x + at.x;
  int pace = reach.y * size.x + reach.x;
  float restLength = springLength(kind);
  float compliance = scaledCompliance(kind);
  // If the first pair has the second colour, its left particle must wait until its right particle has been solved in a
  // pair of the first colour.
  bool second = ((reach.x > 0 ? at.x / reach.x : at.y / reach.y) & 1) == 1;
  vec4 waiting = vec4(0);
  int k = 0;
  if (second) {
    waiting = taken(at, place);
    k = 1;
  }
  for (; k < count; k += 2) {
    int here = place + k * pace;
    vec4 a = taken(at + k * reach, here);
    vec4 b = vec4(0);
    if (k + 1 < count) {
      b = taken(at + k * reach + reach, here + pace);
      relax(a, b, here, here + pace, restLength, compliance);
    }
    if (k > 0) {
      relax(waiting, a, here - pace, here, restLength, compliance);
      leave(here - pace, waiting);
    }
    leave(here, a);
    waiting = b;
  }
  if (k == count) leave(place + (count - 1) * pace, waiting);
}
