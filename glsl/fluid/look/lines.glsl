// Line integral convolution (Cabral and Leedom, SIGGRAPH 1993): averages noise along the streamline through each pixel.
// Compiles as GLSL and as C++, after transport.glsl and look.glsl. `lineDetail` is the number of pixels per cell along
// each axis, and `linePerDetail` is its reciprocal. `linePhase` is the phase, in turns, of the ripples that move along
// the lines with the flow.
const int lineSteps = 26;  // Number of steps in each direction

// Returns white noise with one value in [0, 1) per pixel.
FUNCTION float grainAt(vec2 p) {
  precise float x = p.x * float(lineDetail);
  precise float y = p.y * float(lineDetail);
  uvec3 noise = hash3(uvec3(uint(int(floor(x))), uint(int(floor(y))), 17u));
  precise float grain = float(int(noise.x >> 8u)) * 5.9604645e-8f;
  return grain;
}

// Returns the weight of the sample at the position `along` (-1 to 1) on the line: a bell curve, modulated by ripples.
FUNCTION float lineWeight(float along) {
  precise float opening = 3.1415927f * along;
  precise float bell = 1.0f + exactCos(opening);
  precise float turn = 1.5f * along - linePhase;
  precise float angle = 6.2831853f * (turn - floor(turn));
  precise float weight = bell * (1.0f + 0.8f * exactCos(angle));
  return weight;
}

// Moves p by one Euler step of 3/4 pixel along the flow, or against it if `way` is negative. Does not move p where the
// fluid is at rest.
FUNCTION vec2 alongLine(vec2 p, float way) {
  vec2 velocity = velocityAt(p);
  precise float square = velocity.x * velocity.x + velocity.y * velocity.y;
  float inverse_ = exactInverseSqrt(max(square, 1e-12f));
  precise float length_ = 0.75f * way * linePerDetail * inverse_;
  precise vec2 next = p + velocity * length_;
  return square > 1e-10f ? heldPoint(next) : p;
}

// Returns the weighted mean of the noise along the line through p, with increased contrast, between 0 and 1.
FUNCTION float lineAt(vec2 p) {
  float middle = lineWeight(0.0f);
  precise float sum = middle * grainAt(p);
  precise float weights = middle;
  vec2 before = p, after = p;
  for (int i = 1; i <= lineSteps; ++i) {
    precise float along = float(i) * 0.037037037f;
    before = alongLine(before, -1.0f);
    after = alongLine(after, 1.0f);
    float weightBefore = lineWeight(-along), weightAfter = lineWeight(along);
    sum = sum + (weightBefore * grainAt(before) + weightAfter * grainAt(after));
    weights = weights + (weightBefore + weightAfter);
  }
  precise float mean = sum * exactReciprocal(weights);
  precise float spread = 0.5f + 3.2f * (mean - 0.5f);
  return clamp(spread, 0.0f, 1.0f);
}

FUNCTION float speedAt(vec2 p) {
  vec2 velocity = velocityAt(p);
  precise float square = velocity.x * velocity.x + velocity.y * velocity.y;
  return exactSqrt(square);
}

// Returns the colour of a pixel, from the colour of its speed and the line's brightness.
FUNCTION vec4 lineColor(vec4 ofSpeed, float line) {
  precise float light = 0.10f + 1.15f * line * line;
  precise vec4 color = ofSpeed * light;
  return color;
}
