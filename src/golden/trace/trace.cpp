#include "golden/trace/trace.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"
#include "gl/program.hpp"
#include "golden/trace/layout.hpp"
#include "sim/world/world.hpp"

#include <algorithm>
#include <utility>

namespace simreel::golden {

namespace {

/// Steps a world and hashes what each step leaves.
class Tracer {
 public:
  explicit Tracer(const scene::Scene& scene, AfterStep afterStep = {})
      : world_(scene),
        hash_(gl::Program::compute("common/block_hash.comp")),
        afterStep_(std::move(afterStep)) {
    const auto names = world_.arrays();
    for (std::size_t object = 0; object < world_.objectCount(); ++object)
      for (std::size_t i = 0; i < world_.object(object).state().size(); ++i) owners_.push_back(object);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto elements = static_cast<std::uint32_t>(names[i].elements);
      arrays_.push_back({names[i].object, names[i].array, elements, elements,
                         static_cast<std::uint32_t>(world_.object(owners_[i]).stepsPerFrame())});
    }
  }

  [[nodiscard]] const std::vector<StepTrace::Array>& arrays() const { return arrays_; }
  [[nodiscard]] const sim::World& world() const { return world_; }
  [[nodiscard]] int firstFrame() const { return world_.firstFrame(); }

  /// Words of one frame as StepTrace has them. Index 0 is the first state; call in ascending order.
  std::vector<std::uint32_t> frame(const StepTrace& layout, std::uint32_t index) {
    if (layout.arrays.empty()) return {};
    const std::vector<std::uint32_t> zero(layout.frameWords(index));
    sums_ = gl::Buffer::of<std::uint32_t>("step sums", zero);
    const bool every = index <= layout.detailed;
    if (index == 0) {
      for (std::size_t object = 0; object < world_.objectCount(); ++object) add(layout, object, 0);
    } else {
      world_.advanceTo(layout.firstFrame + static_cast<int>(index), [&](std::size_t object, int step) {
        if (afterStep_) afterStep_(world_, object, step);
        const int steps = world_.object(object).stepsPerFrame();
        if (every || step == steps) add(layout, object, every ? static_cast<std::uint32_t>(step) - 1 : 0);
      });
      world_.startSummary();
      static_cast<void>(world_.takeSummary(true));  // throws when the state is lost
    }
    gl::barrier();
    return sums_.readAll<std::uint32_t>();
  }

 private:
  /// Hashes an object's arrays into the place of a step.
  void add(const StepTrace& layout, std::size_t object, std::uint32_t step) {
    gl::barrier();
    std::uint32_t place = 0;
    std::size_t ofObject = 0;
    const bool single = sums_.bytes() / 4 == layout.frameWords(0);
    for (std::size_t i = 0; i < layout.arrays.size(); ++i) {
      const StepTrace::Array& array = layout.arrays[i];
      if (owners_[i] == object)
        addArray(*world_.object(object).state()[ofObject++].buffer, array, place + step * array.words());
      place += array.words() * (single ? 1 : array.steps);
    }
  }

  void addArray(const gl::Buffer& buffer, const StepTrace::Array& array, std::uint32_t place) {
    const gl::Texture words = gl::Texture::view("state words", GL_RGBA32UI, buffer);
    words.bind(0);
    sums_.bindStorage(0);
    const std::uint32_t perInvocation = invocationShare(array.perBlock);
    hash_.set("texels", static_cast<int>(array.elements));
    hash_.set("perInvocation", static_cast<int>(perInvocation));
    hash_.set("perBlock", static_cast<int>(array.perBlock));
    hash_.set("place", static_cast<int>(place));
    hash_.dispatch(static_cast<int>((array.elements - 1) / perInvocation + 1));
  }

