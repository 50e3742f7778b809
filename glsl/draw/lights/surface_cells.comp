// Which of the lamps' shadow maps each surface reaches into: their numbers, and the arguments of its indirect draw.
// Empties the boxes for the next frame. An invocation does one surface.
#include "draw/lights/faces.glsl"
#include "draw/lights/lamp_list.glsl"
#include "draw/ordered_key.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = boxBinding) restrict buffer BoxBlock { uint boxes[]; };
layout(std430, binding = cellBinding) restrict writeonly buffer CellBlock { uint cells[]; };
layout(std430, binding = cellArgumentBinding) restrict buffer ArgumentBlock { uint arguments[]; };  // 5 words each
uniform int surfaces;

// Whether the box reaches to the inner side of all planes that bound the map: those of face_clip.glsl.
bool reaches(int face, vec3 low, vec3 high, float scale, float nearest) {
  vec3 a = onFace(face, low), b = onFace(face, high);
  vec3 least = min(a, b), most = max(a, b);
  precise float reach = most.x + 1e-4 * (most.x - least.x + abs(most.x));  // some slack
  precise float across = scale * max(max(least.y, -most.y), max(least.z, -most.z));
  return most.x >= nearest && reach >= across;
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
