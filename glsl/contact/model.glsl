// Contact of triangles: faces and edges keep a distance and never pass through each other. Compiles as GLSL and as C++
// (the CPU twin of the tests). Needs common/exact.glsl, types.glsl and `contactStep`.
//
// x is a position at the substep's start, x' the predicted position. No two faces intersect at x. Between two convex
// features that do not intersect at x there is a slab, normal to the segment between their closest points. As long as a
// plane parallel to the slab, standing still or moving uniformly, separates the two features, they do not pass through
// each other.

// Returns true if the vertex belongs to a solid. Solids follow their prescribed motion and are never held back, and
// cloth yields. Vertices of solids have the highest indices. NO_SOLIDS and NO_BALLS are defined for scenes without
// solids or balls.
FUNCTION bool isSolid(int vertex) {
#ifdef NO_SOLIDS
  return false;
#else
  return vertex >= contactStep.movable;
#endif
}
// Returns true if the vertex is a ball: a particle that touches cloth. Balls have no faces. The indices of balls follow
// the indices of the cloths' vertices.
FUNCTION bool isBall(int vertex) {
#ifdef NO_BALLS
  return false;
#else
  return vertex >= contactStep.balls && vertex < contactStep.movable;
#endif
}
// Returns true if the scene has balls or solids, which can move cloth by more than a thickness per substep.
FUNCTION bool hasPath() {
#if defined NO_SOLIDS && defined NO_BALLS
  return false;
#else
  return contactStep.balls < contactStep.vertices;
#endif
}
// Returns a ball's inverse mass if the ball is alive at both ends of the substep, otherwise 0. A new ball therefore
// takes part from its second substep on.
FUNCTION float ballWeight(float mass, float nextMass) {
  return mass > 0.0f && nextMass > 0.0f ? exactReciprocal(mass) : 0.0f;
}
// Returns a ball's contribution to `maxPath`: the length of its path, plus the length of the path that a bounce gives to
// cloth. The factor 1.5 covers a face corner, which can move up to 1.4 times as far as a point in the face.
FUNCTION float ballMotion(float way, float bounce) {
  precise float maxPath = way * 1.5f * (1.0f + bounce);
  return maxPath;
}
// Returns the distance to keep between the feature of the first corner and the feature of the last corner: the sum of
// half their thicknesses. Between a cloth and a solid it is the cloth's full thickness.
FUNCTION float thicknessBetween(ivec4 corners, float half_, float lastHalf) {
  precise float thick = (isSolid(corners.x) ? lastHalf : half_) + (isSolid(corners.w) ? half_ : lastHalf);
  return thick;
}
// Returns the Coulomb friction coefficient of two features: their mean. If one value is negative (a solid without a
// coefficient), returns the other value.
FUNCTION float frictionBetween(float a, float b) {
  precise float mean = 0.5f * (a + b);
  return a < 0.0f ? b : b < 0.0f ? a : mean;
}

