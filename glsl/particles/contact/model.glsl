// Contact of particles as balls: the grid of cells in which pairs are searched, and the overlap of a pair. Compiles as
// GLSL and as C++ (the CPU twin of the tests). The including file provides `stepData` (ParticleStep), common/exact.glsl
// and common/hash.glsl.

// Returns a ball's radius in metres. It grows with the mass like the drawn size.
FUNCTION float ballRadius(float mass) {
  precise float radius = stepData.balls.radius * ballScale(mass);
  return radius;
}

// Returns the factor on the radius of a ball of emitter e, where e is -1 for a ball of a group. Balls are born with a
// twentieth of their radius and grow within a quarter of a second, because balls that are born inside each other would
// otherwise be thrown apart. `age` is the age as a fraction of the lifetime.
FUNCTION float ballGrowth(int e, float age) {
  if (e < 0) return 1.0f;
  precise float grown = age * stepData.emitters[e].constants.lifetime * 4.0f + 0.05f;
  return min(grown, 1.0f);
}

// Returns the number by which the inverse mass of a ball with n contacts is multiplied, so that the contacts share the
// ball's mass. Jacobi iterations in which all contacts have equal shares (factor n) always converge, but slowly. The
// factor 1 + 0.3 (n - 1) is faster and was stable in all heaps that were tried.
FUNCTION float ballShare(int contacts) {
  precise float share = float(max(contacts, 1) - 1) * 0.3f + 1.0f;
  return share;
}

// Returns the cell of a point. Cells are wide enough that touching balls are in neighbouring cells.
FUNCTION ivec3 ballCell(vec3 p) {
  precise vec3 scaled = p * stepData.balls.perCell;
  vec3 cell = clamp(floor(scaled), -1e9f, 1e9f);
  return ivec3(int(cell.x), int(cell.y), int(cell.z));
}

// Returns the bucket of a cell in the table. Several cells may have the same bucket. The last bucket is reserved for
// slots without a living particle.
FUNCTION uint ballBucket(ivec3 cell) {
  uint mask = uint(stepData.balls.tableMask);
  uint bucket = hash3(uvec3(uint(cell.x), uint(cell.y), uint(cell.z))).x & mask;
  return min(bucket, mask - 1u);
}

// Returns the offset, in cells, to one of the 27 cells around a cell, including the cell itself. `around` is 0 to 26.
FUNCTION ivec3 ballNextCell(int around) {
  return ivec3(around % 3 - 1, around / 3 % 3 - 1, around / 9 - 1);
}

// Returns 2 for balls that touch or nearly touch, 1 for balls that may touch within the substep, otherwise 0.
FUNCTION int ballsNear(vec3 a, vec3 b, float reach) {
  precise vec3 separation = a - b;
  float squared = exactDot(separation, separation);
  precise float squaredReach = reach * reach;
  precise float wide = squaredReach * 1.1025f;  // 1.1025 is 1.05 squared
  precise float touch = squaredReach * 1.0201f;
  return squared < touch ? 2 : squared < wide ? 1 : 0;
}

// State of a ball in a substep.
struct Ball {
  vec4 place;  // xyz position, m; w number of contacts / mass, 1/kg
  vec4 start;  // xyz position at the substep's start, m; w radius, m
};

// Overlap of two balls.
struct BallOverlap {
  vec3 normal;  // Unit vector from the other ball
  float depth;  // Depth of the overlap in metres; there is no contact if it is not positive
};

// Returns the direction in which ball a leaves ball b if both are at the same position: a unit vector that depends on
// their indices. The pair gets opposite directions, and balls of several pairs do not form a column.
FUNCTION vec3 ballAside(int a, int b) {
  vec3 v = signedUnits(hash3(uvec3(uint(min(a, b)), uint(max(a, b)), 0x9e3779b9u)));
  float squared = exactDot(v, v);
  precise float scale = exactInverseSqrt(max(squared, 1e-4f)) * (a < b ? -1.0f : 1.0f);
  precise vec3 aside = v * scale;
  return squared < 1e-4f ? vec3(a < b ? -1.0f : 1.0f, 0.0f, 0.0f) : aside;
}

// Returns false if balls at p and q surely do not overlap; this test needs no root.
FUNCTION bool ballsMayOverlap(vec3 p, vec3 q, float reach) {
  precise vec3 separation = p - q;
  precise float squaredReach = reach * reach * 1.00001f;
  return exactDot(separation, separation) < squaredReach;
}

// Returns the overlap of ball a at p with ball b at q.
FUNCTION BallOverlap ballOverlap(vec3 p, vec3 q, float reach, int a, int b) {
  precise vec3 separation = p - q;
  float squared = exactDot(separation, separation);
  bool same = squared < 1e-20f;
  float inverse = exactInverseSqrt(max(squared, 1e-20f));
  precise vec3 normal = separation * inverse;
  precise float depth = reach - squared * inverse;
  BallOverlap o;
  o.normal = normal;
  if (same) o.normal = ballAside(a, b);
  o.depth = same ? reach : depth;
  return o;
}
