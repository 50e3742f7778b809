// Where a vertex goes: every displacement, once, for all techniques. Compiles as GLSL and as C++
// (src/sim/mesh/deform_cpu.cpp). Whoever includes it provides `deformStep` (DeformStep) and loadTrail(int), and before
// it types.glsl and common/exact.glsl. Phases come reduced to one turn, so that time never loses bits.

// y = sin(t speed + 6 - k |p|) amplitude e^(-decay |p|), p from the centre and at rest.
// a: t speed + 6, amplitude, k (1/m), decay (1/m). b: centre.
FUNCTION vec3 rippled(Displacement d, vec3 rest, vec3 p) {
  precise vec3 from = rest - vec3(d.b);
  float far = exactSqrt(exactDot(from, from));
  precise float phase = far * d.a.z;
  phase = d.a.x - phase;
  precise float lift = exactSin(phase) * d.a.y;
  precise float loss = far * d.a.w;
  if (d.a.w > 0.0f) lift = lift * exactExp(-loss);
  precise float y = p.y + lift;
  return vec3(p.x, y, p.z);
}

// Gerstner: theta = k (n . p) - w t; p += (n Q A cos theta, A sin theta), p at rest in theta.
// a: n (x and z), k (1/m), A (m). b: w t, Q A (m).
FUNCTION vec3 waved(Displacement d, vec3 rest, vec3 p) {
  precise float x = rest.x * d.a.x;
  precise float z = rest.z * d.a.y;
  precise float theta = x + z;
  theta = theta * d.a.z;
  theta = theta - d.b.x;
  precise float along = exactCos(theta) * d.b.y;
  precise float lift = exactSin(theta) * d.a.w;
  precise vec3 shift = vec3(d.a.x * along, lift, d.a.y * along);
  precise vec3 moved = p + shift;
  return moved;
}

// Wind that bends what stands: with h the height above the base, 0 to 1 and beyond, the lean is
// A h^2 (lean + gusts(x, z, t)) along n, and the tip sinks by lean^2 / (2 H h) as a bent blade of kept length.
// a: n (x and z), A (m), 1/H (1/m). b: base (m), k (1/m), constant lean, share of the gusts. c: three phases.
FUNCTION vec3 swayed(Displacement d, vec3 rest, vec3 p) {
  precise float h = rest.y - d.b.x;
  h = h * d.a.w;
  h = max(h, 0.0f);
  precise float along = rest.x * d.a.x;
  precise float other = rest.z * d.a.y;
  along = along + other;
  along = along * d.b.y;
  precise float across = rest.z * d.a.x;
  other = rest.x * d.a.y;
  across = across - other;
  across = across * d.b.y;
  precise float theta = across * 0.37f;
  theta = along + theta;
  theta = theta - d.c.x;
  precise float gust = 0.55f * exactSin(theta);
  theta = along * 2.3f;
  other = across * 1.7f;
  theta = theta - other;
  theta = theta - d.c.y;
  other = 0.3f * exactSin(theta);
  gust = gust + other;
  theta = along * 7.9f;
  other = across * 9.1f;
  theta = theta + other;
  theta = theta - d.c.z;
  other = 0.15f * exactSin(theta);
  gust = gust + other;
  gust = gust * d.b.w;
  gust = gust + d.b.z;
  precise float bend = gust * d.a.z;
  bend = bend * h;
  precise float sink = bend * bend;
  bend = bend * h;
  sink = sink * h;
  sink = sink * d.a.w;
  sink = sink * 0.5f;
  precise vec3 shift = vec3(d.a.x * bend, -sink, d.a.y * bend);
  precise vec3 moved = p + shift;
  return moved;
}

// Between the four cells around: x depth (m), y rim (m).
FUNCTION vec2 trailAt(vec3 rest) {
  precise float x = rest.x - deformStep.trailPlace.x;
  precise float z = rest.z - deformStep.trailPlace.y;
  x = x * deformStep.trailPlace.z;
  z = z * deformStep.trailPlace.w;
  x = clamp(x, 0.0f, float(deformStep.trailCells.x - 1));
  z = clamp(z, 0.0f, float(deformStep.trailCells.y - 1));
  int column = min(int(floor(x)), deformStep.trailCells.x - 2);
  int row = min(int(floor(z)), deformStep.trailCells.y - 2);
  precise float u = x - float(column);
  precise float v = z - float(row);
  int i = row * deformStep.trailCells.x + column;
  vec2 a = vec2(loadTrail(i));
  vec2 b = vec2(loadTrail(i + 1));
  vec2 c = vec2(loadTrail(i + deformStep.trailCells.x));
  vec2 d = vec2(loadTrail(i + deformStep.trailCells.x + 1));
  precise vec2 step_ = b - a;
  step_ = step_ * u;
  precise vec2 upper = a + step_;
  step_ = d - c;
  step_ = step_ * u;
  precise vec2 lower = c + step_;
  step_ = lower - upper;
  step_ = step_ * v;
  upper = upper + step_;
  return upper;
}