// Returns the box that a vertex may occupy while the current pairs remain in use. The box covers the path of `horizon`
// substeps, but at most two thicknesses, and a border of 1/8 thickness plus 1/5 of the path. The limit means that pairs
// of fast vertices are searched more often, and not over longer distances.
FUNCTION Hull reachOf(vec3 now, vec3 next, float half_) {
  precise vec3 one = next - now;
  float fastest = max(max(abs(one.x), abs(one.y)), abs(one.z));
  precise float steps = 4.0f * half_ * exactReciprocal(max(fastest, 1e-20f));
  precise vec3 way = one * clamp(steps, 1.0f, contactStep.horizon);
  precise vec3 end = now + way;
  precise float wide = 0.25f * half_ + 0.2f * max(max(abs(way.x), abs(way.y)), abs(way.z));
  precise vec3 low = min(now, end) - wide;
  precise vec3 high = max(now, end) + wide;
  Hull hull;
  hull.low = min(low, next);
  hull.high = max(high, next);
  return hull;
}
FUNCTION float lengthOf(vec3 a, vec3 b) {
  precise vec3 way = b - a;
  float squared = exactDot(way, way);
  precise float length_ = squared * exactInverseSqrt(max(squared, 1e-24f));
  return length_;
}
FUNCTION bool hasSolids() {
#ifdef NO_SOLIDS
  return false;
#else
  return contactStep.movable < contactStep.vertices;
#endif
}
// Returns the distance (metres) by which contact may move a vertex from its predicted position beyond the limits given
// by the thickness. If the vertex has a pair with a solid or ball (`beside` is 1), the distance is the path of the
// fastest solid or ball plus the vertex's path, because the predicted position of a taut cloth can lie deep in a solid.
// Otherwise, it is 0.
FUNCTION float extraMoveLimit(vec3 now, vec3 next, float maxPath, float beside) {
  precise float extraMove = maxPath + lengthOf(now, next);
  return beside == 1.0f ? extraMove : 0.0f;
}
// Returns the value of `maxPath` (metres) that a pair search allows for: the current value plus 1/8.
FUNCTION float searchAllowance(float maxPath) {
  precise float more = 1.125f * maxPath;
  return more;
}
FUNCTION Hull widened(Hull a, float by) {
  precise vec3 low = a.low - by;
  precise vec3 high = a.high + by;
  Hull hull;
  hull.low = low;
  hull.high = high;
  return hull;
}
FUNCTION bool isWithin(vec3 p, vec3 low, vec3 high) {
  return p.x >= low.x && p.y >= low.y && p.z >= low.z && p.x <= high.x && p.y <= high.y && p.z <= high.z;
}
// Returns true if the found pairs are still complete for a vertex. If the vertex has a pair with a ball, its box must
// also leave a margin of `maxPath` of the previous substep. Otherwise, the box would limit the push on the vertex, and the
// ball would meet too little resistance.
FUNCTION bool pairsComplete(vec3 next, vec3 low, vec3 high, float maxPath, float beside) {
#ifdef NO_BALLS
  return isWithin(next, low, high);
#else
  float room = beside == 1.0f && contactStep.balls < contactStep.movable ? maxPath : 0.0f;
  precise vec3 minimum = next - room;
  precise vec3 maximum = next + room;
  return isWithin(minimum, low, high) && isWithin(maximum, low, high);
#endif
}
// Returns the maximum distance that a vertex can move from its current position within its box.
FUNCTION float radiusOf(vec3 now, vec3 low, vec3 high) {
  precise vec3 down = now - low;
  precise vec3 up = high - now;
  vec3 maximum = max(down, up);
  float squared = exactDot(maximum, maximum);
  precise float radius = squared * exactInverseSqrt(max(squared, 1e-24f));
  return radius;
}
FUNCTION bool overlap(vec3 low, vec3 high, vec3 otherLow, vec3 otherHigh) {
  return low.x <= otherHigh.x && low.y <= otherHigh.y && low.z <= otherHigh.z && otherLow.x <= high.x && otherLow.y <= high.y &&
         otherLow.z <= high.z;
}

#include "contact/near.glsl"

// Returns true if the two features can come within a thickness of each other while each corner moves by at most its
// radius.
FUNCTION bool mayMeet(Near near, vec4 radii, float thick) {
  float two = max(radii.z, radii.w);
  precise float maximum = isOfEdges(near) ? max(radii.x, radii.y) + two + thick : radii.x + max(radii.y, two) + thick;
  return near.normal.w <= maximum;
}

