// Clears the claims of all cells. One invocation per cell.
layout(local_size_x = 64) in;
layout(std430, binding = 2) writeonly buffer ClaimBlock { uint claims[]; };
uniform int count;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i < count) claims[i] = 0xffffffffu;
}
