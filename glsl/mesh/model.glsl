// Displacements of a vertex, used by all techniques. Compiles as GLSL and as C++ (src/sim/mesh/deform_cpu.cpp). The
// including file provides `deformStep` (DeformStep) and loadTrail(int), and first includes types.glsl and
// common/exact.glsl. Phases are reduced to one turn on the CPU, so that they do not lose precision over time.

// Ripple: y += sin(phase - k r) amplitude e^(-decay r), where k is the wavenumber and r the distance from the centre in
// the rest shape.
FUNCTION vec3 rippled(RippleStep d, vec3 rest, vec3 p) {
  precise vec3 from = rest - vec3(d.centre);
  float far = exactSqrt(exactDot(from, from));
  precise float theta = d.phase - far * d.wavenumber;
  precise float lift = exactSin(theta) * d.amplitude;
  precise float loss = -far * d.decay;
  if (d.decay > 0.0f) lift = lift * exactExp(loss);
  precise float y = p.y + lift;
  return vec3(p.x, y, p.z);
}

// Gerstner wave: theta = k (n . p) - phase, where k is the wavenumber, n the heading and p the rest position. The
// displacement is n surge cos theta horizontally and amplitude sin theta vertically.
FUNCTION vec3 waved(WaveStep d, vec3 rest, vec3 p) {
  precise float theta = (rest.x * d.heading.x + rest.z * d.heading.y) * d.wavenumber - d.phase;
  precise float along = exactCos(theta) * d.surge;
  precise float lift = exactSin(theta) * d.amplitude;
  precise vec3 shift = vec3(d.heading.x * along, lift, d.heading.y * along);
  precise vec3 moved = p + shift;
  return moved;
}

// Sway: bends upright shapes in the wind. h is the height above the base as a fraction of the shape's height H. With
// the amplitude A, the horizontal shift along the heading is A h^2 (lean + gusts(x, z, t)). The tip sinks by shift^2 /
// (2 H h), like the tip of a bent blade of constant length.
FUNCTION vec3 swayed(SwayStep d, vec3 rest, vec3 p) {
  precise float h = (rest.y - d.base) * d.perHeight;
  h = max(h, 0.0f);
  precise float along = (rest.x * d.heading.x + rest.z * d.heading.y) * d.wavenumber;
  precise float across = (rest.z * d.heading.x - rest.x * d.heading.y) * d.wavenumber;
  precise float slow = along + across * 0.37f - d.phases.x;
  precise float middle = along * 2.3f - across * 1.7f - d.phases.y;
  precise float quick = along * 7.9f + across * 9.1f - d.phases.z;
  precise float gust = 0.55f * exactSin(slow) + 0.3f * exactSin(middle) + 0.15f * exactSin(quick);
  precise float bend = (gust * d.gusts + d.lean) * d.amplitude * h;
  precise float lean = bend * h;
  precise float sink = bend * bend * h * d.perHeight * 0.5f;
  precise vec3 shift = vec3(d.heading.x * lean, -sink, d.heading.y * lean);
  precise vec3 moved = p + shift;
  return moved;
}

// Interpolates the trail between the four surrounding cells: x is the depth, y the rim height, in metres.
FUNCTION vec2 trailAt(vec3 rest) {
  precise float x = (rest.x - deformStep.trail.corner.x) * deformStep.trail.perCell.x;
  precise float z = (rest.z - deformStep.trail.corner.y) * deformStep.trail.perCell.y;
  x = clamp(x, 0.0f, float(deformStep.trail.cells.x - 1));
  z = clamp(z, 0.0f, float(deformStep.trail.cells.y - 1));
  int column = min(int(floor(x)), deformStep.trail.cells.x - 2);
  int row = min(int(floor(z)), deformStep.trail.cells.y - 2);
  precise float u = x - float(column);
  precise float v = z - float(row);
  int i = row * deformStep.trail.cells.x + column;
  vec2 a = vec2(loadTrail(i));
  vec2 b = vec2(loadTrail(i + 1));
  vec2 c = vec2(loadTrail(i + deformStep.trail.cells.x));
  vec2 d = vec2(loadTrail(i + deformStep.trail.cells.x + 1));
  precise vec2 upper = a + (b - a) * u;
  precise vec2 lower = c + (d - c) * u;
  precise vec2 here = upper + (lower - upper) * v;
  return here;
}

