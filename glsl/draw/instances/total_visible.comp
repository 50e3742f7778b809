// Computes prefix sums over the counts of the blocks. Then writes eight words per level of detail: the arguments of the
// level's indirect draw {count, instanceCount, firstIndex, baseVertex, baseInstance}, its first index in the list, its
// number of instances, and 0. One drawn instance contains `batch` copies of the shape. Runs as one workgroup.
#include "draw/bindings.glsl"
layout(local_size_x = 256) in;
layout(binding = blockCountUnit) uniform usamplerBuffer blockCount;
layout(std430, binding = blockFirstBinding) writeonly restrict buffer FirstBlock { uint blockFirst[]; };
layout(std430, binding = argumentBinding) writeonly restrict buffer ArgumentBlock { uint arguments[]; };
uniform int blocks;           // number of blocks of all levels together
uniform ivec2 indices[LEVELS];  // first index and number of indices of each level's shape
uniform int batch[LEVELS];
shared uint strip[256];
shared uint levelFirst[LEVELS + 1];

void main() {
  int me = int(gl_LocalInvocationID.x);
  int each = (blocks + 255) / 256;
  int first = min(me * each, blocks), last = min(first + each, blocks);
  uint sum = 0u;
  for (int block = first; block < last; ++block) sum += texelFetch(blockCount, block).x;
  strip[me] = sum;
  barrier();
  if (me == 0) {
    uint all = 0u;
    for (int i = 0; i < 256; ++i) {
      uint here = strip[i];
      strip[i] = all;
      all += here;
    }
    levelFirst[LEVELS] = all;
  }
  barrier();
  uint at = strip[me];
  int levelBlocks = blocks / LEVELS;
  for (int block = first; block < last; ++block) {
    if (block % levelBlocks == 0) levelFirst[block / levelBlocks] = at;
    blockFirst[block] = at;
    at += texelFetch(blockCount, block).x;
  }
  barrier();
  if (me >= LEVELS) return;
  uint visible = levelFirst[me + 1] - levelFirst[me];
  uint group = uint(batch[me]);
  arguments[me * 8] = uint(indices[me].y);
  arguments[me * 8 + 1] = (visible + group - 1u) / group;
  arguments[me * 8 + 2] = uint(indices[me].x);
  arguments[me * 8 + 3] = 0u;
  arguments[me * 8 + 4] = 0u;
  arguments[me * 8 + 5] = levelFirst[me];
  arguments[me * 8 + 6] = visible;
  arguments[me * 8 + 7] = 0u;
}
