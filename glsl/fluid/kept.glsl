// Fraction of the pressure that remains (keptPressure of transport.glsl) between the push of a step, which writes it,
// and the projection. Only on the storage path, where the pressure stays in place during a step. It is 1 before the
// first step.
layout(std430, binding = keptBinding) restrict buffer KeptBlock { float kept; };

// Returns the remaining pressure, with the same rounding as pushedCell.
float keptOf(float pressure) {
  precise float left = kept * pressure;
  return exactFlush(left);
}
