// Adds the glows of instances to the sums of glow_block.glsl. One invocation adds whole glows one after another. LARGE:
// a workgroup splits the pixels of each glow between its invocations, in SLICES slices of rows of 8 by 8 squares.
// SAMPLES: samples per pixel of the scene's depth.
#include "draw/frame_block.glsl"
#include "draw/instances/instance_list.glsl"
#include "draw/surface/facing.glsl"
#include "draw/instances/glow_block.glsl"
#include "draw/samples.glsl"
layout(binding = depthUnit) uniform SAMPLED sceneDepth;
// 1 / SAMPLES, computed from the bits of the float, because SAMPLES is a power of two.
const float perSamples = intBitsToFloat(0x7f000000 - floatBitsToInt(float(SAMPLES)));
uniform int strides;  // number of invocations; with LARGE, number of workgroups
uniform float roundPixels;  // max radius (pixels) of glows that are discs in the picture plane; larger glows are
                            // squares in space, as the rasterizer draws them

Glow glowAt(uint at) {
  vec4 position, velocity;
  listed(at, position, velocity);
  return glowOf(position, velocity);
}

// Adds light to a pixel. `across` is the squared distance from the glow's centre, in units of the radius.
void add(ivec2 pixel, vec3 light, float across, float depth) {
  if (across >= 1.0 || depth < 0.0) return;
  int before = 0;
  for (int i = 0; i < SAMPLES; ++i)
    before += int(depth < texelFetch(sceneDepth, pixel, SAMPLE(i)).x);
  precise float inside = (1.0 - across) * (1.0 - across) * float(before) * perSamples;
  precise vec3 all = light * inside;
  all = min(all, 6e4);  // limits the light, because larger values are displayed as white anyway
  precise vec3 large = all * perGlowUpper;
  vec3 upper = floor(large);
  precise vec3 units = (all - upper * glowUpper) * glowUnits + 0.5;
  uvec3 lower = uvec3(units);
  int word = glowWord(pixel);
  for (int i = 0; i < 3; ++i) {
    uint carry = uint(upper[i]);
    if (lower[i] != 0u && atomicAdd(glowSums[word + i], lower[i]) > 0xffffffffu - lower[i]) ++carry;
    if (carry != 0u) atomicAdd(glowSums[word + 3 + i], carry);
  }
}

// Returns the position in the picture (0 to 1) and the depth.
vec3 placed(vec4 clip) {
  precise vec3 place = clip.xyz * exactReciprocal(clip.w) * 0.5 + 0.5;
  return place;
}

// Adds a glow as a disc in the picture plane. `aside` and `stride` are the first pixel and the step, which split the
// pixels between invocations.
void addDisk(Glow g, ivec2 aside, ivec2 stride) {
  vec3 place = placed(clipPlace(g.middle));
  float radius = pixelsOf(g.middle, g.radius), perRadius = exactReciprocal(radius);
  precise vec2 middle = place.xy * frame.size - 0.5;
  precise vec2 low = middle - radius, high = middle + radius;
  ivec2 first = max(ivec2(ceil(low)), 0) + aside;
  ivec2 last = min(ivec2(floor(high)), ivec2(frame.size) - 1);
  for (int y = first.y; y <= last.y; y += stride.y)
    for (int x = first.x; x <= last.x; x += stride.x) {
      precise vec2 across = (vec2(x, y) - middle) * perRadius;
      precise float across2 = across.x * across.x + across.y * across.y;
      add(ivec2(x, y), g.light, across2, place.z);
    }
}

#ifdef LARGE
layout(local_size_x = 8, local_size_y = 8) in;

// Adds a glow as a disc in space that faces the eye. Intersects the camera ray of each pixel with the disc's plane.
void addFacing(Glow g, ivec2 aside, ivec2 stride) {
  Facing facing = facingEye(g.middle);
  bool parallel = frame.eye.w == 0.0;
  vec2 seen = clipPlace(g.middle).xy;  // position of the glow's centre in the picture, used for orthographic views
  vec2 low = vec2(1), high = vec2(0);
  bool before = true;
  for (int corner = 0; corner < 4; ++corner) {
    precise vec3 outwards = float((corner & 1) * 2 - 1) * facing.right + float((corner & 2) - 1) * facing.up;
    precise vec3 at = g.middle + g.radius * outwards;
    vec4 clip = clipPlace(at);
    before = before && clip.w > 1e-4;
    vec2 place = placed(clip).xy;
    low = min(low, place);
    high = max(high, place);
  }
  // A disc that is partly behind the eye may cover any pixel.
  if (!before) low = vec2(0), high = vec2(1);
  precise vec2 from = clamp(low, 0.0, 1.0) * frame.size, to = clamp(high, 0.0, 1.0) * frame.size;
  precise vec2 perSize = 2.0 * vec2(exactReciprocal(frame.size.x), exactReciprocal(frame.size.y));
  float perRadius = exactReciprocal(g.radius);
  ivec2 first = ivec2(from) + aside;
  ivec2 last = min(ivec2(to), ivec2(frame.size) - 1);
  for (int y = first.y; y <= last.y; y += stride.y)
    for (int x = first.x; x <= last.x; x += stride.x) {
      precise vec2 onPicture = (vec2(x, y) + 0.5) * perSize - 1.0;
      precise vec3 ray = frame.rayForward.xyz + frame.rayRight.xyz * onPicture.x + frame.rayUp.xyz * onPicture.y;
      float towards = -exactDot(ray, facing.towards);
      if (towards <= 0.0) continue;
      precise vec3 hit = frame.eye.xyz + ray * (facing.distance * exactReciprocal(towards));
      precise vec2 beside = (onPicture - seen) * facing.distance;
      precise vec3 level = g.middle + frame.rayRight.xyz * beside.x + frame.rayUp.xyz * beside.y;
      hit = parallel ? level : hit;
      precise vec3 off = (hit - g.middle) * perRadius;
      vec4 clip = clipPlace(hit);
      if (abs(clip.z) <= clip.w) add(ivec2(x, y), g.light, exactDot(off, off), placed(clip).z);
    }
}

void main() {
  uint count = texelFetch(arguments, level * 8 + 6).x;
  ivec2 aside = ivec2(gl_LocalInvocationID.xy) + ivec2(0, 8 * gl_WorkGroupID.y);
  const ivec2 stride = ivec2(8, 8 * SLICES);
  for (uint at = gl_WorkGroupID.x; at < count; at += uint(strides)) {
    Glow g = glowAt(at);
    if (pixelRadius(g.middle, g.radius) <= roundPixels && isMiddleSeen(g.middle))
      addDisk(g, aside, stride);
    else
      addFacing(g, aside, stride);
  }
}
#else
layout(local_size_x = 64) in;

void main() {
  uint count = texelFetch(arguments, level * 8 + 6).x;
  for (uint at = gl_GlobalInvocationID.x; at < count; at += uint(strides))
    addDisk(glowAt(at), ivec2(0), ivec2(1));
}
#endif
