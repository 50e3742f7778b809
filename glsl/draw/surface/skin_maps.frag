// Bakes a skin into tileable maps. Each draw writes one part: 0 albedo and roughness, 1 normal and height, 2 emission
// and openness. Row 0 of the target is the field's row 0.
#include "draw/surface/skin.glsl"
uniform ivec2 mapSize;
uniform int part;
layout(location = 0) out vec4 values;

void main() {
  SkinArea area = skinArea(gl_FragCoord.xy / vec2(mapSize));
  Skin skin = skinOf(area);
  // x points to the right. y points up, in the direction of decreasing row indices.
  vec3 normal = normalize(vec3(-skinDepth * area.slope.x, skinDepth * area.slope.y, 1.0));
  values = part == 0 ? vec4(skin.albedo, skin.roughness)
                     : part == 1 ? vec4(normal, skin.height) : vec4(skin.emission, skin.openness);
}
