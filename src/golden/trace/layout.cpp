#include "golden/trace/layout.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <numeric>

namespace simreel::golden {

namespace {

constexpr std::uint32_t maxBlocks = 64;
constexpr std::uint32_t maxPerInvocation = 64;

/// Returns the number of elements per block: a multiple of maxPerInvocation, or a number below
/// maxPerInvocation.
std::uint32_t blockSize(std::uint32_t elements, std::uint32_t blocks) {
  const std::uint32_t size = std::max(1U, (elements + blocks - 1) / blocks);
  return size <= maxPerInvocation ? size
                                  : (size + maxPerInvocation - 1) / maxPerInvocation * maxPerInvocation;
}

}  // namespace

std::uint32_t elementsPerInvocation(std::uint32_t perBlock) {
  return std::min(perBlock, maxPerInvocation);
}

std::size_t StepTrace::frameWords(std::uint32_t index) const {
  const bool every = index > 0 && index <= detailed;
  std::size_t count = 0;
  for (const Array& array : arrays) count += std::size_t{array.words()} * (every ? array.steps : 1);
  return count;
}

std::size_t StepTrace::totalWords() const {
  if (frames == 0) return frameWords(0);
  const std::size_t single = frameWords(0);
  const std::size_t every = detailed > 0 ? frameWords(1) : 0;
  return single + detailed * every + (frames - detailed) * single;
}

StepTrace layOut(std::vector<StepTrace::Array> arrays, int firstFrame, int lastFrame,
                 std::size_t maxBytes) {
  SIMREEL_CHECK(lastFrame >= firstFrame);
  StepTrace trace;
  trace.arrays = std::move(arrays);
  trace.firstFrame = firstFrame;
  trace.frames = static_cast<std::uint32_t>(lastFrame - firstFrame);
  trace.detailed = trace.frames;
  const std::size_t max = maxBytes / sizeof(std::uint32_t);
  for (std::uint32_t blocks = maxBlocks; blocks >= 1; blocks /= 2) {
    for (StepTrace::Array& array : trace.arrays) array.perBlock = blockSize(array.elements, blocks);
    if (trace.totalWords() <= max) return trace;
  }
  const std::size_t every = trace.frameWords(1);
  const std::size_t single = trace.frameWords(0);
  const std::size_t min = single * (std::size_t{trace.frames} + 1);
  trace.detailed =
      min >= max || every == single
          ? 0
          : static_cast<std::uint32_t>(std::min<std::size_t>(trace.frames, (max - min) / (every - single)));
  return trace;
}

StepTrace reduced(const StepTrace& trace, bool whole, std::uint32_t detailed) {
  SIMREEL_CHECK(detailed <= trace.detailed);
  StepTrace result = trace;
  result.detailed = detailed;
  result.words.clear();
  if (trace.arrays.empty()) return result;
  if (whole)
    for (StepTrace::Array& array : result.arrays) array.perBlock = array.elements;
  const auto add = [&](const StepTrace::Array& array, std::span<const std::uint32_t> words) {
    const auto blocks = words.first(array.blocks());
    if (whole)  // Block sums add up to the array's sum modulo 2^32, as in the kernel.
      result.words.push_back(std::accumulate(blocks.begin(), blocks.end(), 0U));
    else
      result.words.insert(result.words.end(), blocks.begin(), blocks.end());
    result.words.push_back(words.back());
  };
  std::span<const std::uint32_t> rest = trace.words;
  std::vector<std::span<const std::uint32_t>> latest(trace.arrays.size());
  for (std::uint32_t index = 0; index <= trace.frames; ++index)
    for (std::size_t i = 0; i < trace.arrays.size(); ++i) {
      const StepTrace::Array& array = trace.arrays[i];
      const std::uint32_t steps = index > 0 && index <= trace.detailed ? array.steps : 1;
      for (std::uint32_t step = 1; step <= steps; ++step) {
        latest[i] = rest.first(array.words());
        rest = rest.subspan(array.words());
        if (step == steps || index <= detailed) add(array, latest[i]);
      }
      // An array without steps has no words in a detailed frame, and keeps its first state.
      if (steps == 0 && index > detailed) add(array, latest[i]);
    }
  return result;
}

namespace {

/// Finds the range of elements that differ, given the words of an array after one step.
void locate(const StepTrace::Array& array, std::span<const std::uint32_t> run,
            std::span<const std::uint32_t> baseline, Divergence& found) {
  std::vector<std::uint32_t> differing;
  for (std::uint32_t block = 0; block < array.blocks(); ++block)
    if (run[block] != baseline[block]) differing.push_back(block);
  // The block sums may be equal by chance while the weighted sums differ. The difference may then be
  // anywhere in the array.
  const std::uint32_t first = differing.empty() ? 0 : differing.front() * array.perBlock;
  const std::uint32_t last =
      differing.empty() ? array.elements - 1 : std::min(first + array.perBlock, array.elements) - 1;
  found.firstElement = first;
  found.lastElement = last;
  if (differing.size() != 1) return;
  // If only element i differs, the difference of the weighted sums is (i + 1) times the difference of the
  // block sums.
  const std::uint32_t difference = run[differing.front()] - baseline[differing.front()];
  const std::uint32_t weighted = run[array.blocks()] - baseline[array.blocks()];
  std::optional<std::uint32_t> only;
  for (std::uint32_t i = first; i <= last; ++i) {
    if ((i + 1) * difference != weighted) continue;
    if (only) return;
    only = i;
  }
  if (only) found.firstElement = found.lastElement = *only;
}

}  // namespace

std::optional<Divergence> compareFrame(const StepTrace& layout, std::uint32_t index,
                                       std::span<const std::uint32_t> run,
                                       std::span<const std::uint32_t> baseline) {
  SIMREEL_CHECK_EQ(run.size(), baseline.size());
  if (std::equal(run.begin(), run.end(), baseline.begin())) return std::nullopt;
  const bool every = index > 0 && index <= layout.detailed;
  std::optional<Divergence> first;
  std::size_t at = 0;
  for (const StepTrace::Array& array : layout.arrays) {
    for (std::uint32_t step = 1; step <= (every ? array.steps : 1); ++step, at += array.words()) {
      const auto a = run.subspan(at, array.words());
      const auto b = baseline.subspan(at, array.words());
      const int number = every ? static_cast<int>(step) : 0;
      const int steps = index == 0 ? 0 : static_cast<int>(array.steps);
      if (std::equal(a.begin(), a.end(), b.begin())) continue;
      if (first && !isEarlierStep(number, steps, first->step, first->steps)) continue;
      first = Divergence{};
      first->frame = layout.firstFrame + static_cast<int>(index);
      first->step = number;
      first->steps = steps;
      first->object = array.object;
      first->buffer = array.name;
      locate(array, a, b, *first);
    }
  }
  return first;
}

Divergence describe(Divergence found,
                    const std::function<std::string(const Divergence&, long element)>& elementName) {
  const std::string when =
      found.steps == 0  ? "in its first state"
      : found.step == 0 ? fmt::format("at frame {} (`simreel bisect` finds the step)", found.frame)
                        : fmt::format("at frame {}, step {} of {}", found.frame, found.step, found.steps);
  const std::string where =
      found.firstElement == found.lastElement
          ? elementName(found, found.firstElement)
          : fmt::format("within elements {} to {}", found.firstElement, found.lastElement);
  found.message = fmt::format("leaves the baseline {}: {}.{}, {}", when, found.object, found.buffer, where);
  return found;
}

}  // namespace simreel::golden
