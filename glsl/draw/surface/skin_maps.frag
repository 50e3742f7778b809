// A skin as maps that tile, a third at a time: part 0 albedo and roughness, part 1 normal and height, part 2 light
// of its own and openness. Row 0 of the picture is the field's row 0.
#include "draw/surface/skin.glsl"
uniform ivec2 mapSize;
uniform int part;
layout(location = 0) out vec4 values;

void main() {
  SkinArea area = skinArea(gl_FragCoord.xy / vec2(mapSize));
  Skin skin = skinOf(area);
  // x to the right, y up: against the rows.
  vec3 normal = normalize(vec3(-skinDepth * area.slope.x, skinDepth * area.slope.y, 1.0));
  values = part == 0 ? vec4(skin.albedo, skin.roughness)
                     : part == 1 ? vec4(normal, skin.height) : vec4(skin.emission, skin.openness);
}
