// Screen-space reflections: a ray from a visible point is followed through the picture's depth. Sources: M. McGuire and
// M. Mara, "Efficient GPU screen-space ray tracing", Journal of Computer Graphics Techniques 3(4), 2014 (the path on
// the picture and the thickness); Y. Uludag, "Hi-Z screen-space cone-traced reflections", GPU Pro 5, 2014 (the levels).
// Compiles as GLSL and as C++. The including file declares `view`, float nearestAt(level, cell) and vec4 litAt(level,
// cell), float cellsPerPixel_, and vec2 mirrorReach_: max length of rays and thickness of objects (m). A cell of level 0
// is a half pixel (a block of 2x2 pixels), and cellsPerPixel_ is 1/2. In rays that refine the picture (refined.glsl), it
// is a pixel, and cellsPerPixel_ is 1; all lengths called half pixels below are then pixels.
// On the picture a ray is a line, and its nearness is affine along the line, as for planes: n(t) = n0 + t n', with t in
// half pixels. A cell of a level holds the nearness of the nearest point that it covers. If that point is farther away
// than the ray in the whole cell, the ray hits nothing there and continues with larger cells. Otherwise it continues
// with smaller cells. In a half pixel the ray has hit something if these three conditions hold:
// 1. nearest > n(t) at the farther end of the ray's path through the half pixel: there the ray is behind the visible
// surface.
// 2. 1 / n(t) - 1 / nearest < thickness at the nearer end: there the ray is behind the visible surface by less than the
// thickness of objects. (In orthographic views the nearness is a negative depth plus a constant, and the condition is
// nearest - n(t) < thickness.) Far objects are thicker (thickAt).
// 3. The visible surface is in front of the mirror's plane: nearest is greater than the plane's nearness by 3/4 of the
// plane's change over a half pixel (the sum of both axes), and by 0.2% of the mirror's nearness.
// The weight of a hit is reduced from 1 to 0 as:
// - the depth of the ray behind the visible surface, less the surface's change over a half pixel (the sum of both axes,
// at most 1%), grows from 0 to the thickness, and sooner for a curved mirror; the surface's nearness is the mean of the half
// pixel's and of the nearness where the object's light is read;
// - the path only crosses a corner of the half pixels that show the object;
// - only for REFRACTED: the object is narrower than a half pixel: both neighbours on opposite sides are farther away, by
// 4% to 8%;
// - the distance of the hit from the border of the picture falls from a tenth of the picture's height to 0;
// - the distance of the hit along the ray grows from half of the max length to the max length;
// - the cosine of the angle between the ray and the direction to the eye grows from 0 to 1/2, because the back sides of
// objects are not visible;
// - the distance between the points that neighbouring half pixels of a curved mirror reflect grows from 1/2 to 3 half
// pixels, which would be noise;
// - the roughness grows from 0.1 to 0.3, because rougher mirrors would need blurred edges.
// The remaining weight counts as a miss. REFRACTED: the ray has passed through glass. It has no mirror's plane, so
// condition 3 always holds. The roughness does not reduce the weight. The curvature reduces it only through the first
// case of the list. GROUND_MIRROR: the mirror is the ground, which the levels leave out, so condition 3 always holds.
#include "common/exact.glsl"
#include "draw/exact/depth.glsl"
#include "draw/exact/occlusion/half_pixels.glsl"
#include "draw/exact/reflections/edges.glsl"
#include "draw/exact/reflections/levels.glsl"
#include "draw/exact/reflections/mirror_reach.glsl"

const int mirrorSteps = 96;

struct MirrorWay {
  vec2 from;       // start of the path in half pixels
  vec2 along;      // unit direction of the path on the picture
  float nearness;  // nearness at the start of the path (1/m)
  float rate;      // change of nearness per half pixel along the path
  float speed;     // half pixels per metre at the start of the path
  vec2 slope;      // change of nearness per half pixel on the mirror's plane
  float turns;     // angle between the mirror's normals at neighbouring half pixels (radians)
  float end;       // length of the path in half pixels
  float counts;    // weight of the reflection; 0 if there is no path
#ifdef HAZE
  vec3 p, direction;  // start and unit direction of the ray
#endif
};

