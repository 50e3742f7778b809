// Adds the light of paths to the visible surface points where they start (spots, see spots.glsl), sample by sample in a
// fixed order. The indirect light of a sample is scaled down if one of its channels is above `maximum`, which
// suppresses fireflies. One invocation handles one spot.
#include "draw/exact/rays/bindings.glsl"
#include "common/exact.glsl"
layout(local_size_x = 64) in;
const int onwardKind = 2, nextLightKind = 3, nextOnwardKind = 4, spotSure = 5, nextSure = 6;
layout(binding = spotListUnit) uniform usamplerBuffer spotList;
layout(binding = rayLightUnit) uniform samplerBuffer light;
layout(binding = rayHitUnit) uniform usamplerBuffer rayHits;
layout(std430, binding = outSpotLightBinding) restrict buffer SpotLightBlock { vec4 spotLight[]; };
uniform int paths;
uniform int firstSpot;
uniform int spotCount;
uniform int sampleCount;
uniform float maximum;

vec3 arriving(int kind, int path) {
  int i = kind * paths + path;
  vec3 brought = texelFetch(light, i).rgb;
  if (max(brought.x, max(brought.y, brought.z)) <= 0.0f) return vec3(0);  // rays without light are not traced
#ifdef PASSAGES
  precise vec3 found = brought * uintBitsToFloat(texelFetch(rayHits, i).xyz);
#else
  precise vec3 found = brought * uintBitsToFloat(texelFetch(rayHits, i).x);
#endif
  return found;
}
vec3 certain(int kind, int path) {
  return texelFetch(light, kind * paths + path).rgb;
}

void main() {
  int spot = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (spot >= spotCount) return;
  int at = int(texelFetch(spotList, firstSpot + spot).x);
  precise vec3 sum = spotLight[at].rgb;
  for (int s = 0; s < sampleCount; ++s) {
    int path = s * spotCount + spot;
    precise vec3 onward = certain(nextSure, path) + arriving(nextLightKind, path) + arriving(nextOnwardKind, path);
    float brightest = max(onward.x, max(onward.y, onward.z));
    precise float held = brightest > maximum ? maximum * exactReciprocal(brightest) : 1.0f;
    sum = sum + certain(spotSure, path) + arriving(0, path) + arriving(1, path) + onward * held;
  }
  spotLight[at] = vec4(sum, 0.0f);
}
