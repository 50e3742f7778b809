// For each surface, lists the lamp shadow maps that its bounding box may be visible in, and writes the instance count
// of the surface's indirect draw. Resets the boxes for the next frame. One invocation handles one surface.
#include "draw/lights/faces.glsl"
#include "draw/lights/lamp_list.glsl"
#include "draw/ordered_key.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = boxBinding) restrict buffer BoxBlock { uint boxes[]; };
layout(std430, binding = cellBinding) restrict writeonly buffer CellBlock { uint cells[]; };
// Draw arguments, 5 words per surface.
layout(std430, binding = cellArgumentBinding) restrict buffer ArgumentBlock { uint arguments[]; };
uniform int surfaces;

// Returns true if part of the box is inside every plane that bounds the shadow map (the planes of face_clip.glsl).
bool reaches(int face, vec3 low, vec3 high, float scale, float nearest) {
  vec3 a = onFace(face, low), b = onFace(face, high);
  vec3 minimum = min(a, b), maximum = max(a, b);
  precise float reach = maximum.x + 1e-4 * (maximum.x - minimum.x + abs(maximum.x));  // margin for rounding errors
  precise float across = scale * max(max(minimum.y, -maximum.y), max(minimum.z, -maximum.z));
  return maximum.x >= nearest && reach >= across;
}

void main() {
  int surface = int(gl_GlobalInvocationID.x);
  if (surface >= surfaces) return;
  vec3 low, high;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = fromOrderedKey(boxes[6 * surface + axis]);
    high[axis] = fromOrderedKey(boxes[6 * surface + 3 + axis]);
    boxes[6 * surface + axis] = 0xffffffffu;
    boxes[6 * surface + 3 + axis] = 0u;
  }
  uint count = 0u;
  if (low.x <= high.x)
    for (int lamp = 0; lamp < LAMPS; ++lamp) {
      vec3 middle = lampPlace(lamp).xyz;
      float scale = lampMaps(lamp).w, nearest = lampSampling(lamp).x;
      precise vec3 from = low - middle, to = high - middle;
      for (int face = 0; face < lampFaces; ++face)
        if (reaches(face, from, to, scale, nearest))
          cells[surface * LAMPS * lampFaces + int(count++)] = uint(lamp * lampFaces + face);
    }
  arguments[5 * surface + 1] = count;
}
