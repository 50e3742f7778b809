#include "sim/fluid/tracers.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace simreel::sim {

void TracerParameters::describe(scene::Fields& f) {
  f.integer("count", count, {1, 1e7}, "", "Number of tracers at any time.");
  f.number("seconds", seconds, {1e-2, 1e6}, "s", "Mean lifetime; then a tracer begins again elsewhere.");
  f.number("streak", streak, {1e-3, 1e6}, "s", "Time in which their streaks fade to 1/e.");
  f.vector("color", color, {0, 1e4}, "", "Linear RGB.");
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

/// A bit a cell, in whole elements.
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
    : parameters_(parameters), wind_(&wind), size_(wind.grid().size) {
  const std::int64_t most =
      std::min<std::int64_t>(gl::limits().storageBlockBytes / 16, gl::limits().texelBufferTexels);
  if (parameters.count > most)
    fail(ExitCode::device,
         "fluid \"{}\": {} tracers are more than the {} that one buffer of this device holds; lower "
         "\"count\"",
         name, parameters.count, most);
  tracers_ = gl::Vec4Array(name + " tracers", parameters.count);
  solid_ = gl::WordsArray(name + " solid cells", solidBits(solid));
  trail_ = gl::WordsArray(name + " trail", (size_.x * size_.y + 3) / 4);
  gl::Defines defines = gl::kernelDefines(fast);
  fade_ = gl::Program::compute("fluid/tracers/trail_fade.comp", defines);
  fade_.set("count", size_.x * size_.y);
  fade_.set("kept", trailKept(parameters, frameSeconds));
  show_ = gl::Program::compute("fluid/tracers/trail_show.comp", defines);
  show_.set("size", size_);
  show_.set("color", parameters.color);
  show_.set("perUnit", parameters.brightness / 4096.0F);
  const auto tell = [&](const gl::Program& kernel) {
    wind.tell(kernel);
    kernel.set("count", parameters.count);
    kernel.set("tracerData.dt", step.dt);
    kernel.set("tracerData.seconds", step.seconds);
    kernel.set("tracerData.seed", step.seed);
    kernel.set("tracerData.wrapsX", step.wrapsX);
    kernel.set("tracerData.wrapsY", step.wrapsY);
  };
  trace_ = gl::Program::compute("fluid/tracers/trace.comp", defines);
  tell(trace_);
  defines.emplace_back("FIRST", "1");
  const gl::Program first = gl::Program::compute("fluid/tracers/trace.comp", defines);
  tell(first);
  solid_.bindInput(shader::solidBinding);
  tracers_.bindState(shader::tracersBinding);
  gl::barrier();
  first.dispatch(parameters.count);
  gl::barrier();
}

void Tracers::setSolid(const std::vector<std::uint8_t>& solid) {
  const std::vector<glm::uvec4> bits = solidBits(solid);
  solid_.buffer().write(0, std::as_bytes(std::span(bits)));
}

void Tracers::beginFrame() {
  trail_.buffer().bindStorage(shader::trailBinding);
  gl::barrier();
  fade_.dispatch(size_.x * size_.y);
}

void Tracers::advance() {
  wind_->bind();
  solid_.bindInput(shader::solidBinding);
  tracers_.bindState(shader::tracersBinding);
  trail_.buffer().bindStorage(shader::trailBinding);
  gl::barrier();
  trace_.dispatch(parameters_.count);
  gl::barrier();
}

void Tracers::show(const FluidArray& shown) const {
  trail_.bindInput(shader::trailBinding);
  shown.bindState(shader::shownBinding);
  gl::barrier();
  show_.dispatch(size_.x, size_.y);
  gl::barrier();
}

void Tracers::carryOver(CarryOver& carry) {
  carry.array("tracers", tracers_.buffer());
  carry.array("trail", trail_.buffer());
}

std::vector<StateArray> Tracers::state() const {
  return {{"tracers", &tracers_.buffer()}, {"trail", &trail_.buffer(), true}};
}

}  // namespace simreel::sim
