// Visible spots: surface points that the shading kernels store instead of lighting them. The ray kernels light the
// spots later. A spot has four texels, stored at the index of the first sample of the pixel that shows the spot.
#ifndef EXACT_RAY_SPOTS
#define EXACT_RAY_SPOTS
#include "draw/exact/rays/bindings.glsl"
#include "draw/exact/unit_vector.glsl"
layout(std430, binding = outSpotBinding) writeonly restrict buffer SpotBlock { uvec4 spots[]; };

// Stores a spot. `facing` is the geometric normal that points to the viewer's side. `normal` is the shading normal.
// `share` is the fraction of the spot's light that reaches the picture. `owner` is the index in the material table,
// plus bit 31 if the spot is seen from inside. `smooth_` is the normal without relief. `lift` is the height of the
// point above the flat triangle (m).
void keepSpot(int sampleAt, vec3 p, vec3 facing, vec3 normal, vec3 base, vec3 material, float share, uint owner, vec3 smooth_, float lift) {
  spots[4 * sampleAt] = uvec4(floatBitsToUint(p), packedUnit(facing));
  spots[4 * sampleAt + 1] = uvec4(floatBitsToUint(base), packedUnit(normal));
  spots[4 * sampleAt + 2] = uvec4(floatBitsToUint(material), floatBitsToUint(share));
  spots[4 * sampleAt + 3] = uvec4(owner, packedUnit(smooth_), floatBitsToUint(lift), 0u);
}
void keepSpot(int sampleAt, vec3 p, vec3 facing, vec3 normal, vec3 base, vec3 material, float share) {
  keepSpot(sampleAt, p, facing, normal, base, material, share, 0u, facing, 0.0f);
}
// Replaces `share` of a stored spot when the light that the layers in front let through is known.
void keepShare(int sampleAt, float share) {
  spots[4 * sampleAt + 2].w = floatBitsToUint(share);
}
#endif
