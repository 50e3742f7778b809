// Rays of paths, stored kind by kind with `paths` rays of each kind. The kinds are: shadow rays from the spot to the
// sun and to a lamp, the continuation ray, and from its hit point a shadow ray and a second continuation ray. rayLight
// holds, for each ray, the light that the ray brings if nothing blocks it. For the first continuation ray, it holds the
// weight of the light at the hit point. Two more entries per path hold the light that needs no ray: of the spot and of
// the continuation ray's hit point. LISTS_RAYS: rays that bring light are listed; others are not traced.
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
#ifdef LISTS_RAYS
layout(std430, binding = outListBinding) writeonly restrict buffer RayListBlock { uint listedRays[]; };
layout(std430, binding = outCountBinding) restrict buffer RayListCountBlock { uint counters[2]; };
#include "draw/exact/list_place.glsl"
#endif
uniform int paths;

void putRay(int kind, int path, vec3 origin, float note, vec3 direction, float far, vec4 light) {
  int i = kind * paths + path;
  outRays[2 * i] = vec4(origin, note);
  outRays[2 * i + 1] = vec4(direction, far);
  rayLight[i] = light;
}
void putNone(int kind, int path) {
  int i = kind * paths + path;
  outRays[2 * i + 1] = vec4(0, 1, 0, 0);
  rayLight[i] = vec4(0);
}
#ifdef LISTS_RAYS
// Stores a ray that may bring light and appends it to list 0 or 1. Each list has room for `paths` entries.
void putLightRay(int list, int kind, int path, vec3 origin, vec3 direction, float far, vec3 light) {
  if (max(light.x, max(light.y, light.z)) <= 0.0f) {
    putNone(kind, path);
    return;
  }
  putRay(kind, path, origin, 0.0f, direction, far, vec4(light, 0.0f));
  listedRays[uint(list * paths) + nextPlace(list)] = uint(kind * paths + path);
}
#endif
