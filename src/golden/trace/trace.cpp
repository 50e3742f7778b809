#include "golden/trace/trace.hpp"

#include "base/error.hpp"
#include "frame/summaries.hpp"
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "golden/trace/layout.hpp"
#include "golden/trace/traced_run.hpp"
#include "sim/core/state_hash.hpp"
#include "sim/world/world.hpp"

#include <algorithm>
#include <utility>

namespace simreel::golden {

namespace {

struct BlockHash {
  static constexpr auto file = "common/block_hash.comp";
  struct Variant {
    gl::Flag<"PLANES"> planes;
  };
  sim::StateWordsPart state;
  gl::Uniform<"perInvocation", int> perInvocation;
  gl::Uniform<"perBlock", int> perBlock;
  gl::Uniform<"place", int> place;
  gl::InOut<"SumBlock"> sums;
};

/// Steps a world and hashes the state after each step.
class Tracer {
 public:
  explicit Tracer(const scene::Scene& scene, AfterStep afterStep = {})
      : world_(scene), hash_(gl::Defines()), afterStep_(std::move(afterStep)) {
    for (std::size_t object = 0; object < world_.objectCount(); ++object)
      owners_.insert(owners_.end(), world_.object(object).state().size(), object);
  }

  [[nodiscard]] const sim::World& world() const { return world_; }

  /// Returns the words of one frame as in StepTrace. Index 0 is the initial state. Must be called with
  /// ascending indices.
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
      frame::checkState(world_);
    }
    gl::barrier();
    return sums_.readAll<std::uint32_t>();
  }

 private:
  /// Adds the hashes of an object's arrays to the words of a step.
  void add(const StepTrace& layout, std::size_t object, std::uint32_t step) {
    gl::barrier();
    std::uint32_t place = 0;
    std::size_t ofObject = 0;
    const bool single = sums_.bytes() / 4 == layout.frameWords(0);
    for (std::size_t i = 0; i < layout.arrays.size(); ++i) {
      const StepTrace::Array& array = layout.arrays[i];
      if (owners_[i] == object)
        addArray(world_.object(object).state()[ofObject++], array, place + step * array.words());
      place += array.words() * (single ? 1 : array.steps);
    }
  }

  void addArray(const sim::StateArray& state, const StepTrace::Array& array, std::uint32_t place) {
    const bool planes = state.planes.count > 0;
    if (planes && !ofPlanes_) ofPlanes_ = gl::Kernel<BlockHash>(gl::Defines(), {.planes = true});
    const sim::StateWords words(state);
    const std::uint32_t perInvocation = elementsPerInvocation(array.perBlock);
    (planes ? ofPlanes_ : hash_)
        .dispatch(static_cast<int>((array.elements - 1) / perInvocation + 1),
                  {.state = words.part(),
                   .perInvocation = static_cast<int>(perInvocation),
                   .perBlock = static_cast<int>(array.perBlock),
                   .place = static_cast<int>(place),
                   .sums = sums_});
  }

  sim::World world_;
  gl::Kernel<BlockHash> hash_, ofPlanes_;  ///< kernels for element arrays and for planes
  gl::Buffer sums_;
  AfterStep afterStep_;
  std::vector<std::size_t> owners_;  ///< for each array, the index of its object
};

TracedRun runOf(const StepTrace& trace) {
  TracedRun run{trace.firstFrame, {}};
  for (const StepTrace::Array& a : trace.arrays)
    run.arrays.push_back({a.object, a.name, a.elements, static_cast<int>(a.steps)});
  return run;
}

/// Returns a divergence if the traces have different arrays. Different block sizes are permitted.
std::optional<Divergence> differentRuns(const TracedRun& run, const StepTrace& baseline) {
  const auto mismatch = compareRuns(run, runOf(baseline));
  if (!mismatch) return std::nullopt;
  Divergence found;
  found.frame = run.firstFrame;
  found.object = mismatch->array.object;
  found.buffer = mismatch->array.array;
  found.message = fmt::format("leaves the baseline before the first step: it {}, the baseline {}",
                              mismatch->here, mismatch->there);
  return found;
}

/// Compares frames up to index `last`. `wordsOf` returns the words of the run. It is called with ascending
/// indices.
template <class WordsOf>
std::optional<Divergence> firstDifference(const StepTrace& baseline, std::uint32_t last,
                                          const WordsOf& wordsOf) {
  std::size_t at = 0;
  for (std::uint32_t index = 0; index <= last; ++index) {
    const std::size_t count = baseline.frameWords(index);
    const auto expected = std::span(baseline.words).subspan(at, count);
    if (auto found = compareFrame(baseline, index, wordsOf(index, at, count), expected)) return found;
    at += count;
  }
  return std::nullopt;
}

}  // namespace

StepTrace traceRun(const scene::Scene& scene, int lastFrame, std::size_t maxBytes,
                   const AfterStep& afterStep) {
  Tracer tracer(scene, afterStep);
  const TracedRun run = describeWorld(tracer.world());
  std::vector<StepTrace::Array> arrays;
  for (const TracedArray& a : run.arrays) {
    const auto elements = static_cast<std::uint32_t>(a.elements);
    arrays.push_back({a.object, a.array, elements, elements, static_cast<std::uint32_t>(a.steps)});
  }
  StepTrace trace = layOut(std::move(arrays), run.firstFrame, lastFrame, maxBytes);
  trace.words.reserve(trace.totalWords());
  for (std::uint32_t index = 0; index <= trace.frames; ++index) {
    const auto words = tracer.frame(trace, index);
    trace.words.insert(trace.words.end(), words.begin(), words.end());
  }
  return trace;
}

std::optional<Divergence> compareTraces(const StepTrace& run, const StepTrace& baseline) {
  if (auto other = differentRuns(runOf(run), baseline)) return other;
  if (run.arrays.empty()) return std::nullopt;  // The run has no arrays, so nothing can be compared.
  if (run.arrays != baseline.arrays || run.detailed != baseline.detailed) {
    const bool whole = run.arrays != baseline.arrays;
    const std::uint32_t detailed = std::min(run.detailed, baseline.detailed);
    return compareTraces(reduced(run, whole, detailed), reduced(baseline, whole, detailed));
  }
  const auto words = [&](std::uint32_t, std::size_t at, std::size_t count) {
    return std::span(run.words).subspan(at, count);
  };
  const auto found = firstDifference(baseline, std::min(run.frames, baseline.frames), words);
  if (!found) return std::nullopt;
  return describe(*found,
                  [](const Divergence&, long element) { return fmt::format("element {}", element); });
}

std::optional<Divergence> firstDivergence(const scene::Scene& scene, const StepTrace& baseline) {
  Tracer tracer(scene);
  if (auto other = differentRuns(describeWorld(tracer.world()), baseline)) return other;
  if (baseline.arrays.empty()) return std::nullopt;
  const auto words = [&](std::uint32_t index, std::size_t, std::size_t) {
    return tracer.frame(baseline, index);
  };
  const auto found = firstDifference(baseline, baseline.frames, words);
  if (!found) return std::nullopt;
  return describe(*found, [&](const Divergence& where, long element) {
    return elementName(tracer.world(), where.object, element);
  });
}

}  // namespace simreel::golden