// Moves a point down by the depth of the print, and up by the height of the rim beside it. The rim vanishes where the
// depth reaches twice the rim's height, so that its inner side is wider than a cell, also in prints of balls.
FUNCTION vec3 pressed(vec3 rest, vec3 p) {
  vec2 print_ = trailAt(rest);
  precise float rim = print_.y - print_.x * 0.5f;
  rim = max(rim, 0.0f);
  precise float y = p.y + (rim - print_.x);
  return vec3(p.x, y, p.z);
}

FUNCTION vec3 nearestOf(Presser s, vec3 p) {
  precise vec3 axis = vec3(s.end) - vec3(s.start);
  precise vec3 from = p - vec3(s.start);
  precise float t = exactDot(from, axis) * s.perLength2;
  t = clamp(t, 0.0f, 1.0f);
  precise vec3 nearest = vec3(s.start) + axis * t;
  return nearest;
}

// Returns the vector from the nearest point of a presser's axis to the point from which rooted shapes are pushed: the top
// of a ball or of a horizontal capsule, and the axis of a vertical capsule. Blades below a ball therefore bend to the
// ground. From the middle of the ball, the two sides of a blade would part and cover the ball.
FUNCTION vec3 liftOf(Presser s) {
  precise vec3 axis = vec3(s.end) - vec3(s.start);
  precise float slope = axis.y * s.perLength2;
  precise vec3 level = axis * slope;
  precise vec3 lift = (vec3(0.0f, 1.0f, 0.0f) - level) * s.radius;
  return lift;
}

// Pushes a point of a rooted shape away from the top of a presser. `nearest` is the point's nearest point on the axis.
// Along the ray from the top, the surface is at the distance e and the end of the effect at f, and a distance t < f
// becomes e + t (f - e) / f. Returns the displacement.
FUNCTION vec3 bent(Presser s, vec3 nearest, float limit, vec3 p) {
  vec3 lift = liftOf(s);
  precise vec3 from = p - (nearest + lift);
  float inverse = exactInverseSqrt(max(exactDot(from, from), 1e-12f));
  precise float along = exactDot(from, lift) * inverse;
  float lifted = exactDot(lift, lift);
  precise float inner = along * along + (s.radius * s.radius - lifted);
  precise float outer = along * along + (limit - lifted);
  precise float surface = exactSqrt(max(inner, 0.0f)) - along;
  precise float end = exactSqrt(max(outer, 0.0f)) - along;
  precise float grown = surface * (inverse - exactReciprocal(end));
  precise vec3 displacement = from * grown;
  return displacement;
}

// Pushes a point away from moving pressers. With the softness s, a distance r < R + s from the axis of a presser of
// radius R becomes R + r s / (R + s). Shapes rooted at the base are pushed away from the presser's top, by an effect that
// grows with the height above the base.
FUNCTION vec3 pushed(PushStep d, vec3 rest, vec3 p) {
  precise float weight = (rest.y - d.base) * d.perHeight;
  weight = clamp(weight, 0.0f, 1.0f);
  weight = d.perHeight > 0.0f ? weight : 1.0f;
  for (int i = 0; i < deformStep.presserCount; ++i) {
    Presser s = deformStep.pressers[i];
    precise float reach = s.radius + d.softness;
    vec3 nearest = nearestOf(s, p);
    precise vec3 from = p - nearest;
    float squared = exactDot(from, from);
    precise float limit = reach * reach;
    float inverse = exactInverseSqrt(max(squared, 1e-12f));
    precise float grown = s.radius * inverse + d.softness * exactReciprocal(reach) - 1.0f;
    precise vec3 displacement = from * grown;
    if (d.perHeight > 0.0f) displacement = bent(s, nearest, limit, p);
    precise vec3 moved = p + displacement * weight;
    p = squared < limit ? moved : p;
  }
  return p;
}