struct MirrorHit {
  float at;      // distance of the hit along the path in half pixels
  float counts;
  float covers;  // fraction of the ray that the object stops; the rest passes behind it
  float nearest;  // nearness of the object; 0 if the light of all objects there counts
  float spread;  // distance, in half pixels, between the points that neighbouring half pixels reflect
  vec2 inwards;  // way in half pixels from the hit to the inside of the object, if the hit is at its edge
};

// Returns the distance (m) from the start to position t of the path. In orthographic views it is t / speed; otherwise
// it follows from perspective.
FUNCTION float metresAlong(MirrorWay way, float t) {
#ifdef PARALLEL
  precise float metres = t * exactReciprocal(way.speed);
#else
  precise float there = way.nearness + way.rate * t;
  precise float under = way.speed * max(there, 1e-9f);
  precise float metres = t * way.nearness * exactReciprocal(under);
#endif
  return metres;
}

// Returns the path of a ray from p in the unit `direction`. `ground` is the distance (m) at which the ray hits the
// ground, or -1 if it does not. `facing` is the unit normal of the surface. `towards` is the unit vector to the eye.
// `turns` is the angle between the normals of neighbouring half pixels (radians).
FUNCTION MirrorWay mirrorWay(vec3 p, vec3 direction, float ground, vec3 facing, vec3 towards, float turns, float roughness) {
  precise vec3 aside = p - vec3(view.eye);
  precise float depth = exactDot(vec3(view.forward), aside);
  precise float recedes = exactDot(vec3(view.forward), direction);
  precise vec2 across = vec2(exactDot(vec3(view.across), aside), exactDot(vec3(view.down), aside));
  precise vec2 moved = vec2(exactDot(vec3(view.across), direction), exactDot(vec3(view.down), direction));
  float steep = exactDot(facing, aside);
  vec2 tilt = vec2(exactDot(facing, vec3(view.rayAcross)), exactDot(facing, vec3(view.rayDown)));
  float pixelsPerCell = cellsPerPixel_ > 0.75f ? 1.0f : 2.0f;
  MirrorWay way;
#ifdef PARALLEL
  steep = exactDot(facing, vec3(view.forward));
  precise vec2 from = 0.5f * cellsPerPixel_ * vec2(view.size) + cellsPerPixel_ * across;
  precise vec2 velocity = cellsPerPixel_ * moved;
  precise float nearness = exactReciprocal(view.forward.w) + (view.near - depth);
  float perSteep = exactReciprocal(min(steep, -1e-9f));
  precise vec2 slope = pixelsPerCell * tilt * perSteep;
#else
  float perDepth = exactReciprocal(max(depth, 1e-9f));
  precise vec2 from = cellsPerPixel_ * across * perDepth;
  precise vec2 velocity = (cellsPerPixel_ * moved - from * recedes) * perDepth;
  float nearness = perDepth;
  float perSteep = exactReciprocal(min(steep, -1e-9f));
  precise vec2 slope = pixelsPerCell * tilt * perSteep;
#endif
  precise float square = velocity.x * velocity.x + velocity.y * velocity.y;
  float perSpeed = exactInverseSqrt(max(square, 1e-20f));
  precise vec2 along = velocity * perSpeed;
  precise float speed = max(square, 1e-20f) * perSpeed;
#ifdef PARALLEL
  precise float rate = -recedes * perSpeed;
  float metres = ground < 0.0f ? mirrorReach_.x : min(ground, mirrorReach_.x);
  precise float reach = metres * speed;
#else
  precise float rate = -recedes * nearness * nearness * perSpeed;
  // t = speed l d / (d + l d') for the distance l (m), where the depth d changes by d' per metre.
  float metres = ground < 0.0f ? mirrorReach_.x : min(ground, mirrorReach_.x);
  precise float ahead = depth + metres * recedes;
  float held = max(ahead, view.near);
  precise float wholeWay = speed * metres * depth * exactReciprocal(held);
  float reach = wholeWay;
#endif
  vec2 far = vec2(along.x > 0.0f ? float(view.size.x) : 0.0f, along.y > 0.0f ? float(view.size.y) : 0.0f);
  precise vec2 left = cellsPerPixel_ * far - from;
  precise float acrossEnd = left.x * exactReciprocal(abs(along.x) < 1e-6f ? 1e-6f : along.x);
  precise float downEnd = left.y * exactReciprocal(abs(along.y) < 1e-6f ? 1e-6f : along.y);
  float border = min(abs(along.x) < 1e-6f ? 1e9f : acrossEnd, abs(along.y) < 1e-6f ? 1e9f : downEnd);
  precise float back = 2.0f * exactDot(direction, towards);
#ifdef REFRACTED
  precise float counts = 1.0f - easedBetween(back);
  bool leaves = square > 1e-12f;
  slope = vec2(0.0f);
#else
  precise float counts = smoothnessOf(roughness) * (1.0f - easedBetween(back));
  bool leaves = steep < 0.0f && exactDot(direction, facing) > 0.0f && square > 1e-12f;
#endif
  way.from = from;
  way.along = along;
  way.nearness = nearness;
  way.rate = rate;
  way.speed = speed;
  way.slope = slope;
  way.turns = turns;
  way.end = min(border, reach);
  way.counts = leaves ? counts : 0.0f;
#ifdef HAZE
  way.p = p;
  way.direction = direction;
#endif
  return way;
}

