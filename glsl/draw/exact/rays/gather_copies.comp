// Appends the triangles of mesh copies to the ray scene. Each triangle has three separate vertices. One invocation
// handles one triangle.
#define EXACT_PICTURE
#include "draw/frame_block.glsl"
#include "draw/exact/rays/bindings.glsl"
#include "draw/exact/copies/copy_source.glsl"
#include "draw/instances/instance_list.glsl"
#include "draw/exact/unit_vector.glsl"
#include "draw/half.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = outPlaceBinding) writeonly restrict buffer PlaceBlock { vec4 places[]; };
layout(std430, binding = outWordBinding) writeonly restrict buffer WordBlock { uvec4 words[]; };
layout(std430, binding = outCornerBinding) writeonly restrict buffer CornerBlock { uint corners[]; };
uniform int firstVertex;
uniform int firstTriangle;
uniform uint owner;

void main() {
  int i = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (i >= capacity_ * int(triangles_)) return;
  int slot = i / int(triangles_);
  vec4 position = texelFetch(positions, slot), velocity = texelFetch(velocities, slot);
  bool shown = radiusOf(position, velocity) > 0.0f;
  Copy copy = copyOf(slot);
  ivec3 own = cornersOf(uint(i - slot * int(triangles_)));
  vec4 held = asHalf(vec4(tintOf(position, velocity), 0.0f));
  for (int k = 0; k < 3; ++k) {
    int vertex = firstVertex + 3 * i + k;
    places[vertex] = shown ? vec4(pointOf(copy, own[k]), 1.0f) : vec4(0);
    words[vertex] = uvec4(packedUnit(normalOf(copy, own[k])), packHalf2x16(held.xy), packHalf2x16(held.zw), owner);
    corners[3 * (firstTriangle + i) + k] = uint(vertex);
  }
}