FUNCTION vec3 displacedBy(int i, int kind, vec3 rest, vec3 p) {
  if (kind == rippleKind) return rippled(deformStep.displacements[i].ripple, rest, p);
  if (kind == waveKind) return waved(deformStep.displacements[i].wave, rest, p);
  if (kind == swayKind) return swayed(deformStep.displacements[i].sway, rest, p);
  if (kind == footprintsKind) return pressed(rest, p);
  if (kind == pushKind) return pushed(deformStep.displacements[i].push, rest, p);
  return p;
}

// Applies all displacements of the list in order to `p`. The rest position does not change.
#ifdef DISPLACEMENTS
// DISPLACEMENTS is the number of displacements. FIRST_KINDS and LAST_KINDS hold four bits per displacement, so that a
// kernel contains only code for the kinds in its list.
FUNCTION int kindOf(int i) {
  return (i < 8 ? FIRST_KINDS >> (4 * i) : LAST_KINDS >> (4 * (i - 8))) & 15;
}

FUNCTION vec3 displaced(vec3 rest) {
  vec3 p = rest;
#define TIMES DISPLACEMENTS
#define REPEATED(i) p = displacedBy(i, kindOf(i), rest, p);
#include "common/repeat.glsl"
  return p;
}
#else
FUNCTION vec3 displaced(vec3 rest) {
  vec3 p = rest;
  for (int i = 0; i < deformStep.displacementCount; ++i)
    p = displacedBy(i, deformStep.displacements[i].kind, rest, p);
  return p;
}
#endif

// Returns a trail cell after all pressers have acted. With the horizontal distance dx from the axis of a presser and
// the axis height y at that point, the depth of the print is height - (y - sqrt(R^2 - dx^2)). The rim beside the print
// decreases with the distance d from the print's edge as e^(-(d/width)^2).
FUNCTION vec4 trodden(ivec2 cell, vec4 before) {
  precise float x = float(cell.x) * deformStep.trail.cellSize.x + deformStep.trail.corner.x;
  precise float z = float(cell.y) * deformStep.trail.cellSize.y + deformStep.trail.corner.y;
  float height = deformStep.trail.height;
  float deepest = deformStep.trail.depth;
  for (int i = 0; i < deformStep.presserCount; ++i) {
    Presser s = deformStep.pressers[i];
    precise vec3 axis = vec3(s.end) - vec3(s.start);
    precise vec3 from = vec3(x - s.start.x, 0.0f, z - s.start.z);
    precise float t = exactDot(from, vec3(axis.x, 0.0f, axis.z)) * s.perFlat2;
    t = clamp(t, 0.0f, 1.0f);
    precise vec3 along = axis * t;
    precise vec3 offset = vec3(from.x - along.x, 0.0f, from.z - along.z);
    float across = exactDot(offset, offset);
    precise float square = s.radius * s.radius;
    precise float under = square - across;
    precise float below = height - (s.start.y + along.y);
    precise float print_ = below + exactSqrt(max(under, 0.0f));
    print_ = min(print_, deepest);
    bool over = under > 0.0f;
    before.x = over ? max(before.x, print_) : before.x;
    precise float deep = below + s.radius;  // Depth of the lowest point of the presser
    deep = min(deep, deepest);
    precise float inner = square - below * below;
    float edge = exactSqrt(max(inner, 0.0f));
    edge = below > 0.0f ? s.radius : edge;
    precise float d = exactSqrt(across) - edge;
    d = max(d, 0.0f) * deformStep.trail.perRimWidth;
    precise float fall = -d * d;
    precise float rim = exactExp(fall) * deformStep.trail.rim * deep;
    before.y = max(before.y, rim);
  }
  return before;
}