// Returns the distance, in half pixels, between the points that two neighbouring half pixels of a curved mirror reflect
// at position t. A mirror turned by an angle turns reflected rays by twice that angle. The distance in pixels between the
// points of neighbouring pixels is the same number.
FUNCTION float spreadAt(MirrorWay way, float t) {
  float perAcross = exactInverseSqrt(exactDot(vec3(view.rayAcross), vec3(view.rayAcross)));
#ifdef PARALLEL
  precise float spread = way.turns * metresAlong(way, t) * perAcross;
#else
  precise float there = way.nearness + way.rate * t;
  precise float spread = way.turns * metresAlong(way, t) * perAcross * max(there, 0.0f);
#endif
  return spread;
}

// Nearness of the half pixels around a half pixel: left, right, above and below it.
FUNCTION vec4 nearnessAround(ivec2 at) {
  return vec4(nearestAt(0, at - ivec2(1, 0)), nearestAt(0, at + ivec2(1, 0)), nearestAt(0, at - ivec2(0, 1)),
              nearestAt(0, at + ivec2(0, 1)));
}

// Returns the change of nearness per half pixel to the right and downwards.
FUNCTION vec2 slopesAt(vec4 around, float here) {
  return vec2(slopeBetween(around.x, here, around.y), slopeBetween(around.z, here, around.w));
}

// Returns the weight of a half pixel that shows an object narrower than a half pixel: both neighbours on opposite sides
// are farther away. The light of such a half pixel is mostly light from behind the object.
FUNCTION float widthWeight(vec4 around, float here) {
  precise float across = here - max(around.x, around.y);
  precise float down = here - max(around.z, around.w);
  precise float part = max(across, down) * exactReciprocal(max(partOf(here, 0.04f), 1e-18f)) - 1.0f;
  precise float counts = 1.0f - easedBetween(part);
  return counts;
}

// Bilinear weights of four cells: the first cell and those to the right of it, below it, and diagonally below it.
struct CellsAround {
  ivec2 first;
  vec4 weights;
};

