// Includes, uniforms and buffers common to the kernels that build a distance field.
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "collide/distance/bindings.glsl"
layout(local_size_x = 64) in;
uniform ivec4 nodes;     // xyz number of grid nodes per axis; w total number
uniform vec4 corner;     // xyz position of the first node, m; w grid spacing, m
uniform float perUnit;   // Number of integer units per metre
uniform int firstLeaf;
INPUT_ARRAY(boxesBinding, BoxBlock, boxes)
INPUT_ARRAY(facesBinding, FaceBlock, faces)
STATE_WORDS(nodesBinding, NodeBlock, searches)
vec4 loadBox(int i) {
  return LOAD_INPUT(boxes, i);
}
vec4 loadFace(int i) {
  return LOAD_INPUT(faces, i);
}
#include "collide/distance/model.glsl"

vec3 placeOf(int i) {
  int x = i % nodes.x, rest = i / nodes.x;
  precise vec3 place = vec3(float(x), float(rest % nodes.y), float(rest / nodes.y)) * corner.w + corner.xyz;
  return place;
}