  sim::World world_;
  gl::Program hash_;
  gl::Buffer sums_;
  AfterStep afterStep_;
  std::vector<StepTrace::Array> arrays_;
  std::vector<std::size_t> owners_;  ///< object of each array
};

/// Whether the traces are of the same arrays, however they are cut into blocks.
std::optional<Divergence> differentArrays(const std::vector<StepTrace::Array>& run,
                                          const std::vector<StepTrace::Array>& baseline, int firstFrame) {
  const auto differs = [](const StepTrace::Array& a, const StepTrace::Array& b) {
    return a.object != b.object || a.name != b.name || a.elements != b.elements || a.steps != b.steps;
  };
  const auto text = [](const StepTrace::Array& a) {
    return fmt::format("{}.{} with {} elements and {} steps a frame", a.object, a.name, a.elements,
                       a.steps);
  };
  for (std::size_t i = 0; i < std::max(run.size(), baseline.size()); ++i) {
    if (i < run.size() && i < baseline.size() && !differs(run[i], baseline[i])) continue;
    Divergence found;
    found.frame = firstFrame;
    found.object = i < run.size() ? run[i].object : baseline[i].object;
    found.buffer = i < run.size() ? run[i].name : baseline[i].name;
    found.message = fmt::format("leaves the baseline before the first step: it has {}, the baseline {}",
                                i < run.size() ? text(run[i]) : "no such array",
                                i < baseline.size() ? text(baseline[i]) : "no such array");
    return found;
  }
  return std::nullopt;
}

std::optional<Divergence> differentStart(int run, int baseline) {
  if (run == baseline) return std::nullopt;
  Divergence found;
  found.frame = run;
  found.message = fmt::format(
      "leaves the baseline before the first step: its pre-roll starts at frame {}, the baseline's at {}",
      run, baseline);
  return found;
}

}  // namespace

StepTrace traceRun(const scene::Scene& scene, int lastFrame, std::size_t mostBytes,
                   const AfterStep& afterStep) {
  Tracer tracer(scene, afterStep);
  StepTrace trace = layOut(tracer.arrays(), tracer.firstFrame(), lastFrame, mostBytes);
  trace.words.reserve(trace.totalWords());
  for (std::uint32_t index = 0; index <= trace.frames; ++index) {
    const auto words = tracer.frame(trace, index);
    trace.words.insert(trace.words.end(), words.begin(), words.end());
  }
  return trace;
}

std::optional<Divergence> compareTraces(const StepTrace& run, const StepTrace& baseline) {
  if (auto other = differentArrays(run.arrays, baseline.arrays, run.firstFrame)) return other;
  if (auto other = differentStart(run.firstFrame, baseline.firstFrame)) return other;
  if (run.arrays.empty()) return std::nullopt;  // nothing to compare, however many frames a file claims
  if (run.arrays != baseline.arrays || run.detailed != baseline.detailed) {
    const bool whole = run.arrays != baseline.arrays;
    const std::uint32_t detailed = std::min(run.detailed, baseline.detailed);
    return compareTraces(reduced(run, whole, detailed), reduced(baseline, whole, detailed));
  }
  std::size_t at = 0;
  for (std::uint32_t index = 0; index <= std::min(run.frames, baseline.frames); ++index) {
    const std::size_t count = baseline.frameWords(index);
    if (auto found = compareFrame(baseline, index, std::span(run.words).subspan(at, count),
                                  std::span(baseline.words).subspan(at, count)))
      return describe(*found,
                      [](const Divergence&, long element) { return fmt::format("element {}", element); });
    at += count;
  }
  return std::nullopt;
}

std::optional<Divergence> firstDivergence(const scene::Scene& scene, const StepTrace& baseline) {
  Tracer tracer(scene);
  if (auto other = differentArrays(tracer.arrays(), baseline.arrays, tracer.firstFrame())) return other;
  if (auto other = differentStart(tracer.firstFrame(), baseline.firstFrame)) return other;
  if (baseline.arrays.empty()) return std::nullopt;
  const auto elementName = [&](const Divergence& where, long element) {
    for (std::size_t i = 0; i < tracer.world().objectCount(); ++i)
      if (tracer.world().objectName(i) == where.object)
        return tracer.world().object(i).elementName(element);
    return fmt::format("element {}", element);
  };
  std::size_t at = 0;
  for (std::uint32_t index = 0; index <= baseline.frames; ++index) {
    const std::size_t count = baseline.frameWords(index);
    const auto words = tracer.frame(baseline, index);
    if (auto found = compareFrame(baseline, index, words, std::span(baseline.words).subspan(at, count)))
      return describe(*found, elementName);
    at += count;
  }
  return std::nullopt;
}

}  // namespace simreel::golden
