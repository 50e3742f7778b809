// Motion of bodies, and their effect on the water. Compiles as GLSL and as C++, after water/float_model.glsl, with the
// same requirements.

// Returns the state of a body one step later.
FUNCTION FloatBody floatMoved(int stepNumber, FloatBody body, FloatParameters t, FloatSum sum) {
  FloatBody next = body;
  precise vec3 force = vec3(sum.push);
  precise vec3 moment = vec3(sum.turn);
  vec3 ahead = floatTurned(body.turn, vec3(0.0f, 0.0f, 1.0f));
  vec3 turning = floatTurning(t, body.turn, body.spin);
  // The tow line is a damped spring to its target position at the time of this step.
  precise float passed = float(stepNumber) * floats.dt;
  precise float towX = t.mass.x * (t.pull.x * (t.tow.x + passed * t.tow.z - body.at.x) + t.pull.y * (t.tow.z - body.velocity.x));
  precise float towZ = t.mass.x * (t.pull.x * (t.tow.y + passed * t.tow.w - body.at.z) + t.pull.y * (t.tow.w - body.velocity.z));
  precise float off = ahead.z * t.head.x - ahead.x * t.head.y;
  precise float facing = ahead.z * t.head.y + ahead.x * t.head.x;
  off = facing < 0.0f ? (off < 0.0f ? -1.0f : 1.0f) : off;
  precise float swing = t.mass.w * (t.pull.z * off - t.pull.w * turning.y);
  force = force + vec3(towX, 0.0f, towZ);
  moment = moment + vec3(0.0f, swing, 0.0f);
  precise vec3 velocity = body.velocity + floats.dt * t.mass.y * force;
  precise float falling = velocity.y - floats.dt * floats.gravity;
  velocity = vec3(clamp(velocity.x, -floats.maximum, floats.maximum), falling, clamp(velocity.z, -floats.maximum, floats.maximum));
  // Air drag acts on the part above the water; it is integrated implicitly.
  precise float over = t.grain.w - sum.rest.y;
  precise float dry = max(over, 0.0f) * exactReciprocal(t.grain.w);
  precise float slower = 1.0f + floats.dt * t.head.w * dry;
  precise float kept = exactReciprocal(slower);
  kept = t.head.w > 0.0f ? kept : 1.0f;
  velocity = velocity * kept;
  precise vec3 at = body.at + floats.dt * velocity;
  precise float wholeX = 2.0f * floats.halfX;
  precise float wholeZ = 2.0f * floats.halfZ;
  precise float leftX = at.x + wholeX;
  precise float rightX = at.x - wholeX;
  precise float backZ = at.z + wholeZ;
  precise float frontZ = at.z - wholeZ;
  if (floats.west == periodicEdge) at.x = at.x < -floats.halfX ? leftX : at.x > floats.halfX ? rightX : at.x;
  if (floats.north == periodicEdge) at.z = at.z < -floats.halfZ ? backZ : at.z > floats.halfZ ? frontZ : at.z;
  precise vec3 spin = (body.spin + floats.dt * moment) * kept;
  vec3 turned = floatTurning(t, body.turn, spin);
  vec4 q = body.turn;
  precise float half_ = 0.5f * floats.dt;
  precise vec3 axis = vec3(q) + half_ * (q.w * turned + exactCross(turned, vec3(q)));
  precise float real = q.w - half_ * exactDot(turned, vec3(q));
  precise float norm = exactDot(axis, axis) + real * real;
  precise vec4 unit = vec4(axis, real) * exactInverseSqrt(norm);
  precise float around = body.level + sum.rest.x * exactReciprocal(max(sum.turn.w, 1e-20f));
  around = sum.turn.w > 0.0f ? around : body.around;
  precise float first = body.stages.x + t.reach.y * (around - body.stages.x);
  precise float second = body.stages.y + t.reach.y * (body.stages.x - body.stages.y);
  precise float level = body.level + t.reach.y * (body.stages.y - body.level);
  next.at = at;
  next.level = level;
  next.turn = unit;
  next.velocity = velocity;
  next.under = sum.push.w;
  next.spin = spin;
  next.stages = vec2(first, second);
  next.around = around;
  next.wet = sum.rest.y;
  return next;
}

// Returns the window of cells that a body may affect: first column, first row, number of columns, number of rows.
FUNCTION ivec4 floatWindow(vec4 place, float half_) {
  precise float column = place.x * floats.perCell + floats.columns;
  precise float row = place.z * floats.perCell + floats.rows;
  int reach = int(half_);
  int x = int(floor(clamp(column, -30000.0f, 60000.0f))) - reach;
  int y = int(floor(clamp(row, -30000.0f, 60000.0f))) - reach;
  return ivec4(x, y, min(2 * reach + 1, size.x), min(2 * reach + 1, size.y));
}

// Returns the index of a cell if the cell is in the window of `body` but in no window of an earlier body, otherwise -1.
// `within` is the position in the window.
FUNCTION int floatOwned(int body, ivec2 within) {
  ivec4 window = floatWindow(loadFloat(body * floatTexels), loadParameters(body * floatParameterTexels + 5).x);
  if (within.x >= window.z || within.y >= window.w) return -1;
  int x = window.x + within.x, y = window.y + within.y;
  bool torusX = floats.west == periodicEdge, torusY = floats.north == periodicEdge;
  x = torusX ? floatColumn(x) : x;
  y = torusY ? floatRow(y) : y;
  if (x < 0 || y < 0 || x >= size.x || y >= size.y) return -1;
  for (int i = 0; i < body; ++i) {
    ivec4 other = floatWindow(loadFloat(i * floatTexels), loadParameters(i * floatParameterTexels + 5).x);
    int dx = x - other.x, dy = y - other.y;
    dx = torusX ? floatColumn(dx) : dx;
    dy = torusY ? floatRow(dy) : dy;
    if (dx >= 0 && dy >= 0 && dx < other.z && dy < other.w) return -1;
  }
  return y * size.x + x;
}

// Returns the texel of a cell after a step: its bodies now displace sums.x units of depth instead of sums.w, and have
// added sums.y and sums.z units of discharge. At a shore, a body that leaves little water behind would create a jet, so
// the speed is limited to half of the Courant number that steps allow.
FUNCTION vec4 floatPressed(vec4 texel, ivec4 sums) {
  precise float change = float(sums.x - sums.w) * floats.depthUnit;
  precise float level = texel.x + change;
  precise float qx = texel.y + float(sums.y) * floats.flowUnit;
  precise float qy = texel.z + float(sums.z) * floats.flowUnit;
  precise float depth = max(level, texel.w) - texel.w;
  precise float held = 0.25f * depth * floats.maximum;
  qx = clamp(qx, -held, held);
  qy = clamp(qy, -held, held);
  return vec4(sums.x == sums.w ? texel.x : max(waterFlush(level), texel.w), waterFlush(qx), waterFlush(qy), texel.w);
}

// Returns the displaced units of depth after floatPressed(). If a cell holds less water than it would have to give
// back, the remainder is kept as a debt.
FUNCTION int floatDisplaced(vec4 texel, ivec4 sums) {
  precise float depth = texel.x - texel.w;
  precise float units = depth * exactReciprocal(floats.depthUnit);
  int there = int(floor(min(max(units, 0.0f), 1e9f)));
  return max(sums.x, sums.w - there);
}
