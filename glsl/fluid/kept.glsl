// Fraction of the pressure that remains in a step (keptPressure of transport.glsl). push.comp writes it and the
// projection reads it. Used only on the storage path, where the pressure is not moved during a step. It is 1 before the
// first step.
layout(std430, binding = keptBinding) restrict buffer KeptBlock { float kept; };

// Returns the remaining pressure, with the same rounding as pushedCell.
float keptOf(float pressure) {
  precise float left = kept * pressure;
  return exactFlush(left);
}
