// What of the pressure is left (keptPressure of transport.glsl) between a step's push, which notes it, and its projection: on the
// storage path, where a step leaves the pressure in its place until then. 1 before the first step.
layout(std430, binding = keptBinding) restrict buffer KeptBlock { float kept; };

// As pushedCell has it.
float keptOf(float pressure) {
  precise float left = kept * pressure;
  return exactFlush(left);
}
