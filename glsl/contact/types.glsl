// Uniform data of the contact kernels. Compiles as GLSL and as C++ (src/sim/contact). Floats come first, so that std140
// and C++ have the same layout.
#ifndef CONTACT_TYPES
#define CONTACT_TYPES

struct STD140 ContactStep {
  float perDt;        // 1 / duration of the substep, in 1/s
  float recovery;     // Fraction of the missing distance that a substep restores
  float maxRecovery; // Maximum distance in metres that a substep restores
  float horizon;      // Number of substeps that a pair search looks ahead
  float quanta;       // Integer units per kg m, for the sums of impulses
  float perQuanta;    // kg m per integer unit: 1 / `quanta`
  float bounceFrom;   // Minimum approach to a ball, in metres per substep, that makes it bounce
  int vertices;
  int movable;        // Number of vertices of cloths and balls; the indices of solids' vertices follow
  int balls;          // Index of the first ball
  int faceLevels;     // The face tree has 2^faceLevels leaves
  int edgeLevels;     // The edge tree has 2^edgeLevels leaves
  int forced;         // 1 to force a pair search in this substep
  int maxPairs;       // Capacity of the list of pairs of each kind
};

// Two features at a small distance: a vertex and a face, or two edges. The first of the four corners is on the first
// side, the last two are on the other side. The second corner is on the first side for two edges, otherwise on the
// other side.
struct Near {
  ivec4 corners;  // Vertex indices; for two edges, the second index is complemented
  vec4 shares;    // Barycentric weights of the corners at the closest points: positive on the first side, negative on
                  // the other side
  // xyz unit vector from the other side to the first side; w distance of the closest points in metres; zero if
  // undefined
  vec4 normal;
};

struct Hull {
  vec3 low, high;  // Minimum and maximum corner in metres
};

#endif
