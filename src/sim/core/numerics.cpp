#include "sim/core/numerics.hpp"

#include "base/error.hpp"
#include "base/hash.hpp"
#include "gl/buffer.hpp"
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "scene/scene.hpp"
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

struct ProbeKernel {
  static constexpr auto file = "common/probe.comp";
  gl::Uniform<"count", int> count;
  gl::In<"inputs"> inputs;
  gl::Out<"outputs"> outputs;
};

struct LoopProbe {
  static constexpr auto file = "common/loop_probe.comp";
  gl::Uniform<"rounds", int> rounds;
  gl::Out<"reached"> reached;
};

constexpr int probes = 253;
constexpr int exactFunctions = 11;
constexpr int functions = 19;

/// Numbers of both signs over many magnitudes, by integer hash.
std::vector<float> inputs() {
  std::vector<float> values;
  for (unsigned i = 0; i < probes; ++i) {
    const auto bits = shader::hash3({i, 7, 11});
    const float unit = shader::signedUnit(bits.x);
    const float scales[] = {1.0F, 30.0F, 1e-3F, 1e-6F};
    values.push_back(unit * scales[bits.y % 4]);
  }
  return values;
}

std::array<float, exactFunctions> twin(float x) {
  const float a = shader::abs(x);
  return {shader::exactFlush(x),
          shader::exactInverseSqrt(a),
          shader::exactSqrt(a),
          shader::exactReciprocal(x),
          shader::exactSin(x),
          shader::exactCos(x),
          shader::exactExp(x),
          shader::exactDot(glm::vec3(x, a, 1.5F), glm::vec3(0.3F, x, a)),
          shader::exactDot(glm::vec4(x, a, 1.5F, a), glm::vec4(0.3F, x, a, -x)),
          shader::exactLog(std::max(a, 1e-30F)),
          shader::exactPow(a, 0.7F)};
}

}  // namespace

Numerics probeNumerics() {
  const char* names[exactFunctions] = {
      "exactFlush", "exactInverseSqrt", "exactSqrt",        "exactReciprocal", "exactSin", "exactCos",
      "exactExp",   "exactDot",         "exactDot of vec4", "exactLog",        "exactPow"};
  const auto values = inputs();
  const auto in = gl::Buffer::of<float>("probe inputs", values);
  const gl::Buffer out("probe outputs", probes * functions * sizeof(float));
  gl::Kernel<ProbeKernel>(gl::Defines()).dispatch(probes, {probes, in, out});
  const auto results = out.readAll<float>();

  Numerics found;
  found.exactHolds = true;
  std::vector<float> builtIns;
  for (std::size_t i = 0; i < probes; ++i) {
    const auto expected = twin(values[i]);
    for (std::size_t f = 0; f < exactFunctions; ++f) {
      const float got = results[i * functions + f];
      if (std::bit_cast<std::uint32_t>(got) == std::bit_cast<std::uint32_t>(expected[f])) continue;
      if (found.exactHolds)
        found.firstFailure =
            fmt::format("{}({:.9g}): GPU {:.9g}, CPU {:.9g}", names[f], values[i], got, expected[f]);
      found.exactHolds = false;
    }
    for (std::size_t f = exactFunctions; f < functions; ++f) builtIns.push_back(results[i * functions + f]);
  }
  if (gl::memoryPath() == gl::MemoryPath::storage) builtIns.push_back(1);
  found.fingerprint = hashHex(std::as_bytes(std::span(builtIns))).substr(0, 16);
  return found;
}

unsigned probeLoop() {
  const gl::Buffer out("loop probe", 16);
  gl::Kernel<LoopProbe>(gl::Defines()).dispatch(1, {static_cast<int>(loopProbeRounds), out});
  return out.readAll<unsigned>().front();
}

void requireExact(const scene::Scene& scene, const Numerics& numerics) {
  if (scene.numerics == scene::Numerics::exact && !numerics.exactHolds)
    fail(ExitCode::device,
         "this driver does not compute exactly ({}); use another device, or \"numerics\": \"fast\"",
         numerics.firstFailure);
}

}  // namespace simreel::sim
