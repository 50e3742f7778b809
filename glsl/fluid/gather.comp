// Packs the planes of a state (grid.glsl) into elements of four floats for files. If SCATTER is defined, does the
// reverse. One invocation per element.
#include "fluid/bindings.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = flowBinding) restrict buffer PlaneBlock { uint planeWords[]; };
layout(std430, binding = carriedBinding) restrict buffer ElementBlock { uint together[]; };
uniform int planes;    // Number of planes; the other floats of an element are 0
uniform int elements;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= elements) return;
  for (int k = 0; k < 4; ++k) {
#ifdef SCATTER
    if (k < planes) planeWords[k * elements + i] = together[4 * i + k];
#else
    together[4 * i + k] = k < planes ? planeWords[k * elements + i] : 0u;
#endif
  }
}