// Returns the heights of the four corners: their coordinates along the normal.
FUNCTION vec4 heightsOf(Near near, vec3 a, vec3 b, vec3 c, vec3 d) {
  vec3 normal = vec3(near.normal);
  return vec4(exactDot(normal, a), exactDot(normal, b), exactDot(normal, c), exactDot(normal, d));
}
// lowestOf() returns the minimum height of the first side's corners, highestOf() the maximum height of the other side's
// corners.
FUNCTION float lowestOf(Near near, vec4 heights) {
  return isOfEdges(near) ? min(heights.x, heights.y) : heights.x;
}
FUNCTION float highestOf(Near near, vec4 heights) {
  float two = max(heights.z, heights.w);
  return isOfEdges(near) ? two : max(two, heights.y);
}
FUNCTION float gapOf(Near near, vec4 heights) {
  precise float gap = lowestOf(near, heights) - highestOf(near, heights);
  return gap;
}
// Returns the displacement of one side at its closest point. a to d are the displacements of the corners.
FUNCTION vec3 wayOfSide(Near near, bool first, vec3 a, vec3 b, vec3 c, vec3 d) {
  bool edges = isOfEdges(near);
  vec4 shares = first ? vec4(near.shares.x, edges ? near.shares.y : 0.0f, 0.0f, 0.0f)
                      : vec4(0.0f, edges ? 0.0f : -near.shares.y, -near.shares.z, -near.shares.w);
  return weighted(shares, a, b, c, d);
}
// Returns a lower bound of the gap during a substep in which each corner's height changes by its rise.
FUNCTION float worstGap(Near near, vec4 heights, vec4 rises) {
  precise vec4 after = heights + rises;
  vec4 low = min(heights, after), high = max(heights, after);
  precise float gap = lowestOf(near, low) - highestOf(near, high);
  return gap;
}

// Returns true if the pair must be processed in this substep. Impulses move each side by at most 1/4 of the thickness,
// and colliders that push a side back afterwards leave it within 5/8 of the thickness. `extraMoves` holds extraMoveLimit() of the
// corners.
FUNCTION bool isNear(Near near, vec4 heights, vec4 rises, float thick, vec4 extraMoves) {
  float extraMove = max(max(extraMoves.x, extraMoves.y), max(extraMoves.z, extraMoves.w));
  precise float maximum = 1.5f * thick + 2.0f * extraMove;
  return near.normal.w > 0.0f && worstGap(near, heights, rises) < maximum;
}

// Returns the minimum gap that must remain after a substep: gap / 5, but at least thickness / 20. A gap below thickness
// / 20 must not shrink at all, because at smaller distances the normal would consist of rounding errors.
FUNCTION float leftOf(float gap, float thick) {
  precise float fifth = 0.2f * gap;
  precise float minimum = 0.05f * thick;
  return gap > minimum ? max(fifth, minimum) : gap;
}
// Returns true if one side of the pair belongs to a solid.
FUNCTION bool meetsSolid(Near near) {
  ivec4 corners = cornersOf(near);
  return isSolid(corners.x) || isSolid(corners.w);
}
FUNCTION bool isOfFirst(Near near, int corner) {
  return corner == 0 || (corner == 1 && isOfEdges(near));
}
// Returns limits of the heights at the end of the substep that keep the minimum gap (leftOf()): x is the minimum height
// of the first side's corners, given the other side's highest corner; y is the maximum height of the other side's
// corners, given the first side's lowest corner. `after` holds the final heights of the corners.
FUNCTION vec2 limitsOf(Near near, vec4 heights, vec4 after, float thick) {
  float left = leftOf(gapOf(near, heights), thick);
  precise float floor_ = highestOf(near, after) + left;
  precise float ceiling = lowestOf(near, after) - left;
  return vec2(floor_, ceiling);
}
// Returns for each corner the fraction of `way` that it must follow to keep the minimum gap. `way` is the displacement,
// at the closest point, of the leading side: a solid, or cloth carried by a solid. The fractions of the leading side's
// corners are 0. A corner that follows the entire `way` of a solid without rotation keeps its position relative to the
// solid, so several features of one solid do not contradict each other. `after` holds the final heights of the leading
// side's corners.
FUNCTION vec4 carriesOf(Near near, bool firstLeads, vec4 heights, vec4 after, vec3 way, float thick) {
  vec2 limits = limitsOf(near, heights, after, thick);
  float rise = exactDot(vec3(near.normal), way);
  precise float perRise = exactReciprocal(max(abs(rise), 1e-12f));
  vec4 carries = vec4(0.0f);
  for (int k = 0; k < 4; ++k) {
    bool first = isOfFirst(near, k);
    precise float up = (limits.x - heights[k]) * perRise;
    precise float down = (heights[k] - limits.y) * perRise;
    float share = first && !firstLeads && rise > 0.0f ? up : !first && firstLeads && rise < 0.0f ? down : 0.0f;
    carries[k] = clamp(share, 0.0f, 1.0f);
  }
  return carries;
}
// Returns true if the first of two cloth layers leads when solids carry the layers too near to each other, that is, if
// it is carried further towards the other layer.
FUNCTION bool firstGoesFurther(Near near, vec3 way, vec3 otherWay) {
  vec3 normal = vec3(near.normal);
  precise float both = exactDot(normal, way) + exactDot(normal, otherWay);
  return both < 0.0f;
}
// Returns true if no moving plane separates the two sides at the end when each corner moves by its fraction `let` of
// its path. `starts` holds the heights at which the paths begin: at the corners' positions, or at the positions to
// which solids carry the corners.
FUNCTION bool passes(Near near, vec4 heights, vec4 starts, vec4 rises, vec4 let, float thick) {
  precise vec4 after = starts + rises * let;
  float left = leftOf(gapOf(near, heights), thick);
  precise float rounded = 0.875f * left;
  return gapOf(near, after) < (meetsSolid(near) ? rounded : left);
}
// Returns for each corner the fraction of its path that keeps the sides separated by a plane that stands still. Each
// side may use half of the spare gap. If one side is a solid, it moves along its whole path and the plane moves with
// it.
FUNCTION vec4 letOf(Near near, vec4 heights, vec4 starts, vec4 rises, float thick) {
  ivec4 corners = cornersOf(near);
  bool firstSolid = isSolid(corners.x), otherSolid = isSolid(corners.w);
  float gap = gapOf(near, heights);
  precise float spare = 0.5f * (gapOf(near, starts) - leftOf(gap, thick));
  float own = max(spare, 0.0f);
  precise float floor_ = lowestOf(near, starts) - own;
  precise float ceiling = highestOf(near, starts) + own;
  precise vec4 after = starts + rises;
  vec2 limits = limitsOf(near, heights, after, thick);
  floor_ = otherSolid ? limits.x : floor_;
  ceiling = firstSolid ? limits.y : ceiling;
  vec4 let = vec4(1.0f);
  for (int k = 0; k < 4; ++k) {
    bool first = isOfFirst(near, k);
    precise float room = first ? starts[k] - floor_ : ceiling - starts[k];
    precise float way = first ? -rises[k] : rises[k];
    precise float part = room * exactReciprocal(max(way, 1e-30f));
    let[k] = way > room && !(first ? firstSolid : otherSolid) ? clamp(part, 0.0f, 1.0f) : 1.0f;
  }
  return let;
}

