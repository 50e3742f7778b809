// For several faces of the lamps' shadow maps, lists the triangles of the merged mesh (merge_mesh.comp) that the face
// may show. A triangle is left out if it is completely beyond one side of the face, by more than a rounding error. A
// listed triangle may still be invisible. One invocation tests one triangle. Defines: as for lamp_list.glsl, and
// BALLOT.
#include "draw/exact/bindings.glsl"
#include "draw/lights/lamp_list.glsl"
layout(local_size_x = 64) in;
layout(binding = vertexUnit) uniform samplerBuffer places;
layout(binding = indexUnit) uniform usamplerBuffer indices;
layout(std430, binding = drawArgumentBinding) readonly restrict buffer DrawArgumentBlock { uint drawArguments[]; };
layout(std430, binding = largeBinding) writeonly restrict buffer ListBlock { uint lists[]; };
layout(std430, binding = counterBinding) restrict buffer CounterBlock { uint counters[]; };
uniform int room;  // capacity of the triangle list of one face
uniform int firstFace;
uniform int faces;
#include "draw/exact/list_place.glsl"

bool allBelow(vec3 v, float minimum) {
  return max(v.x, max(v.y, v.z)) < minimum;
}

// Returns true if all three corners are beyond the side y = x of the face. x holds the distances along the face's axis.
bool allBeyond(vec3 x, vec3 y) {
  precise vec3 within = x - y + 1e-5f * (abs(x) + abs(y));
  return allBelow(within, 0.0f);
}

// Returns true if the triangle may be visible in a face that covers |y| <= x and |z| <= x.
bool mayShow(vec3 x, vec3 y, vec3 z, float nearest) {
  return !(allBelow(x, nearest) || allBeyond(x, y) || allBeyond(x, -y) || allBeyond(x, z) || allBeyond(x, -z));
}

void list(int face, uint number) {
  int k = face - firstFace;
  if (k >= 0 && k < faces) lists[k * room + int(nextPlace(k))] = number;
}

void main() {
  int number = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (number >= int(drawArguments[0] / 3u)) return;
  vec3 corners[3];
  for (int i = 0; i < 3; ++i) corners[i] = texelFetch(places, int(texelFetch(indices, 3 * number + i).x)).xyz;
  for (int lamp = firstFace / lampFaces; lamp * lampFaces < firstFace + faces; ++lamp) {
    vec3 middle = lampPlace(lamp).xyz;
    float scale = lampMaps(lamp).w, nearest = lampSampling(lamp).x;
    precise vec3 a = corners[0] - middle, b = corners[1] - middle, c = corners[2] - middle;
    vec3 along[3];
    for (int axis = 0; axis < 3; ++axis) along[axis] = vec3(a[axis], b[axis], c[axis]);
    for (int axis = 0; axis < 3; ++axis) {
      vec3 x = along[axis];
      precise vec3 y = along[(axis + 1) % 3] * scale, z = along[(axis + 2) % 3] * scale;
      int face = lamp * lampFaces + 2 * axis;
      if (mayShow(x, y, z, nearest)) list(face, uint(number));
      if (mayShow(-x, y, z, nearest)) list(face + 1, uint(number));
    }
  }
}