// Returns the bilinear weights of the cells of a level around a position (half pixels). Cells that show an object other
// than the one of nearness `nearest` have the weight 0, unless there are only such cells. For nearest = 0, all cells
// count.
FUNCTION CellsAround cellsAround(int level, vec2 place, float nearest) {
  precise float perCell = intBitsToFloat((127 - level) << 23);
  precise vec2 at = place * perCell - 0.5f;
  vec2 low = floor(at);
  precise vec2 share = at - low;
  precise vec2 rest = 1.0f - share;
  ivec2 first = ivec2(low);
  precise vec4 weights = vec4(rest.x * rest.y, share.x * rest.y, rest.x * share.y, share.x * share.y);
  vec4 nears = vec4(nearestAt(level, first), nearestAt(level, first + ivec2(1, 0)), nearestAt(level, first + ivec2(0, 1)),
                    nearestAt(level, first + 1));
  precise float maximum = partOf(nearest, 0.04f) * intBitsToFloat((127 + level) << 23);
  precise vec4 off = nears - vec4(nearest);
  vec4 differs = abs(off);
  vec4 counts = vec4(differs.x < maximum ? weights.x : 0.0f, differs.y < maximum ? weights.y : 0.0f,
                     differs.z < maximum ? weights.z : 0.0f, differs.w < maximum ? weights.w : 0.0f);
  precise float sum = (counts.x + counts.y) + (counts.z + counts.w);
  bool any_ = nearest > 0.0f && sum > 0.001f;
  precise vec4 whole = counts * exactReciprocal(any_ ? sum : 1.0f);
  CellsAround cells;
  cells.first = first;
  cells.weights = any_ ? whole : weights;
  return cells;
}

// Returns the mean nearness of the object of nearness `nearest` at a position in half pixels.
FUNCTION float nearnessIn(vec2 place, float nearest) {
  CellsAround cells = cellsAround(0, place, nearest);
  vec4 w = cells.weights;
  precise float mean =
      (w.x * nearestAt(0, cells.first) + w.y * nearestAt(0, cells.first + ivec2(1, 0))) +
      (w.z * nearestAt(0, cells.first + ivec2(0, 1)) + w.w * nearestAt(0, cells.first + 1));
  return mean;
}

// Returns the bilinear fraction, at a position in half pixels, of half pixels that show an object.
FUNCTION float shownAround(vec2 place) {
  precise vec2 at = place - 0.5f;
  vec2 low = floor(at);
  precise vec2 share = at - low;
  ivec2 first = ivec2(low);
  float a = nearestAt(0, first) > 0.0f ? 1.0f : 0.0f, b = nearestAt(0, first + ivec2(1, 0)) > 0.0f ? 1.0f : 0.0f;
  float c = nearestAt(0, first + ivec2(0, 1)) > 0.0f ? 1.0f : 0.0f, d = nearestAt(0, first + 1) > 0.0f ? 1.0f : 0.0f;
  precise float above = a + (b - a) * share.x;
  precise float below = c + (d - c) * share.x;
  precise float mean = above + (below - above) * share.y;
  return mean;
}

// Returns the position between `low` and `high` at which the path meets a plane. The plane goes through the nearest
// point of a half pixel, with the slope from its neighbours. If the ray is behind that plane earlier, it came from the
// side of the object whose edge the half pixel shows; the result is then beyond `low`.
FUNCTION float meetingPlane(MirrorWay way, ivec2 at, float here, vec2 slope, float low, float high) {
  precise vec2 aside = way.from - (vec2(at) + 0.5f);
  // The nearest point of a half pixel is about a third of a half pixel from its centre.
  precise float bias = 0.3f * (abs(slope.x) + abs(slope.y));
  precise float separation = here - bias + (slope.x * aside.x + slope.y * aside.y) - way.nearness;
  precise float closing = way.rate - (slope.x * way.along.x + slope.y * way.along.y);
  bool closes = closing < -1e-12f;
  precise float t = separation * exactReciprocal(closes ? closing : 1.0f);
  precise float within = low + 2.0f;
  precise float early = low - 1.0f;
  return closes && t > early ? clamp(t, low, high) : within;
}

// A cell that the path crosses between t and `next`. `here` and `there` are the nearness of the ray at t and at `next`.
struct MirrorCell {
  ivec2 at;
  float nearest;
  float next;
  float here;
  float there;
};

