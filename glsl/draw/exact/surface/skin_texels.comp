// Writes all mip levels of a skin's textures to one list of texels for draw/exact/surface/skin_read.glsl. A texel holds
// relief, ring mean and colour as half floats. One invocation writes one texel.
#include "draw/exact/bindings.glsl"
#include "draw/bindings.glsl"
layout(local_size_x = 64) in;
layout(binding = reliefUnit) uniform sampler2D relief;
layout(binding = surroundingsUnit) uniform sampler2D surroundings;
layout(binding = skinColorUnit) uniform sampler2D skinColors;
layout(std430, binding = outVertexBinding) writeonly restrict buffer TexelBlock { uvec4 texels[]; };
uniform ivec2 size;  // size of the skin's mip level 0 in texels
uniform int count;   // total number of texels of all mip levels
uniform bool colored;

void main() {
  int i = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (i >= count) return;
  int level = 0, rest = i;
  ivec2 across = size;
  while (rest >= across.x * across.y) {
    rest -= across.x * across.y;
    across = max(across >> 1, ivec2(1));
    ++level;
  }
  ivec2 at = ivec2(rest % across.x, rest / across.x);
  vec4 field = texelFetch(relief, at, level);
  float around = texelFetch(surroundings, at, level).x;
  vec3 color = vec3(0.0f);
  if (colored) color = texelFetch(skinColors, at, level).rgb;
  texels[i] = uvec4(packHalf2x16(field.xy), packHalf2x16(field.zw), packHalf2x16(vec2(around, color.x)), packHalf2x16(color.yz));
}
