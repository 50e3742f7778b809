// Adds the glows of instances to the sums. An invocation takes one after the other; LARGE: a group shares each one's pixels,
// in slices of SLICES rows of squares. SAMPLES: of the scene's depth.
#include "draw/frame_block.glsl"
#include "draw/instances/instance_list.glsl"
#include "draw/surface/facing.glsl"
#include "draw/instances/glow_block.glsl"
#include "draw/samples.glsl"
layout(binding = depthUnit) uniform SAMPLED sceneDepth;
uniform int strides;  // invocations; LARGE: groups
uniform float roundPixels;  // larger ones are squares in space, as the rasteriser draws them; smaller ones on the picture

Glow glowAt(uint at) {
  vec4 position, velocity;
  listed(at, position, velocity);
  return glowOf(position, velocity);
}

// `across`: square of the distance from the middle in radii.
void add(ivec2 pixel, vec3 light, float across, float depth) {
  if (across >= 1.0 || depth < 0.0) return;
  int before = 0;
  for (int i = 0; i < SAMPLES; ++i)
    before += int(depth < texelFetch(sceneDepth, pixel, SAMPLE(i)).x);
  float inside = (1.0 - across) * (1.0 - across) * float(before) / float(SAMPLES);
  // More than half floats hold shows white in any case.
  vec3 all = min(light * inside, 6e4);
  vec3 upper = floor(all / glowUpper);
  uvec3 lower = uvec3((all - upper * glowUpper) * glowUnits + 0.5);
  int word = glowWord(pixel);
  for (int i = 0; i < 3; ++i) {
    uint carry = uint(upper[i]);
    if (lower[i] != 0u && atomicAdd(glowSums[word + i], lower[i]) > 0xffffffffu - lower[i]) ++carry;
    if (carry != 0u) atomicAdd(glowSums[word + 3 + i], carry);
  }
}

vec3 placed(vec4 clip) {
  return clip.xyz / clip.w * 0.5 + 0.5;
}

// A disk on the picture, the pixels from `aside` on, `stride` apart.
void addDisk(Glow g, ivec2 aside, ivec2 stride) {
  vec3 place = placed(frame.viewProjection * vec4(g.middle, 1.0));
  vec2 middle = place.xy * frame.size;
  float radius = pixelsOf(g.middle, g.radius);
  ivec2 first = max(ivec2(ceil(middle - radius - 0.5)), 0) + aside;
  ivec2 last = min(ivec2(floor(middle + radius - 0.5)), ivec2(frame.size) - 1);
  for (int y = first.y; y <= last.y; y += stride.y)
    for (int x = first.x; x <= last.x; x += stride.x) {
      vec2 across = (vec2(x, y) + 0.5 - middle) / radius;
      add(ivec2(x, y), g.light, dot(across, across), place.z);
    }
}

#ifdef LARGE
layout(local_size_x = 8, local_size_y = 8) in;

// A disk that faces the eye, pixel by pixel through the picture's rays.
void addFacing(Glow g, ivec2 aside, ivec2 stride) {
  Facing facing = facingEye(g.middle);
  vec2 low = vec2(1), high = vec2(0);
  bool before = true;
  for (int corner = 0; corner < 4; ++corner) {
    vec3 outwards = float((corner & 1) * 2 - 1) * facing.right + float((corner & 2) - 1) * facing.up;
    vec4 clip = frame.viewProjection * vec4(g.middle + g.radius * outwards, 1.0);
    before = before && clip.w > 1e-4;
    vec2 place = placed(clip).xy;
    low = min(low, place);
    high = max(high, place);
  }
  // Partly behind the eye: anywhere.
  if (!before) low = vec2(0), high = vec2(1);
  ivec2 first = ivec2(clamp(low, 0.0, 1.0) * frame.size) + aside;
  ivec2 last = min(ivec2(clamp(high, 0.0, 1.0) * frame.size), ivec2(frame.size) - 1);
  for (int y = first.y; y <= last.y; y += stride.y)
    for (int x = first.x; x <= last.x; x += stride.x) {
      vec2 onPicture = (vec2(x, y) + 0.5) / frame.size * 2.0 - 1.0;
      vec3 ray = frame.rayForward.xyz + frame.rayRight.xyz * onPicture.x + frame.rayUp.xyz * onPicture.y;
      float towards = -dot(ray, facing.towards);
      if (towards <= 0.0) continue;
      vec3 hit = frame.eye.xyz + ray * (facing.distance / towards);
      vec3 off = (hit - g.middle) / g.radius;
      vec4 clip = frame.viewProjection * vec4(hit, 1.0);
      if (abs(clip.z) <= clip.w) add(ivec2(x, y), g.light, dot(off, off), placed(clip).z);
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