// Returns the cell at t. `beyond` is 1 if the path goes towards larger cell coordinates. `perWay` is 1 / way.along.
FUNCTION MirrorCell mirrorCell(MirrorWay way, ivec2 beyond, vec2 perWay, float t, int level) {
  precise vec2 q = way.from + way.along * t;
  ivec2 at = ivec2(floor(q)) >> level;
  precise vec2 edge = vec2((at + beyond) << level) - way.from;
  precise vec2 ends = edge * perWay;
  float leaves = min(abs(way.along.x) < 1e-6f ? 1e9f : ends.x, abs(way.along.y) < 1e-6f ? 1e9f : ends.y);
  precise float next = max(leaves, t) + 0.015625f;
  precise float here = way.nearness + way.rate * t;
  precise float there = way.nearness + way.rate * next;
  MirrorCell cell;
  cell.at = at;
  cell.nearest = nearestAt(level, at);
  cell.next = next;
  cell.here = here;
  cell.there = there;
  return cell;
}

// Returns the assumed thickness of the object in the cell, as a difference of nearness. Far objects are at least 1/24 of
// their distance thick, because a half pixel of a grazing ray is long there.
FUNCTION float thickAt(MirrorCell cell) {
#ifdef PARALLEL
  return mirrorReach_.y;
#else
  precise float thick = mirrorReach_.y * cell.nearest * max(cell.here, cell.there);
  precise float minimum = 0.0416666667f * cell.nearest;
  return max(thick, minimum);
#endif
}

// Returns the first hit of a path after position `start` on an object other than the one of nearness `passed` (0: on any
// object).
FUNCTION MirrorHit followMirrored(MirrorWay way, float start, float passed) {
  vec2 perWay = vec2(exactReciprocal(abs(way.along.x) < 1e-6f ? 1e-6f : way.along.x),
                     exactReciprocal(abs(way.along.y) < 1e-6f ? 1e-6f : way.along.y));
  ivec2 beyond = ivec2(way.along.x > 0.0f ? 1 : 0, way.along.y > 0.0f ? 1 : 0);
  float minimum = partOf(way.nearness, 0.002f);
  float same = partOf(passed, 0.04f);
  precise float ownPlane = way.nearness + 0.75f * (abs(way.slope.x) + abs(way.slope.y)) + minimum;
  float t = start;
  bool met = false;
  int level = 0;
  for (int k = 0; k < mirrorSteps; ++k) {
    if (t >= way.end || met) break;
    MirrorCell cell = mirrorCell(way, beyond, perWay, t, level);
    bool behind = cell.nearest > min(cell.here, cell.there);
    precise vec2 aside = vec2(cell.at) + 0.5f - way.from;
#if defined REFRACTED || defined GROUND_MIRROR
    const float own = 0.0f;
#else
    precise float own = ownPlane + (way.slope.x * aside.x + way.slope.y * aside.y);
#endif
    precise float deep = cell.nearest - max(cell.here, cell.there);
    precise float apart = cell.nearest - passed;
    bool other = passed == 0.0f || abs(apart) >= same;
    met = behind && level == 0 && other && cell.nearest > own && deep < thickAt(cell);
    t = met || (behind && level > 0) ? t : cell.next;
    level = behind ? max(level - 1, 0) : min(level + 2, lastLevel);
  }
  MirrorHit hit;
  hit.at = 0.0f;
  hit.counts = 0.0f;
  hit.covers = 0.0f;
  hit.nearest = 0.0f;
  hit.inwards = vec2(0.0f);
  IF_ANY(met) {
    MirrorCell cell = mirrorCell(way, beyond, perWay, t, 0);
    vec4 around = nearnessAround(cell.at);
    vec2 slope = slopesAt(around, cell.nearest);
    hit.at = meetingPlane(way, cell.at, cell.nearest, slope, t, cell.next);
    hit.spread = spreadAt(way, hit.at);
    hit.nearest = cell.nearest;
    hit.inwards = wayInwards(around, cell.nearest);
    precise float slopes = abs(slope.x) + abs(slope.y);
    precise vec2 inside = way.from + way.along * hit.at + hit.inwards;
    precise float metDeep = 0.5f * (cell.nearest + nearnessIn(inside, cell.nearest)) - max(cell.here, cell.there);
    precise float deep = metDeep - min(slopes, partOf(cell.nearest, 0.01f));
    precise float part = deep * (1.0f + 16.0f * hit.spread) * exactReciprocal(max(thickAt(cell), 1e-18f));
#ifdef REFRACTED
    const float bent = 0.0f;
#else
    precise float bent = (hit.spread - 0.5f) * 0.4f;
#endif
    precise vec2 first = way.from + way.along * hit.at;
    precise vec2 later = way.from + way.along * (t + 2.0f);
    float shown = max(shownAround(first), shownAround(later));
#ifdef REFRACTED
    float wide = widthWeight(around, cell.nearest);
#else
    // Neighbouring half pixels differ at narrow objects, so these are traced per pixel.
    const float wide = 1.0f;
#endif
    precise float covers = (1.0f - easedBetween(part)) * shown * wide;
    precise float counts = covers * (1.0f - easedBetween(bent));
    hit.covers = covers;
    hit.counts = counts;
  }
  return hit;
}

