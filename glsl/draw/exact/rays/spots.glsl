// Places that pixels show, as the kernels keep them that else would light them: four texels each, at the first of a pixel's
// samples that shows it. Rays find their light afterwards.
#ifndef EXACT_RAY_SPOTS
#define EXACT_RAY_SPOTS
#include "draw/exact/rays/bindings.glsl"
#include "draw/exact/unit_vector.glsl"
layout(std430, binding = outSpotBinding) writeonly restrict buffer SpotBlock { uvec4 spots[]; };

// `facing`: the side of the surface that is seen, of which `normal` is what shading makes. `share`: of the light that gets there. `owner`:
// of the table of looks, and in bit 31 whether it is seen from within; `smooth_`: the normal without relief; `lift`: how far
// the place is above the flat triangle (m).
void keepSpot(int sampleAt, vec3 p, vec3 facing, vec3 normal, vec3 base, vec3 material, float share, uint owner, vec3 smooth_, float lift) {
  spots[4 * sampleAt] = uvec4(floatBitsToUint(p), packedUnit(facing));
  spots[4 * sampleAt + 1] = uvec4(floatBitsToUint(base), packedUnit(normal));
  spots[4 * sampleAt + 2] = uvec4(floatBitsToUint(material), floatBitsToUint(share));
  spots[4 * sampleAt + 3] = uvec4(owner, packedUnit(smooth_), floatBitsToUint(lift), 0u);
}
void keepSpot(int sampleAt, vec3 p, vec3 facing, vec3 normal, vec3 base, vec3 material, float share) {
  keepSpot(sampleAt, p, facing, normal, base, material, share, 0u, facing, 0.0f);
}
// Once it is known, with layers before the spot.
void keepShare(int sampleAt, float share) {
  spots[4 * sampleAt + 2].w = floatBitsToUint(share);
}
#endif
