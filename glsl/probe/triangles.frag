// Reads textures in all the ways that the drawing passes use: sRGB, half floats, depth comparison.
#include "draw/bindings.glsl"
in vec3 place;
in vec3 normal;
in vec2 uv;
layout(binding = albedoUnit) uniform sampler2D picture;
layout(binding = reliefUnit) uniform sampler2D relief;
layout(binding = shadowUnit) uniform sampler2DShadow depths;
layout(location = 0) out vec4 light;

void main() {
  vec3 turned = normalize(gl_FrontFacing ? normal : -normal);
  float sun = max(dot(turned, vec3(0.48, 0.6, 0.64)), 0.0);
  vec4 grain = texture(relief, 0.7 * uv + place.xy);
  float open = texture(depths, vec3(uv, fract(place.z)));
  float edge = dFdx(uv.x) + dFdy(uv.y);
  light = vec4(texture(picture, uv).rgb * (0.2 + sun * (0.4 + 0.6 * open)) + 0.1 * grain.rgb, grain.w + edge);
}
