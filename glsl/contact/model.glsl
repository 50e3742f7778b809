// Contact of triangles: faces and edges keep a distance, and never pass through each other. Compiles as GLSL and as C++, where
// it is the CPU twin. Needs common/exact.glsl, types.glsl and `contactStep`.
//
// Positions of a substep's start are x, where it would lead x'; no face crosses another at x. Two convex features that are
// apart at x have a slab between them, normal to the way between their closest points. As long as some plane parallel to
// it, at rest or moving evenly, keeps them apart, neither passes through the other.

// Solids go where they go and are never held back: cloths give way. Their vertices come last. A kernel that has NO_SOLIDS or
// NO_BALLS is for scenes without.
FUNCTION bool isSolid(int vertex) {
#ifdef NO_SOLIDS
  return false;
#else
  return vertex >= contactStep.movable;
#endif
}
// Particles that meet cloths: vertices without faces, which come after those of cloths.
FUNCTION bool isBall(int vertex) {
#ifdef NO_BALLS
  return false;
#else
  return vertex >= contactStep.balls && vertex < contactStep.movable;
#endif
}
// Whether anything moves cloth by more than thicknesses: balls, solids.
FUNCTION bool hasStir() {
#if defined NO_SOLIDS && defined NO_BALLS
  return false;
#else
  return contactStep.balls < contactStep.vertices;
#endif
}
// Of a ball: inverse mass; 0 unless it lives at the substep's start and at its end. A newborn is met from its next substep on.
FUNCTION float ballWeight(float mass, float nextMass) {
  return mass > 0.0f && nextMass > 0.0f ? exactReciprocal(mass) : 0.0f;
}
// Its share in what `stir` counts: as far as it goes, and what it throws goes; one corner of a face goes up to 1.4 times as far as a point in it.
FUNCTION float ballStir(float way, float bounce) {
  precise float stir = way * 1.5f * (1.0f + bounce);
  return stir;
}
// The distance kept between the first corner's feature and the last one's, of half their thicknesses: off a solid a cloth keeps
// its own.
FUNCTION float thicknessBetween(ivec4 corners, float half_, float lastHalf) {
  precise float thick = (isSolid(corners.x) ? lastHalf : half_) + (isSolid(corners.w) ? half_ : lastHalf);
  return thick;
}
// Coulomb's coefficient of two: the mean, or the other's where one, a solid, has none (-1).
FUNCTION float frictionBetween(float a, float b) {
  precise float mean = 0.5f * (a + b);
  return a < 0.0f ? b : b < 0.0f ? a : mean;
}