// Down by the print's depth; beside it up by the rim, which is gone where the print is half as deep as it is high.
FUNCTION vec3 pressed(vec3 rest, vec3 p) {
  vec2 print_ = trailAt(rest);
  precise float lift = print_.x * 2.0f;
  lift = print_.y - lift;
  lift = max(lift, 0.0f);
  lift = lift - print_.x;
  precise float y = p.y + lift;
  return vec3(p.x, y, p.z);
}

FUNCTION vec3 nearestOf(Presser s, vec3 p) {
  precise vec3 axis = vec3(s.b) - vec3(s.a);
  precise vec3 from = p - vec3(s.a);
  precise float t = exactDot(from, axis) * s.b.w;
  t = clamp(t, 0.0f, 1.0f);
  precise vec3 nearest = axis * t;
  nearest = vec3(s.a) + nearest;
  return nearest;
}

// Out of what moves: a distance r < R + s from the axis of a presser of radius R becomes R + r s / (R + s).
// a: s (m), base (m), 1/height over which things rooted at the base give way (1/m; 0: all of it gives way).
FUNCTION vec3 pushed(Displacement d, vec3 rest, vec3 p) {
  precise float weight = rest.y - d.a.y;
  weight = weight * d.a.z;
  weight = clamp(weight, 0.0f, 1.0f);
  weight = d.a.z > 0.0f ? weight : 1.0f;
  for (int i = 0; i < deformStep.counts.y; ++i) {
    Presser s = deformStep.pressers[i];
    precise float reach = s.a.w + d.a.x;
    precise vec3 from = p - nearestOf(s, p);
    float squared = exactDot(from, from);
    precise float limit = reach * reach;
    float inverse = exactInverseSqrt(max(squared, 1e-12f));
    precise float grown = s.a.w * inverse;
    precise float kept = d.a.x * exactReciprocal(reach);
    grown = grown + kept;
    grown = grown - 1.0f;
    grown = grown * weight;
    precise vec3 shift = from * grown;
    precise vec3 moved = p + shift;
    p = squared < limit ? moved : p;
  }
  return p;
}

// All displacements of the list in its order. The rest position is only read.
FUNCTION vec3 displaced(vec3 rest) {
  vec3 p = rest;
  for (int i = 0; i < deformStep.counts.x; ++i) {
    Displacement d = deformStep.displacements[i];
    if (d.kind.x == rippleKind) p = rippled(d, rest, p);
    if (d.kind.x == waveKind) p = waved(d, rest, p);
    if (d.kind.x == swayKind) p = swayed(d, rest, p);
    if (d.kind.x == footprintsKind) p = pressed(rest, p);
    if (d.kind.x == pushKind) p = pushed(d, rest, p);
  }
  return p;
}

// What a cell of the trail keeps after every presser: with dx the distance to its axis seen from above and y its
// height there, the print is height - (y - sqrt(R^2 - dx^2)), the rim beside it falls with its distance d from the
// print's edge as e^(-(d/width)^2).
FUNCTION vec4 trodden(ivec2 cell, vec4 before) {
  precise float x = float(cell.x) * deformStep.trailShape.x;
  precise float z = float(cell.y) * deformStep.trailShape.y;
  x = x + deformStep.trailPlace.x;
  z = z + deformStep.trailPlace.y;
  float height = deformStep.trailShape.z;
  float deepest = deformStep.trailShape.w;
  for (int i = 0; i < deformStep.counts.y; ++i) {
    Presser s = deformStep.pressers[i];
    precise vec3 axis = vec3(s.b) - vec3(s.a);
    precise vec3 from = vec3(x - s.a.x, 0.0f, z - s.a.z);
    precise float t = exactDot(from, vec3(axis.x, 0.0f, axis.z)) * s.c.x;
    t = clamp(t, 0.0f, 1.0f);
    precise vec3 along = axis * t;
    precise vec3 offset = vec3(from.x - along.x, 0.0f, from.z - along.z);
    float across = exactDot(offset, offset);
    precise float y = s.a.y + along.y;
    precise float square = s.a.w * s.a.w;
    precise float under = square - across;
    precise float print_ = exactSqrt(max(under, 0.0f));
    precise float below = height - y;
    print_ = below + print_;
    print_ = min(print_, deepest);
    bool over = under > 0.0f;
    before.x = over ? max(before.x, print_) : before.x;
    precise float deep = below + s.a.w;  // of the presser's lowest point
    deep = min(deep, deepest);
    precise float edge = below * below;
    edge = square - edge;
    edge = exactSqrt(max(edge, 0.0f));
    edge = below > 0.0f ? s.a.w : edge;
    precise float d = exactSqrt(across);
    d = d - edge;
    d = max(d, 0.0f);
    d = d * deformStep.trailRim.y;
    d = d * d;
    precise float rim = exactExp(-d) * deformStep.trailRim.x;
    rim = rim * deep;
    before.y = max(before.y, rim);
  }
  return before;
}
