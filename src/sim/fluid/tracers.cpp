#include "sim/fluid/tracers.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace simreel::sim {

struct TraceKernel {
  static constexpr auto file = "fluid/tracers/trace.comp";
  struct Variant {
    gl::Flag<"FIRST"> first;
  };
  FluidWindPart wind;
  gl::Uniform<"count", int> count;
  gl::Uniform<"tracerData.dt", float> dt;
  gl::Uniform<"tracerData.seconds", float> seconds;
  gl::Uniform<"tracerData.seed", int> seed;
  gl::Uniform<"tracerData.wrapsX", int> wrapsX;
  gl::Uniform<"tracerData.wrapsY", int> wrapsY;
  gl::InOut<"tracers"> tracers;
  gl::In<"solidBits"> solid;
  gl::InOut<"TrailBlock"> trail;
};

struct TrailFade {
  static constexpr auto file = "fluid/tracers/trail_fade.comp";
  gl::Uniform<"count", int> count;
  gl::Uniform<"kept", float> kept;
  gl::InOut<"TrailBlock"> trail;
};

struct TrailDisplay {
  static constexpr auto file = "fluid/tracers/trail_show.comp";
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"color", glm::vec3> color;
  gl::Uniform<"perUnit", float> perUnit;
  gl::InOut<"shown"> shown;
  gl::In<"trail"> trail;
};

void TracerParameters::describe(scene::Fields& f) {
  f.integer("count", count, {1, 1e7}, "", "Number of tracers at any time.");
  f.number("seconds", seconds, {1e-2, 1e6}, "s", "Mean lifetime; then a tracer begins again elsewhere.");
  f.number("streak", streak, {1e-3, 1e6}, "s", "Time in which their streaks fade to 1/e.");
  f.color("color", color, {0, 1e4}, "Linear RGB.");
  f.number("brightness", brightness, {0, 1e4}, "",
           "How strongly a streak covers what is below it; 0 hides it.");
}

shader::TracerStep tracerStep(const TracerParameters& parameters, double dt, int seed, bool wrapsX,
                              bool wrapsY) {
  shader::TracerStep step{};
  step.dt = static_cast<float>(dt);
  step.seconds = parameters.seconds;
  step.seed = seed;
  step.wrapsX = wrapsX ? 1 : 0;
  step.wrapsY = wrapsY ? 1 : 0;
  return step;
}

float trailKept(const TracerParameters& parameters, double frameSeconds) {
  return shader::exactExp(static_cast<float>(-frameSeconds / static_cast<double>(parameters.streak)));
}

namespace {

/// Packs one bit per cell into uvec4 elements.
std::vector<glm::uvec4> solidBits(const std::vector<std::uint8_t>& solid) {
  std::vector<glm::uvec4> bits(solid.size() / 128 + 1, glm::uvec4(0));
  for (std::size_t i = 0; i < solid.size(); ++i)
    if (solid[i] != 0) bits[i / 128][static_cast<int>(i / 32 % 4)] |= 1U << (i % 32);
  return bits;
}

}  // namespace

Tracers::Tracers(const std::string& name, const TracerParameters& parameters, const FluidWind& wind,
                 const std::vector<std::uint8_t>& solid, const shader::TracerStep& step,
                 double frameSeconds, bool fast)
    : parameters_(parameters),
      wind_(&wind),
      size_(wind.grid().size),
      step_(step),
      kept_(trailKept(parameters, frameSeconds)) {
  const std::int64_t maximum =
      std::min<std::int64_t>(gl::limits().storageBlockBytes / 16, gl::limits().texelBufferTexels);
  if (parameters.count > maximum)
    fail(ExitCode::device,
         "fluid \"{}\": {} tracers are more than the {} that one buffer of this device holds; lower "
         "\"count\"",
         name, parameters.count, maximum);
  tracers_ = gl::Vec4Array(name + " tracers", parameters.count);
  solid_ = gl::WordsArray(name + " solid cells", solidBits(solid));
  trail_ = gl::WordsArray(name + " trail", (size_.x * size_.y + 3) / 4);
  const gl::Defines defines = gl::kernelDefines(fast);
  fade_ = gl::Kernel<TrailFade>(defines);
  display_ = gl::Kernel<TrailDisplay>(defines);
  trace_ = gl::Kernel<TraceKernel>(defines);
  gl::barrier();
  trace(gl::Kernel<TraceKernel>(defines, {.first = true}));
}

void Tracers::trace(const gl::Kernel<TraceKernel>& kernel) const {
  kernel.dispatch(parameters_.count, {.wind = wind_->part(),
                                      .count = parameters_.count,
                                      .dt = step_.dt,
                                      .seconds = step_.seconds,
                                      .seed = step_.seed,
                                      .wrapsX = step_.wrapsX,
                                      .wrapsY = step_.wrapsY,
                                      .tracers = tracers_,
                                      .solid = solid_,
                                      .trail = trail_.buffer()});
}

void Tracers::setSolid(const std::vector<std::uint8_t>& solid) {
  const std::vector<glm::uvec4> bits = solidBits(solid);
  solid_.buffer().write(0, std::as_bytes(std::span(bits)));
}

void Tracers::beginFrame() const {
  const int cells = size_.x * size_.y;
  fade_.dispatch(cells, {.count = cells, .kept = kept_, .trail = trail_.buffer()});
}

void Tracers::advance() const {
  gl::barrier();
  trace(trace_);
}

void Tracers::drawOver(const FluidArray& shown) const {
  gl::barrier();
  display_.dispatch(size_, {.size = size_,
                            .color = parameters_.color,
                            .perUnit = parameters_.brightness / 4096.0F,
                            .shown = shown.resource(),
                            .trail = trail_});
  gl::barrier();
}

void Tracers::visitCheckpointData(CarryOver& carry) {
  carry.array("tracers", tracers_.buffer());
  carry.array("trail", trail_.buffer());
}

std::vector<StateArray> Tracers::state() const {
  return {{"tracers", &tracers_.buffer()}, {"trail", &trail_.buffer(), true}};
}

}  // namespace simreel::sim