// Returns true if both closest points are in the interior of their features. A closest point on a border also belongs
// to a neighbouring feature, which then determines the push. Otherwise, a cloth that slides over another would catch on
// the interior edges.
FUNCTION bool isInside(Near near) {
  return near.shares.x != 0.0f && near.shares.y != 0.0f && near.shares.z != 0.0f && near.shares.w != 0.0f;
}

// Returns true if the pair pushes a ball. A ball has no edges that could touch a cloth's border, so a closest point on
// a border also pushes it if no other feature is nearer. `nearest` is the distance of the nearest feature in metres.
FUNCTION bool pushesBall(Near near, float nearest) {
  return isInside(near) || near.normal.w <= nearest;
}
// Returns the distance in metres that a ball bounces back: the fraction `bounce` of its path relative to the other
// side, along the normal. Returns -1e30 if the impact is slow or if the ball does not come within the thickness.
FUNCTION float givenBack(Near near, vec3 slide, float thick, float bounce) {
  float through = exactDot(slide, vec3(near.normal));
  precise float after = near.normal.w + through;
  precise float back = through * -bounce;
  precise float minimum = -contactStep.bounceFrom;
  return through < minimum && after < thick ? back : -1e30f;
}

// Returns the displacement (metres) of the first side's closest point relative to the other side's. It restores the
// distance `thick` at the end of the substep; if the points are already nearer than `thick` at the start, it restores
// the distance slowly. For a ball, the displacement along the normal is at least `back`. Friction reduces the
// tangential displacement by at most the friction coefficient times the normal displacement.
FUNCTION vec3 correctionOf(Near near, vec3 slide, float thick, float friction, float back, bool pushes) {
  vec3 normal = vec3(near.normal);
  float through = exactDot(slide, normal);
  precise float missing = thick - near.normal.w;
  precise float part = missing * contactStep.recovery;
  precise float slowly = near.normal.w + min(part, contactStep.maxRecovery);
  float target = missing > 0.0f ? slowly : thick;
  precise float separation = target - near.normal.w;
  precise float push = max(separation, back) - through;
  precise vec3 along = slide - normal * through;
  precise float held = friction * push * exactInverseSqrt(max(exactDot(along, along), 1e-24f));
  precise vec3 way = normal * push - along * min(held, 1.0f);
  bool there = near.normal.w > 0.0f && push > 0.0f && pushes;
  return there ? way : vec3(0.0f);
}

