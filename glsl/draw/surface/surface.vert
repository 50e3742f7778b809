#include "draw/frame_block.glsl"
#include "draw/passed_frame.glsl"
#include "draw/surface/vertex_pull.glsl"
#include "draw/surface/light_map.glsl"
#ifdef GRID
uniform ivec2 grid;
#else
layout(binding = normalUnit) uniform samplerBuffer normals;
layout(binding = uvUnit) uniform samplerBuffer uvs;
#endif
#if defined SKIN_UV || (defined TEXTURED && !defined TRIPLANAR)
#define HAS_UV
#endif
#ifdef HAS_UV
uniform vec2 textureScale;
out vec2 uv;
#endif
#ifdef TRIPLANAR
out vec3 objectPosition;
out vec3 objectNormal;
#endif
#ifdef PASSED_FRAME
uniform vec3 color;
uniform float roughness;
uniform float metallic;
uniform float translucency;
#ifdef BUMPED
uniform float bump;
#else
const float bump = 0.0;
#endif
flat out vec3 passedColor;
flat out vec4 passedMaterial;  // material values: roughness, metallic, translucency, bump height
#endif
#ifdef PALETTE
layout(binding = paletteUnit) uniform samplerBuffer palette;
out vec3 paletteColor;
#endif
#ifdef VERTEX_COLORS
layout(binding = paletteUnit) uniform samplerBuffer vertexTints;
out vec3 vertexTint;
#endif
out vec3 worldPosition;
out vec3 worldNormal;
#ifdef SHADOW
out vec3 place;
#endif

#ifdef GRID
// Returns the normal from central differences, or one-sided ones at the borders. The normal points to the same side as
// the normal of the triangles (a, a + width, a + 1).
vec3 gridNormal(int i) {
  int x = i % grid.x, y = i / grid.x;
  vec3 left = worldPoint(i - min(x, 1)), right = worldPoint(i + min(grid.x - 1 - x, 1));
  vec3 above = worldPoint(i - grid.x * min(y, 1)), below = worldPoint(i + grid.x * min(grid.y - 1 - y, 1));
  return cross(below - above, right - left);
}
#endif

void main() {
  passFrame();
#ifdef PASSED_FRAME
  passedColor = color;
  passedMaterial = vec4(roughness, metallic, translucency, bump);
#endif
  int i = gl_VertexID;
  vec3 p = worldPoint(i);
#ifdef PALETTE
  paletteColor = texelFetch(palette, vertexColor(i)).rgb;
#endif
#ifdef VERTEX_COLORS
  vertexTint = texelFetch(vertexTints, i).rgb;
#endif
#ifdef GRID
  vec3 normal = gridNormal(i);
#elif defined(DEFORMED)
  vec4 rest = texelFetch(positions, i);
  vec3 normal = mat3(model) * displacedNormal(rest.xyz, texelFetch(normals, i).xyz, rest.w);
#else
  vec3 normal = mat3(model) * texelFetch(normals, i).xyz;
#endif
  normal *= inversesqrt(max(dot(normal, normal), 1e-30));
  worldPosition = p;
  worldNormal = normal;
#ifdef TRIPLANAR
  float scale2 = max(dot(model[0].xyz, model[0].xyz), 1e-30);
  objectPosition = vertexPlace(i) * sqrt(scale2);
  objectNormal = transpose(mat3(model)) * normal * inversesqrt(scale2);
#endif
#ifdef HAS_UV
#ifdef GRID
  uv = textureScale * vec2(i % grid.x, i / grid.x) / vec2(grid - 1);
#else
  uv = textureScale * texelFetch(uvs, i).xy;
#endif
#endif
#ifdef SHADOW
  place = shadowPlace(p + shadowLift(normal));
#endif
  gl_Position = frame.viewProjection * vec4(p, 1.0);
}