// Returns the mean light of the object of nearness `nearest` in the four cells of a level around a position (half
// pixels).
FUNCTION vec4 litAround(int level, vec2 place, float nearest) {
  CellsAround cells = cellsAround(level, place, nearest);
  vec4 w = cells.weights;
  precise vec4 mean = (w.x * litAt(level, cells.first) + w.y * litAt(level, cells.first + ivec2(1, 0))) +
                      (w.z * litAt(level, cells.first + ivec2(0, 1)) + w.w * litAt(level, cells.first + 1));
  return mean;
}

// Returns the light of the reflected objects times its weight, and the weight in w. The surroundings supply the
// remaining light. For a rough mirror the light is averaged over half the width of its lobe, 2 roughness^2 per metre of
// distance.
FUNCTION vec4 lightMirrored(MirrorWay way, MirrorHit hit, float roughness) {
  precise vec2 q = way.from + way.along * hit.at;
  precise vec2 size = cellsPerPixel_ * vec2(view.size);
  precise vec2 other = size - q;
  precise float inwards = min(min(q.x, q.y), min(other.x, other.y)) * 10.0f * exactReciprocal(size.y);
  precise float there = way.nearness + way.rate * hit.at;
  float metres = metresAlong(way, hit.at);
  precise float part = 2.0f * metres * exactReciprocal(mirrorReach_.x) - 1.0f;
  precise float counts = way.counts * hit.counts * easedBetween(inwards) * (1.0f - easedBetween(part));
  float perAcross = exactInverseSqrt(exactDot(vec3(view.rayAcross), vec3(view.rayAcross)));
#ifdef PARALLEL
  precise float wide = 2.0f * cellsPerPixel_ * roughness * roughness * metres * perAcross;  // width of the lobe in half pixels
#else
  precise float wide = 2.0f * cellsPerPixel_ * roughness * roughness * metres * perAcross * max(there, 0.0f);
#endif
  precise float spread = wide + hit.spread;
  precise float doublings = exactLog(clamp(spread, 1.0f, 32.0f)) * 1.44269504f;
  float held = clamp(doublings, 0.0f, float(lastLevel));
  int level = min(int(held), lastLevel - 1);
  precise float share = held - float(level);
  precise vec2 inside = q + hit.inwards;
  vec4 fine = litAround(level, inside, hit.nearest), coarse = litAround(level + 1, inside, hit.nearest);
  precise vec4 light = (fine + (coarse - fine) * share) * counts;
#ifdef HAZE
  light = pictureThroughHaze(light, way.p, way.direction, metres);
#endif
  return light;
}

// Returns the light along a path and its weight. Where an object stops only a part of the ray, the rest goes on to the
// next object.
FUNCTION vec4 lightAlong(MirrorWay way, float roughness) {
  vec4 light = vec4(0.0f);
  float left = 1.0f, start = 0.0f, passed = 0.0f;
  for (int k = 0; k < 2; ++k) {
    if (left < 0.02f) break;
    MirrorHit hit = followMirrored(way, start, passed);
    float part = left;
    IF_ANY(hit.counts > 0.0f) {
      precise vec4 sum = light + part * lightMirrored(way, hit, roughness);
      light = sum;
    }
    precise float behind = part * (1.0f - hit.covers);
    left = hit.nearest > 0.0f ? behind : 0.0f;
    start = hit.at;
    passed = hit.nearest;
  }
  return light;
}
