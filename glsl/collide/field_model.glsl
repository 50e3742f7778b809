// Contact with rigid meshes by their signed distance fields. Compiles as GLSL and as C++. The including file provides
// `meshData` (MeshColliders) and loadFieldCell(int), which returns the distances at a cell's eight corners, 16 bits
// each, x fastest.

// Value of a distance field at a point in the mesh's object space.
struct FieldPoint {
  bool there;       // True if the point is inside the grid of the field
  float distance_;  // Distance in metres, negative inside the mesh; outside the grid, a lower bound
  vec3 slope;       // Gradient of the distance
};

FUNCTION float lowHalf(uint word) {
  return float(int(word << 16u) >> 16);
}
FUNCTION float highHalf(uint word) {
  return float(int(word) >> 16);
}

FUNCTION float mixed(float a, float b, float t) {
  precise float value = a + (b - a) * t;
  return value;
}

// Interpolates the field trilinearly at q. The gradient is the exact derivative of the interpolation.
FUNCTION FieldPoint fieldAt(int k, vec3 q) {
  ivec4 cells = meshData.meshes[k].cells;
  vec4 corner = meshData.meshes[k].corner;
  float unit = meshData.meshes[k].unit;
  precise vec3 g = (q - vec3(corner)) * corner.w;
  vec3 last = vec3(float(cells.x), float(cells.y), float(cells.z));
  vec3 within = min(max(g, vec3(0.0f)), last);
  precise vec3 over = g - within;
  vec3 beside = abs(over);
  FieldPoint p;
  p.there = g.x >= 0.0f && g.y >= 0.0f && g.z >= 0.0f && g.x <= last.x && g.y <= last.y && g.z <= last.z;
  precise float maximum = max(max(beside.x, beside.y), beside.z) * meshData.meshes[k].cell;
  p.distance_ = maximum;
  p.slope = vec3(0.0f);
  if (p.there) {
    int x = min(int(floor(within.x)), cells.x - 1);
    int y = min(int(floor(within.y)), cells.y - 1);
    int z = min(int(floor(within.z)), cells.z - 1);
    precise float u = within.x - float(x);
    precise float v = within.y - float(y);
    precise float w = within.z - float(z);
    uvec4 words = loadFieldCell(cells.w + (z * cells.y + y) * cells.x + x);
    float a = lowHalf(words.x), b = highHalf(words.x), c = lowHalf(words.y), d = highHalf(words.y);
    float e = lowHalf(words.z), f = highHalf(words.z), h = lowHalf(words.w), i = highHalf(words.w);
    precise float ab = b - a;
    precise float cd = d - c;
    precise float ef = f - e;
    precise float hi = i - h;
    float lower = mixed(a, b, u), lowerFar = mixed(c, d, u), upper = mixed(e, f, u), upperFar = mixed(h, i, u);
    precise float alongLow = lowerFar - lower;
    precise float alongHigh = upperFar - upper;
    float low = mixed(lower, lowerFar, v), high = mixed(upper, upperFar, v);
    precise float alongZ = high - low;
    precise float scale = unit * corner.w;
    precise vec3 slope = vec3(mixed(mixed(ab, cd, v), mixed(ef, hi, v), w), mixed(alongLow, alongHigh, w), alongZ) * scale;
    precise float here = mixed(low, high, w) * unit;
    p.distance_ = here;
    p.slope = slope;
  }
  return p;
}

FUNCTION vec3 mapped(vec4 x, vec4 y, vec4 z, vec3 p) {
  precise float first = exactDot(vec3(x), p) + x.w;
  precise float second = exactDot(vec3(y), p) + y.w;
  precise float third = exactDot(vec3(z), p) + z.w;
  return vec3(first, second, third);
}

// Moves a particle out of mesh k, to the distance `margin`. If the particle has moved more than half a cell relative to
// the mesh since `before`, its path is traced in steps of the current distance (at least half a cell). The trace ends
// at the first point that is a quarter cell inside the mesh.
FUNCTION Motion outOfMesh(int k, Motion m, vec3 before, float margin, float bounce) {
  vec4 x = meshData.meshes[k].into[0], y = meshData.meshes[k].into[1], z = meshData.meshes[k].into[2];
  float cell = meshData.meshes[k].cell;
  vec3 q = mapped(x, y, z, m.position);
  vec3 surface = mapped(meshData.meshes[k].rate[0], meshData.meshes[k].rate[1], meshData.meshes[k].rate[2], q);
  precise vec3 way = m.position - before - surface * stepData.dt;
  vec3 across = vec3(exactDot(vec3(x), way), exactDot(vec3(y), way), exactDot(vec3(z), way));
  FieldPoint p = fieldAt(k, q);
  float squared = exactDot(across, across);
  precise float half_ = 0.5f * cell;
  precise float short_ = half_ * half_;
  precise float within = -0.5f * half_;
  precise float far = float(meshData.meshes[k].cells.x + meshData.meshes[k].cells.y + meshData.meshes[k].cells.z) * cell;
  precise float farther = p.distance_ * p.distance_;
  bool near = p.there || farther < squared;  // Otherwise, the end point is farther from the grid than the path is long,
                                             // so the path cannot have crossed the grid.
  precise float farSquared = 1e4f * far * far;
  if (squared > short_ && squared < farSquared && near) {
    float inverse = exactInverseSqrt(squared);
    precise vec3 start = q - across;
    FieldPoint first = fieldAt(k, start);
    bool outside = first.distance_ >= within;
    float reached = max(first.distance_, half_);
    for (int i = 0; i < 64 && outside; ++i) {
      precise float done = reached * inverse;
      if (done >= 1.0f) break;
      precise vec3 there = start + across * done;
      FieldPoint passed = fieldAt(k, there);
      if (passed.there && passed.distance_ < within) {
        p = passed;
        precise float rest = 1.0f - done;
        precise vec3 stopped = m.position - way * rest;
        m.position = stopped;
        break;
      }
      precise float further = reached + max(passed.distance_, half_);
      reached = further;
    }
  }
  precise float steep = exactDot(p.slope, p.slope);
  precise vec3 normal = vec3(x) * p.slope.x + vec3(y) * p.slope.y + vec3(z) * p.slope.z;
  normal = normal * exactInverseSqrt(max(steep, 1e-12f));
  precise float depth = margin - p.distance_;
  Touch touch;
  touch.depth = p.there && steep > 1e-6f ? depth : 0.0f;
  touch.normal = normal;
  touch.surface = surface;
  touch.grip = meshData.meshes[k].grip;
  touch.friction = meshData.meshes[k].friction;
  touch.bounce = bounce;
  return pushedOut(m, before, touch);
}
