#include "base/srgb.hpp"

#include "base/ieee.hpp"

namespace simreel {

double linearOfSrgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : ieee::pow((encoded + 0.055) / 1.055, 2.4);
}

double srgbOfLinear(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * ieee::pow(linear, 1 / 2.4) - 0.055;
}

}  // namespace simreel