// Returns a contact's claim on a corner: the magnitude of the corner's barycentric weight, in units of 1/4096.
// impulseOf() splits a corner's mass among its contacts in proportion to their claims.
FUNCTION int massWeightOf(float share) {
  precise float scaled = abs(share) * 4096.0f + 0.5f;
  return int(floor(scaled));
}
// Returns the impulse (kg m) that produces the displacement `way`. All contacts are solved at the same time, so each
// corner's mass is split among its contacts in proportion to their claims (Tonge et al. 2012, Mass Splitting for
// Jitter-Free Parallel Rigid Body Simulation). For a corner with the inverse mass w and the sum s of claims, a contact
// uses the inverse mass w s / |share|, where share is the corner's barycentric weight. `weights` holds w s of the
// corners.
FUNCTION vec3 impulseOf(vec4 shares, vec4 weights, vec3 way) {
  vec4 sizes = abs(shares);
  float weight = exactDot(sizes, weights);
  precise vec3 impulse = way * exactReciprocal(max(weight, 1e-20f));
  return weight > 0.0f ? impulse : vec3(0.0f);
}
FUNCTION float weightOf(float inverseMass, int claims) {
  precise float weight = inverseMass * (float(claims) * 2.44140625e-4f);
  return weight;
}

// Converts an impulse to integers, whose sum does not depend on the order. The caller gives the last corner the negated
// sum of the other corners, so that the total is zero.
FUNCTION ivec3 quantaOf(vec3 impulse, float share) {
  precise vec3 scaled = impulse * (share * contactStep.quanta) + 0.5f;
  vec3 held = clamp(floor(scaled), vec3(-1e8f), vec3(1e8f));
  return ivec3(int(held.x), int(held.y), int(held.z));
}

// Returns `place`, limited to the distance `maximum` from `next` and to the box from `low` to `high`.
FUNCTION vec3 keptWithin(vec3 next, vec3 place, float maximum, vec3 low, vec3 high) {
  precise vec3 way = place - next;
  precise float part = maximum * exactInverseSqrt(max(exactDot(way, way), 1e-24f));
  precise vec3 moved = next + way * min(part, 1.0f);
  vec3 kept = part < 1.0f ? moved : place;
  return clamp(kept, low, high);
}

// Returns a vertex's position after its impulses, limited to the distance `maximum` from its predicted position and to its
// box.
FUNCTION vec3 pushedTo(vec3 next, vec3 wanted, float weight, ivec3 sum, float maximum, vec3 low, vec3 high) {
  precise vec3 way = wanted + vec3(float(sum.x), float(sum.y), float(sum.z)) * (contactStep.perQuanta * weight);
  return keptWithin(next, way, maximum, low, high);
}

// Returns the position to which a vertex can be held back: its position at the substep's start, displaced by solids
// unless it is pinned.
FUNCTION vec3 carriedTo(vec4 now, vec3 up, vec3 down) {
  precise vec3 carried = vec3(now) + up - down;
  return now.w == 0.0f ? vec3(now) : carried;
}
// Returns the velocity of a vertex after contact has moved it from `next` to `end`.
FUNCTION vec3 speedBy(vec3 velocity, vec3 next, vec3 end) {
  precise vec3 speed = velocity + (end - next) * contactStep.perDt;
  return speed;
}
// Returns the position of a vertex that is held back: the point at the fraction `let` of the path from `start` to
// `wanted`.
FUNCTION vec3 heldAt(vec3 start, vec3 wanted, float let) {
  precise vec3 part = start + (wanted - start) * let;
  return let == 1.0f ? wanted : part;
}