// Where a vertex may be for as long as pairs are used that are found now: the way of `horizon` substeps, but of no more than
// lead through two thicknesses, and an eighth of a thickness and a fifth of the way around it. What is fast has its pairs found often,
// rather than with all that is far.
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
// How much further than by thicknesses contact may move a vertex away from `next`, where there are solids (m): as far as the fastest
// of them goes, and back by all of its own way, which a taut cloth may lead far through a solid. `beside`: 1 where a pair with a
// solid was found, elsewhere 0.
FUNCTION float roamOf(vec3 now, vec3 next, float stir, float beside) {
  precise float roam = stir + lengthOf(now, next);
  return beside == 1.0f ? roam : 0.0f;
}
// For what `stir` (m) of solids pairs are looked for.
FUNCTION float foreseen(float stir) {
  precise float more = 1.125f * stir;
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
// Whether pairs are still good for a vertex; `stir`: of the substep before, which one beside a ball is to have room for: what would end
// at its box would take less of a push than the ball feels.
FUNCTION bool isGood(vec3 next, vec3 low, vec3 high, float stir, float beside) {
#ifdef NO_BALLS
  return isWithin(next, low, high);
#else
  float room = beside == 1.0f && contactStep.balls < contactStep.movable ? stir : 0.0f;
  precise vec3 least = next - room;
  precise vec3 most = next + room;
  return isWithin(least, low, high) && isWithin(most, low, high);
#endif
}
// How far a vertex may get from where it is now.
FUNCTION float radiusOf(vec3 now, vec3 low, vec3 high) {
  precise vec3 down = now - low;
  precise vec3 up = high - now;
  vec3 most = max(down, up);
  float squared = exactDot(most, most);
  precise float radius = squared * exactInverseSqrt(max(squared, 1e-24f));
  return radius;
}
FUNCTION bool overlap(vec3 low, vec3 high, vec3 otherLow, vec3 otherHigh) {
  return low.x <= otherHigh.x && low.y <= otherHigh.y && low.z <= otherHigh.z && otherLow.x <= high.x && otherLow.y <= high.y &&
         otherLow.z <= high.z;
}

#include "contact/near.glsl"

// Whether they may come within a thickness of each other while no corner gets further than its radius.
FUNCTION bool mayMeet(Near near, vec4 radii, float thick) {
  float two = max(radii.z, radii.w);
  precise float most = isOfEdges(near) ? max(radii.x, radii.y) + two + thick : radii.x + max(radii.y, two) + thick;
  return near.normal.w <= most;
}

// Heights of four corners along the normal.
FUNCTION vec4 heightsOf(Near near, vec3 a, vec3 b, vec3 c, vec3 d) {
  vec3 normal = vec3(near.normal);
  return vec4(exactDot(normal, a), exactDot(normal, b), exactDot(normal, c), exactDot(normal, d));
}
// The lowest of the first side and the highest of the other.
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
// The way of a side at its closest point. `ways`: of the corners.
FUNCTION vec3 wayOfSide(Near near, bool first, vec3 a, vec3 b, vec3 c, vec3 d) {
  bool edges = isOfEdges(near);
  vec4 shares = first ? vec4(near.shares.x, edges ? near.shares.y : 0.0f, 0.0f, 0.0f)
                      : vec4(0.0f, edges ? 0.0f : -near.shares.y, -near.shares.z, -near.shares.w);
  return weighted(shares, a, b, c, d);
}
// What the gap comes to at worst if every corner goes no further than by its rise.
FUNCTION float worstGap(Near near, vec4 heights, vec4 rises) {
  precise vec4 after = heights + rises;
  vec4 low = min(heights, after), high = max(heights, after);
  precise float gap = lowestOf(near, low) - highestOf(near, high);
  return gap;
}

// Whether it has to be looked at in this substep: impulses move either side by no more than a quarter of the thickness, and
// colliders that it is then pushed out of again leave it within 5/8. `roams`: of the corners, roamOf().
FUNCTION bool isNear(Near near, vec4 heights, vec4 rises, float thick, vec4 roams) {
  float roam = max(max(roams.x, roams.y), max(roams.z, roams.w));
  precise float most = 1.5f * thick + 2.0f * roam;
  return near.normal.w > 0.0f && worstGap(near, heights, rises) < most;
}

// How much of a gap may be left at least after a substep. Where it is below a twentieth of the thickness, nothing goes:
// normals between points still closer would be those of rounding.
FUNCTION float leftOf(float gap, float thick) {
  precise float fifth = 0.2f * gap;
  precise float least = 0.05f * thick;
  return gap > least ? max(fifth, least) : gap;
}
// Whether one side is a solid's.
FUNCTION bool meetsSolid(Near near) {
  ivec4 corners = cornersOf(near);
  return isSolid(corners.x) || isSolid(corners.w);
}
FUNCTION bool isOfFirst(Near near, int corner) {
  return corner == 0 || (corner == 1 && isOfEdges(near));
}
// Where the sides end: heights that the first one has to stay above (x) if it is the other that decides, and the other one below (y).
FUNCTION vec2 limitsOf(Near near, vec4 heights, vec4 after, float thick) {
  float left = leftOf(gapOf(near, heights), thick);
  precise float floor_ = highestOf(near, after) + left;
  precise float ceiling = lowestOf(near, after) - left;
  return vec2(floor_, ceiling);
}
// How much of the way `way` of the side that leads (the first, or the other one), at its closest point, each corner across from it has
// to go at least so that it leaves them room: a solid, or a cloth that solids carry. Who goes all of the way stays as it is to what does not
// turn, so the ways that several features of one ask for do not contradict each other. `after`: heights of the leading side's
// corners at its end.
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
// Of two cloths, or layers of one, that come too near when solids carry them so far: whether the first is carried further towards the other.
FUNCTION bool firstGoesFurther(Near near, vec3 way, vec3 otherWay) {
  vec3 normal = vec3(near.normal);
  precise float both = exactDot(normal, way) + exactDot(normal, otherWay);
  return both < 0.0f;
}
// Whether the corners on their ways, as far as they are let, do not keep a moving plane between them. `starts`: heights where
// those ways begin, which is where the corners are, or as far as solids carry them.
FUNCTION bool passes(Near near, vec4 heights, vec4 starts, vec4 rises, vec4 let, float thick) {
  precise vec4 after = starts + rises * let;
  float left = leftOf(gapOf(near, heights), thick);
  precise float rounded = 0.875f * left;
  return gapOf(near, after) < (meetsSolid(near) ? rounded : left);
}
// How much of its way each corner may go so that a plane at rest keeps them apart: at most half of the gap for either side. A
// solid goes all of its way, and the plane with it.
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

// Whether both closest points are inside their features. Others belong to a neighbour as well, which decides where they push:
// in the plane of a cloth that another slides over there are edges, but nothing to run against.
FUNCTION bool isInside(Near near) {
  return near.shares.x != 0.0f && near.shares.y != 0.0f && near.shares.z != 0.0f && near.shares.w != 0.0f;
}

// A ball has no edges that would meet a cloth's, so it is pushed by borders, too, where nothing is nearer to it. `nearest` (m): of all.
FUNCTION bool pushesBall(Near near, float nearest) {
  return isInside(near) || near.normal.w <= nearest;
}
// How far a ball is to go back (m) of the way along each other that the two would have gone: the share `bounce` of what is fast.
FUNCTION float givenBack(Near near, vec3 slide, float thick, float bounce) {
  float through = exactDot(slide, vec3(near.normal));
  precise float after = near.normal.w + through;
  precise float back = through * -bounce;
  precise float least = -contactStep.bounceFrom;
  return through < least && after < thick ? back : -1e30f;
}

// The way that the first side's closest point has to go away from the other's (m): as much as keeps them `thick` apart at the
// substep's end; where they are nearer already, slowly; and of a ball at least `back`. Of the way along each other, friction takes
// at most its coefficient times that.
FUNCTION vec3 correctionOf(Near near, vec3 slide, float thick, float friction, float back, bool pushes) {
  vec3 normal = vec3(near.normal);
  float through = exactDot(slide, normal);
  precise float missing = thick - near.normal.w;
  precise float part = missing * contactStep.recovery;
  precise float slowly = near.normal.w + min(part, contactStep.mostRecovery);
  float target = missing > 0.0f ? slowly : thick;
  precise float apart = target - near.normal.w;
  precise float push = max(apart, back) - through;
  precise vec3 along = slide - normal * through;
  precise float held = friction * push * exactInverseSqrt(max(exactDot(along, along), 1e-24f));
  precise vec3 way = normal * push - along * min(held, 1.0f);
  bool there = near.normal.w > 0.0f && push > 0.0f && pushes;
  return there ? way : vec3(0.0f);
}

// How much a contact claims of a corner, as an integer.
FUNCTION int claimOf(float share) {
  precise float scaled = abs(share) * 4096.0f + 0.5f;
  return int(floor(scaled));
}
// The impulse (kg m) that makes that way good. So that all contacts may be solved at once, each corner's mass is split among
// its contacts by their shares (Tonge et al. 2012, Mass Splitting for Jitter-Free Parallel Rigid Body Simulation): of
// inverse masses w and sums of shares s, w s / |share| each. `weights`: w s of the corners.
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

// As integers, which add up to the same whatever their order. The last corner's is what the others leave.
FUNCTION ivec3 quantaOf(vec3 impulse, float share) {
  precise vec3 scaled = impulse * (share * contactStep.quanta) + 0.5f;
  vec3 held = clamp(floor(scaled), vec3(-1e8f), vec3(1e8f));
  return ivec3(int(held.x), int(held.y), int(held.z));
}

// A place, but no further from `next` than `most`, and not out of a box.
FUNCTION vec3 keptWithin(vec3 next, vec3 place, float most, vec3 low, vec3 high) {
  precise vec3 way = place - next;
  precise float part = most * exactInverseSqrt(max(exactDot(way, way), 1e-24f));
  precise vec3 moved = next + way * min(part, 1.0f);
  vec3 kept = part < 1.0f ? moved : place;
  return clamp(kept, low, high);
}

// Where the impulses take a vertex: from where it was to go no further than `most`, and not out of where it may be.
FUNCTION vec3 pushedTo(vec3 next, vec3 wanted, float weight, ivec3 sum, float most, vec3 low, vec3 high) {
  precise vec3 way = wanted + vec3(float(sum.x), float(sum.y), float(sum.z)) * (contactStep.perQuanta * weight);
  return keptWithin(next, way, most, low, high);
}

// Where a vertex is held back to at worst: where it was, or where solids carry it. What is held by pins is not.
FUNCTION vec3 carriedTo(vec4 now, vec3 up, vec3 down) {
  precise vec3 carried = vec3(now) + up - down;
  return now.w == 0.0f ? vec3(now) : carried;
}
// What it makes of a velocity that a vertex goes to `end` instead of `next`.
FUNCTION vec3 speedBy(vec3 velocity, vec3 next, vec3 end) {
  precise vec3 speed = velocity + (end - next) * contactStep.perDt;
  return speed;
}
// `start`: where it is held back to.
FUNCTION vec3 heldAt(vec3 start, vec3 wanted, float let) {
  precise vec3 part = start + (wanted - start) * let;
  return let == 1.0f ? wanted : part;
}
