// Data of the MESHES rigid meshes with which cloth and particles collide. If MESHES is 0, nothing is bound or read.
#ifndef MESHES
#define MESHES 0
#endif
#if MESHES
#include "common/words.glsl"
#include "collide/field_types.glsl"
layout(std140, binding = meshCollidersBinding) uniform MeshColliderBlock { MeshColliders meshData; };
INPUT_WORDS(fieldCellsBinding, FieldCellBlock, fieldCells)
uvec4 loadFieldCell(int i) {
  return LOAD_INPUT_WORDS(fieldCells, i);
}
#endif
