#include "sim/kernels/arithmetic.hpp"

#include "base/log.hpp"
#include "gl/buffer.hpp"
#include "gl/context.hpp"
#include "gl/kernel/kernel.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include <epoxy/gl.h>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

namespace {

struct ArithmeticProbe {
  static constexpr auto file = "probe/kernel_arithmetic.comp";
  gl::Uniform<"count", int> count;
  gl::In<"pairs"> pairs;
  gl::Out<"results"> results;
};

constexpr const char* fusedMacro = "simreel_fused";
constexpr float smallest = std::numeric_limits<float>::min();  // 2^-126
constexpr float step = 0x1p-23F;

/// Returns the pairs of inputs. The first ones have products and sums that are subnormal or round to
/// 2^-126, and reciprocals and roots at the limits of the range; the others are hashed.
std::vector<glm::vec2> probePairs() {
  const float infinity = std::numeric_limits<float>::infinity();
  std::vector<glm::vec2> pairs = {{1 - step / 2, smallest},
                                  {0x1p-63F * (1 + step), 0x1p-63F * (1 - step)},
                                  {1e-20F, -1e-19F},
                                  {smallest * (1 + step), -smallest},
                                  {0x1p126F, 0x1p-126F},
                                  {0x1p126F * (1 + step), 1},
                                  {0x1p125F * (2 - step), 1},
                                  {3e38F, 0.5F},
                                  {smallest, 0.5F},
                                  {smallest, smallest},
                                  {0x1p-100F, 0x1p-100F},
                                  {0x1p-101F * (2 - step), 1},
                                  {0, -0.0F},
                                  {infinity, 1},
                                  {-infinity, 0}};
  std::uint32_t state = 1;
  while (pairs.size() < 4096) {
    float number[2];
    for (float& one : number) {
      state = state * 747796405U + 2891336453U;
      const std::uint32_t word = ((state >> ((state >> 28U) + 4U)) ^ state) * 277803737U;
      const std::uint32_t exponent = 30 + (word >> 23U) % 194;
      one = std::bit_cast<float>((word & 0x7fffffU) | exponent << 23U);
    }
    pairs.emplace_back(number[0], number[1]);
  }
  return pairs;
}

/// Rounds to float and flushes to zero: returns 0 if the magnitude, rounded to 24 bits as if the exponent
/// had no lower limit, is below 2^-126. `exact` may already be rounded to double.
float flushed(double exact) {
  const double scaled = static_cast<double>(static_cast<float>(exact * 0x1p64));
  return std::abs(scaled) < 0x1p-62 ? 0.0F : static_cast<float>(exact);
}

glm::vec4 expected(const glm::vec2& pair) {
  const auto x = static_cast<double>(pair.x), y = static_cast<double>(pair.y);
  const float root = std::abs(pair.x) < 0x1p-100F ? 0.0F : std::sqrt(pair.x);
  const float reciprocal = std::abs(pair.x) > 0x1p126F ? 0.0F
                           : pair.x == 0               ? std::numeric_limits<float>::infinity()
                                                       : 1.0F / pair.x;
  return {reciprocal, root, flushed(x * y), flushed(x + y)};
}

/// Compares results. The sign of zero does not matter.
bool isEqual(const glm::vec4& found, const glm::vec4& wanted) {
  for (int i = 0; i < 4; ++i)
    if (found[i] != wanted[i] && !(std::isnan(found[i]) && std::isnan(wanted[i]))) return false;
  return true;
}

bool computes(bool fused) {
  const std::vector<glm::vec2> pairs = probePairs();
  const auto in = gl::Buffer::of<glm::vec2>("arithmetic inputs", pairs);
  const gl::Buffer out("arithmetic results", pairs.size() * sizeof(glm::vec4));
  const auto count = static_cast<int>(pairs.size());
  gl::Kernel<ArithmeticProbe>(gl::Defines{{fusedMacro, fused ? "true" : "false"}})
      .dispatch(count, {count, in, out});
  const auto results = out.readAll<glm::vec4>();
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (const glm::vec4 wanted = expected(pairs[i]); !isEqual(results[i], wanted)) {
      detail("kernel arithmetic ({}): of {:a} and {:a}: {:a} {:a} {:a} {:a} instead of {:a} {:a} {:a} {:a}",
             fused ? "fused" : "rounded", pairs[i].x, pairs[i].y, results[i].x, results[i].y, results[i].z,
             results[i].w, wanted.x, wanted.y, wanted.z, wanted.w);
      return false;
    }
  return true;
}

Arithmetic measured() {
  const char* forced = std::getenv("SIMREEL_CAREFUL");
  if (forced != nullptr && std::string(forced) == "1") return Arithmetic::careful;
  const bool first = !gl::softwareDriver();
  for (const bool fused : {first, !first})
    if (computes(fused)) return fused ? Arithmetic::fused : Arithmetic::rounded;
  return Arithmetic::careful;
}

}  // namespace

Arithmetic kernelArithmetic() {
  static std::map<std::string, Arithmetic> known;
  static std::mutex mutex;
  const std::string device = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::scoped_lock lock(mutex);
  const auto found = known.find(device);
  return found != known.end() ? found->second : known[device] = measured();
}

const char* arithmeticText(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::rounded:
      return "the driver's own divisions and roots";
    case Arithmetic::fused:
      return "divisions and roots corrected with fused multiply-add";
    case Arithmetic::careful:
      break;
  }
  return "divisions and roots in integers, because the driver rounds differently (same bits, slower)";
}

gl::Program kernelProgram(const std::string& label, const std::string& text) {
  return gl::Program::computeText(
      label, text, {{fusedMacro, kernelArithmetic() == Arithmetic::rounded ? "false" : "true"}});
}

}  // namespace simreel::sim
