// Places that pixels show, as the kernels keep them that else would light them: three texels each, at the first of a pixel's
// samples that shows it. Rays find their light afterwards.
#ifndef EXACT_RAY_SPOTS
#define EXACT_RAY_SPOTS
#include "draw/exact/rays/bindings.glsl"
#include "draw/exact/unit_vector.glsl"
layout(std430, binding = outSpotBinding) writeonly restrict buffer SpotBlock { uvec4 spots[]; };

// `facing`: the side of the surface that is seen, of which `normal` is what shading makes. `share`: of the light that gets there.
void keepSpot(int sampleAt, vec3 p, vec3 facing, vec3 normal, vec3 base, vec3 material, float share) {
  spots[3 * sampleAt] = uvec4(floatBitsToUint(p), packedUnit(facing));
  spots[3 * sampleAt + 1] = uvec4(floatBitsToUint(base), packedUnit(normal));
  spots[3 * sampleAt + 2] = uvec4(floatBitsToUint(material), floatBitsToUint(share));
}
#endif
