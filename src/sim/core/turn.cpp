#include "sim/core/turn.hpp"

#include "sim/core/shader_code.hpp"

#include <cmath>

namespace simreel::sim {

glm::vec2 cosineAndSine(float degrees) {
  const float within = std::fmod(degrees, 360.0F);  // The reduction to one turn is exact, because fmod does
                                                    // not round.
  if (within == 0) return {1, 0};
  if (within == 90 || within == -270) return {0, 1};
  if (within == 180 || within == -180) return {-1, 0};
  if (within == 270 || within == -90) return {0, -1};
  const float angle = degrees * 0.017453293F;
  return {shader::exactCos(angle), shader::exactSin(angle)};
}

}  // namespace simreel::sim
