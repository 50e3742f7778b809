// Uniform data of the contact kernels. Compiles as GLSL and as C++ (src/sim/contact). Floats come first, so that std140
// and C++ have the same layout.
#ifndef CONTACT_TYPES
#define CONTACT_TYPES

struct STD140 ContactStep {
  float perDt;        // in 1/s
  float recovery;     // Fraction of missing distance that a substep restores
  float mostRecovery; // Maximum restored distance per substep, m
  float horizon;      // Number of substeps that a pair search looks ahead
  float quanta;       // Integer units per kg m, for the sums of impulses
  float perQuanta;    // kg m per integer unit: 1 / `quanta`
  float bounceFrom;   // Slowest approach to a ball that bounces, m per substep
  int vertices;
  int movable;        // Number of vertices of cloths and balls; solids' vertices follow
  int balls;          // Index of the first ball
  int faceLevels;     // The face tree has 2^faceLevels leaves
  int edgeLevels;     // The edge tree has 2^edgeLevels leaves
  int forced;         // 1 to force a pair search in this substep
  int maxPairs;       // Capacity of the list of each kind
};

// Two close features: a vertex and a face, or two edges. The first of the four corners is on the first side, the last
// two on the other side. The second corner is on the first side for edges, otherwise on the other side.
struct Near {
  ivec4 corners;  // The second index is complemented for two edges
  vec4 shares;    // Weights of the corners at the closest points: positive on the first side, negative on the other
  // xyz unit vector from the other side to the first, w distance of the closest points in metres; zero if undefined
  vec4 normal;
};

struct Hull {
  vec3 low, high;  // in metres
};

#endif
