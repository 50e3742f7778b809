// The rays of paths, kind after kind, `paths` of each: towards the sun and a lamp from the spot, onwards, from what that meets towards a light
// and onwards. Of each what it brings if nothing is in the way (or what part of the light it meets counts); and behind those, what each path
// brings for certain: from the spot, and from what its ray meets.
#include "draw/exact/rays/hits.glsl"
const int sunKind = 0, lampKind = 1, onwardKind = 2, nextLightKind = 3, nextOnwardKind = 4;
const int spotSure = 5, nextSure = 6;
#ifdef PATHS_GO_ON
layout(std430, binding = outRayBinding) restrict buffer RayBlock { vec4 outRays[]; };
layout(std430, binding = outRayLightBinding) restrict buffer RayLightBlock { vec4 rayLight[]; };
#else
layout(std430, binding = outRayBinding) writeonly restrict buffer RayBlock { vec4 outRays[]; };
layout(std430, binding = outRayLightBinding) writeonly restrict buffer RayLightBlock { vec4 rayLight[]; };
#endif
uniform int paths;

void putRay(int kind, int path, vec3 origin, float note, vec3 direction, float far, vec4 light) {
  int i = kind * paths + path;
  outRays[2 * i] = vec4(origin, note);
  outRays[2 * i + 1] = vec4(direction, far);
  rayLight[i] = light;
}
void putNone(int kind, int path) {
  putRay(kind, path, vec3(0), 0.0f, vec3(0, 1, 0), 0.0f, vec4(0));
}
