// Contact with a deformed plane as a height field. Vertices are only displaced vertically from their rest positions;
// horizontal displacement by waves is ignored. Compiles as GLSL and as C++. The including file provides `heightGrid`
// (HeightGrid) and loadHeights(int), which returns the height at the start of the frame in x and at its end in y
// (metres), and first includes height_types.glsl and common/exact.glsl.

// Surface at (x, z) at a given time.
struct SurfacePoint {
  vec3 normal;   // Unit normal with y > 0
  float height;  // Height in metres
  float speed;   // Vertical velocity, m/s
  bool there;    // False if the point is outside the mesh
};

FUNCTION vec2 mixedHeights(vec2 a, vec2 b, float t) {
  precise vec2 mixed = (b - a) * t + a;
  return mixed;
}

// Interpolates between the values at the start and the end of the frame, at the current progress.
FUNCTION float heightWithin(vec2 values) {
  precise float value = (values.y - values.x) * heightGrid.progress + values.x;
  return value;
}

// Interpolates bilinearly between the four surrounding vertices a, b, c and d at the fractions u and v: h = mix(mix(a,
// b, u), mix(c, d, u), v). The slopes are dh/dx = mix(b - a, d - c, v) / cell and dh/dz = (lower - upper) / cell, and
// the normal is n = (-dh/dx, 1, -dh/dz) / |(-dh/dx, 1, -dh/dz)|.
FUNCTION SurfacePoint surfaceUnder(float px, float pz) {
  precise float x = (px - heightGrid.corner.x) * heightGrid.perCell.x;
  precise float z = (pz - heightGrid.corner.y) * heightGrid.perCell.y;
  float maxX = float(heightGrid.size.x - 1);
  float maxZ = float(heightGrid.size.y - 1);
  SurfacePoint s;
  s.there = x >= 0.0f && z >= 0.0f && x <= maxX && z <= maxZ;
  x = s.there ? x : 0.0f;  // The position of a lost particle may be NaN.
  z = s.there ? z : 0.0f;
  int column = min(int(floor(x)), heightGrid.size.x - 2);
  int row = min(int(floor(z)), heightGrid.size.y - 2);
  precise float u = x - float(column);
  precise float v = z - float(row);
  int i = row * heightGrid.size.x + column;
  vec2 a = vec2(loadHeights(i));
  vec2 b = vec2(loadHeights(i + 1));
  vec2 c = vec2(loadHeights(i + heightGrid.size.x));
  vec2 d = vec2(loadHeights(i + heightGrid.size.x + 1));
  vec2 upper = mixedHeights(a, b, u);
  vec2 lower = mixedHeights(c, d, u);
  vec2 here = mixedHeights(upper, lower, v);
  precise vec2 first = b - a;
  precise vec2 second = d - c;
  precise vec2 down = lower - upper;
  s.height = heightWithin(here);
  precise float rise = (here.y - here.x) * heightGrid.perFrame;
  s.speed = rise;
  precise float slopeX = heightWithin(mixedHeights(first, second, v)) * heightGrid.perCell.x;
  precise float slopeZ = heightWithin(down) * heightGrid.perCell.y;
  precise vec3 n = vec3(-slopeX, 1.0f, -slopeZ);
  n = n * exactInverseSqrt(exactDot(n, n));
  s.normal = n;
  return s;
}

struct Landing {
  vec3 position;
  vec3 velocity;
};

// Moves a point vertically up to the margin above the surface. The impact velocity, relative to the vertical velocity
// of the surface, is reversed and multiplied by the bounce fraction. A fraction of the tangential velocity remains.
FUNCTION Landing landed(vec3 position, vec3 velocity) {
  SurfacePoint s = surfaceUnder(position.x, position.z);
  precise float lowest = s.height + heightGrid.margin;
  bool touching = s.there && position.y < lowest;
  vec3 surface = vec3(0.0f, s.speed, 0.0f);
  precise vec3 relative = velocity - surface;
  float inward = exactDot(relative, s.normal);
  precise float back = -inward * heightGrid.bounce;
  back = max(inward, back);
  precise vec3 kept = (relative - s.normal * inward) * heightGrid.kept + s.normal * back + surface;
  Landing l;
  l.position = touching ? vec3(position.x, lowest, position.z) : position;
  l.velocity = touching ? kept : velocity;
  return l;
}
