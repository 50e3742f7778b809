// What the kernels of contact read. Compiles as GLSL and as C++ (src/sim/contact). Floats first, so that std140 and C++ agree.
#ifndef CONTACT_TYPES
#define CONTACT_TYPES

struct STD140 ContactStep {
  float perDt;        // 1/s
  float recovery;     // fraction of what is too near that is made good in a substep,
  float mostRecovery; // m, at most
  float horizon;      // substeps ahead for which pairs are looked for
  float quanta;       // impulses are summed up as integers: so many a kg m
  float perQuanta;    // kg m
  float bounceFrom;   // m a substep: what meets a ball more slowly is not given back
  int vertices;
  int movable;        // of them the first are of cloths and balls, the others of solids, which go where they go
  int balls;          // the first of the balls
  int faceLevels;     // of the tree over faces: it has 2^faceLevels leaves
  int edgeLevels;     // of the tree over edges
  int forced;         // 1: pairs are to be found anew in any case
  int maxPairs;       // of each kind
};

// Two features that are close: a vertex and a face, or two edges. Of the four vertices the first is on one side, the last two
// are on the other, the second with the first (edges) or with the others.
struct Near {
  ivec4 corners;  // the second one's complement: edges
  vec4 shares;    // of the corners at the two closest points: positive on the first side, negative on the other
  vec4 normal;    // xyz from the other side to the first, w m between the closest points; 0: none
};

struct Hull {
  vec3 low, high;  // m
};

#endif
