// Evaluates every function of exact.glsl, to compare the bits with the bits that C++ computes, and built-in functions
// whose rounding differs between drivers. The hash of the inexact results identifies the driver family. One invocation
// per input; each writes 19 words.
#include "common/bindings.glsl"
#include "common/exact.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = inputsBinding) readonly restrict buffer InputBlock { float inputs[]; };
layout(std430, binding = outputsBinding) writeonly restrict buffer OutputBlock { float outputs[]; };
uniform int count;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  float x = inputs[i];
  float a = abs(x);
  int o = i * 19;
  outputs[o] = exactFlush(x);
  outputs[o + 1] = exactInverseSqrt(a);
  outputs[o + 2] = exactSqrt(a);
  outputs[o + 3] = exactReciprocal(x);
  outputs[o + 4] = exactSin(x);
  outputs[o + 5] = exactCos(x);
  outputs[o + 6] = exactExp(x);
  outputs[o + 7] = exactDot(vec3(x, a, 1.5f), vec3(0.3f, x, a));
  outputs[o + 8] = exactDot(vec4(x, a, 1.5f, a), vec4(0.3f, x, a, -x));
  outputs[o + 9] = exactLog(max(a, 1e-30f));
  outputs[o + 10] = exactPow(a, 0.7f);
  outputs[o + 11] = inversesqrt(a);  // inexact: rounding depends on the driver
  outputs[o + 12] = sqrt(a);  // inexact: rounding depends on the driver
  outputs[o + 13] = 1.7f / x;  // inexact: rounding depends on the driver
  outputs[o + 14] = sin(x);  // inexact: rounding depends on the driver
  outputs[o + 15] = exp(-a);  // inexact: rounding depends on the driver
  outputs[o + 16] = pow(a, 1.7f);  // inexact: rounding depends on the driver
  outputs[o + 17] = dot(vec3(x, a, 1.5f), vec3(0.3f, x, a));  // inexact: rounding depends on the driver
  outputs[o + 18] = x * 1.3f + a;  // inexact: rounding depends on the driver
}
