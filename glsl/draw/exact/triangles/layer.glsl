// Depth peeling of blended surfaces (LAYER). At each sample, the next layer shows only triangles behind the previous
// layer, or at equal depth those with a higher id, and none behind opaque surfaces.
#include "draw/exact/bindings.glsl"
uniform bool firstLayer;
#ifdef PAIRED
layout(binding = layerNearUnit) uniform usamplerBuffer layerKeys;
layout(binding = behindUnit) uniform usamplerBuffer opaqueKeys;
uvec2 layerBefore(int at) {
  return texelFetch(layerKeys, at).yx;
}
uint opaqueKey(int at) {
  return texelFetch(opaqueKeys, at).y;
}
#else
layout(binding = layerNearUnit) uniform usamplerBuffer layerKeys;
layout(binding = layerIdUnit) uniform usamplerBuffer layerIds;
layout(binding = behindUnit) uniform usamplerBuffer opaqueKeys;
uvec2 layerBefore(int at) {
  return uvec2(texelFetch(layerKeys, at).x, texelFetch(layerIds, at).x);
}
uint opaqueKey(int at) {
  return texelFetch(opaqueKeys, at).x;
}
#endif

bool inLayer(int at, uint key, uint id) {
  if (key > opaqueKey(at)) return false;
  if (firstLayer) return true;
  uvec2 before = layerBefore(at);
  return key > before.x || (key == before.x && id > before.y);
}
