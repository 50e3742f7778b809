// Appends a surface to the ray scene: vertices in world space, the vertex words for shading (normal, colour as half
// floats, index in the material table) and triangles. One invocation handles one vertex and one triangle. GRID,
// DEFORMED: as in draw/exact/triangles/world_vertex.glsl. COUNTED: the GPU has written the number of triangles to the
// draw arguments. PALETTE: colours are read from the palette. VERTEX_COLORS: colours are multiplied by a colour per
// vertex. LAID: also writes the uv or, with TRIPLANAR, the position in the surface's object space.
#include "draw/exact/rays/bindings.glsl"
#include "draw/exact/bindings.glsl"
#include "draw/exact/triangles/world_vertex.glsl"
#include "draw/exact/unit_vector.glsl"
#include "draw/half.glsl"
layout(local_size_x = 64) in;
layout(binding = indexUnit) uniform usamplerBuffer indices;
layout(std430, binding = outPlaceBinding) writeonly restrict buffer PlaceBlock { vec4 places[]; };
layout(std430, binding = outWordBinding) writeonly restrict buffer WordBlock { uvec4 words[]; };
layout(std430, binding = outCornerBinding) writeonly restrict buffer CornerBlock { uint corners[]; };
#ifdef COUNTED
layout(std430, binding = drawArgumentBinding) readonly restrict buffer DrawArgumentBlock { uint drawArguments[]; };
#endif
#ifdef PALETTE
layout(binding = paletteUnit) uniform samplerBuffer palette;
#endif
#ifdef VERTEX_COLORS
#include "draw/bindings.glsl"
layout(binding = paletteUnit) uniform samplerBuffer vertexTints;
#endif
uniform int vertexCount;
uniform int firstVertex;
uniform int triangleCount;
uniform int firstTriangle;
uniform ivec2 rowOf;  // layout of a grid's indices; see `rowOf` in draw/exact/triangles/surface_triangle.glsl
uniform uint owner;
uniform vec3 color;
#ifdef LAID
layout(std430, binding = outLayBinding) writeonly restrict buffer LayBlock { vec4 lays[]; };
#ifdef TRIPLANAR
uniform float modelScale;
#elif defined GRID
uniform vec2 perGrid;  // 1 / (grid - 1), the factor that converts grid coordinates to uv
#else
layout(binding = uvUnit) uniform samplerBuffer uvs;
#endif
vec3 layOf(int i) {
#ifdef TRIPLANAR
  precise vec3 lay = vertexPlace(i) * modelScale;
#elif defined GRID
  precise vec3 lay = vec3(vec2(i % grid.x, i / grid.x) * perGrid, 0.0f);
#else
  vec3 lay = vec3(texelFetch(uvs, i).xy, 0.0f);
#endif
  return lay;
}
#endif

void main() {
  int i = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (i < vertexCount) {
    vec3 p = worldPlace(i);
    precise float far = abs(p.x) + abs(p.y) + abs(p.z);
    bool there = isNumber(far) && far < 1e9f;
    places[firstVertex + i] = there ? vec4(p, 1.0f) : vec4(0);
    vec3 n = worldNormal(i);
    precise float square = exactDot(n, n);
    bool turned = isNumber(square) && square > 1e-30f && square < 1e30f;
    vec3 tint = color;
#ifdef PALETTE
    tint = texelFetch(palette, vertexColor(i)).rgb;
#endif
#ifdef VERTEX_COLORS
    precise vec3 tinted = tint * texelFetch(vertexTints, i).rgb;
    tint = tinted;
#endif
    vec4 held = asHalf(vec4(tint, 0.0f));
    words[firstVertex + i] =
        uvec4(packedUnit(turned ? n : vec3(0, 1, 0)), packHalf2x16(held.xy), packHalf2x16(held.zw), owner);
#ifdef LAID
    lays[firstVertex + i] = vec4(layOf(i), 0.0f);
#endif
  }
  if (i >= triangleCount) return;
#ifdef COUNTED
  bool drawn = i < int(drawArguments[0] / 3u);
#else
  const bool drawn = true;
#endif
  int row = rowOf.x > 0 ? i / rowOf.x : 0;
  int first = 3 * (i - row * rowOf.x), vertex = firstVertex + row * rowOf.y;
  for (int k = 0; k < 3; ++k)
    corners[3 * (firstTriangle + i) + k] = uint(vertex) + (drawn ? texelFetch(indices, first + k).x : 0u);
}
