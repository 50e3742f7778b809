// Tests the layout, file and comparison of step traces without a device. Also runs in the sanitizer build.
#include "golden/trace/trace.hpp"

#include "base/error.hpp"
#include "base/hash.hpp"
#include "golden/trace/file.hpp"
#include "golden/trace/layout.hpp"

#include <cstring>
#include <ctime>
#include <functional>

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::golden;

namespace {

using Arrays = std::vector<StepTrace::Array>;

const Arrays twoArrays = {{"flag", "positions", 137, 137, 3}, {"flag", "velocities", 70, 70, 3}};

/// Returns a number that replaces an element's hash. Any function of all arguments is suitable.
std::uint32_t elementHash(int frame, std::uint32_t array, std::uint32_t step, std::uint32_t element) {
  std::uint32_t h =
      static_cast<std::uint32_t>(frame) * 2654435761U + array * 40503U + step * 7919U + element;
  h = (h ^ (h >> 16U)) * 0x7feb352dU;
  h = (h ^ (h >> 15U)) * 0x846ca68bU;
  return h ^ (h >> 16U);
}

using Disturb = std::function<std::uint32_t(int frame, std::uint32_t array, std::uint32_t step,
                                            std::uint32_t element, std::uint32_t hash)>;

/// Computes block sums and the weighted sum like glsl/common/block_hash.comp.
StepTrace made(const Arrays& arrays, int first, int last, std::size_t maxBytes,
               const Disturb& disturb = {}) {
  StepTrace trace = layOut(arrays, first, last, maxBytes);
  for (std::uint32_t index = 0; index <= trace.frames; ++index)
    for (std::uint32_t a = 0; a < arrays.size(); ++a) {
      const StepTrace::Array& array = trace.arrays[a];
      const bool every = index > 0 && index <= trace.detailed;
      for (std::uint32_t step = every ? 1 : array.steps; step <= array.steps; ++step) {
        std::vector<std::uint32_t> words(array.words());
        for (std::uint32_t i = 0; i < array.elements; ++i) {
          const int frame = first + static_cast<int>(index);
          std::uint32_t h = elementHash(frame, a, step, i);
          if (disturb) h = disturb(frame, a, step, i, h);
          words[i / array.perBlock] += h;
          words.back() += (i + 1) * h;
        }
        trace.words.insert(trace.words.end(), words.begin(), words.end());
      }
    }
  REQUIRE(trace.words.size() == trace.totalWords());
  return trace;
}

/// Returns a function that changes one element from a step on, as in a run that deviates from its baseline.
Disturb from(int frame, std::uint32_t array, std::uint32_t step, std::uint32_t element, std::uint32_t by) {
  return [=](int f, std::uint32_t a, std::uint32_t s, std::uint32_t i, std::uint32_t h) {
    const bool later = f > frame || (f == frame && s >= step);
    return later && a == array && i == element ? h + by : h;
  };
}

std::string decodeRefusal(std::span<const std::byte> bytes) {
  try {
    static_cast<void>(decodeTrace(bytes, "steps.bin"));
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::inputOutput);
    return error.what();
  }
  return "";
}

/// Updates the hash at the end, so that damaged bytes reach the parser.
void sign(std::vector<std::byte>& bytes) {
  const std::string hash = hashHex(std::span(bytes).first(bytes.size() - 32));
  std::memcpy(bytes.data() + bytes.size() - 32, hash.data(), 32);
}

bool equal(const StepTrace& a, const StepTrace& b) {
  return a.arrays == b.arrays && a.firstFrame == b.firstFrame && a.frames == b.frames &&
         a.detailed == b.detailed && a.words == b.words;
}

}  // namespace

TEST_CASE("a trace is as fine as its byte limit allows") {
  const auto bytes = [](const StepTrace& trace) { return trace.totalWords() * 4; };
  const auto fine = layOut(twoArrays, -3, 5, 96 << 10);
  CHECK(fine.frames == 8);
  CHECK(fine.detailed == 8);
  CHECK(fine.arrays[0].perBlock == 3);  // With at most 64 blocks, a block has 137 / 64 elements, rounded
                                        // up.
  std::uint32_t last = 0;
  for (const std::size_t max : {8192U, 4096U, 2048U, 1024U, 700U, 500U}) {
    const auto trace = layOut(twoArrays, -3, 5, max);
    CHECK(bytes(trace) <= max);
    CHECK(trace.arrays[0].perBlock >= last);
    last = trace.arrays[0].perBlock;
  }
  // With one block per array and every step, a trace has 4 * (4 + 8 * 3 * 4) = 400 bytes. With less space,
  // later frames keep fewer steps.
  CHECK(layOut(twoArrays, -3, 5, 400).detailed == 8);
  const auto partly = layOut(twoArrays, -3, 5, 399);
  CHECK(partly.detailed == 7);
  CHECK(bytes(partly) <= 399);
  CHECK(layOut(twoArrays, -3, 5, 10).detailed == 0);
}

TEST_CASE("a trace is read back from its file") {
  for (const std::size_t max : {std::size_t{96} << 10, std::size_t{399}, std::size_t{10}}) {
    const auto trace = made(twoArrays, -3, 5, max);
    CHECK(equal(decodeTrace(encodeTrace(trace), "steps.bin"), trace));
  }
  const auto still = made({}, 0, 4, 1000);  // a trace without simulated arrays
  CHECK(equal(decodeTrace(encodeTrace(still), "steps.bin"), still));
}

TEST_CASE("a trace file truncated anywhere is refused in one line") {
  const auto whole = encodeTrace(made(twoArrays, -1, 1, 700));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    std::vector<std::byte> part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    for (const bool resigned : {false, true}) {
      if (resigned && size >= 40) sign(part);
      const std::string message = decodeRefusal(part);
      INFO(size, message);
      CHECK(message.find("steps.bin") != std::string::npos);
      CHECK(message.find('\n') == std::string::npos);
    }
  }
}

TEST_CASE("damage to a trace file is detected, and damage with a valid hash never crashes the reader") {
  const auto whole = encodeTrace(made(twoArrays, -1, 1, 700));
  std::uint32_t random = 1;
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (int round = 0; round < 6; ++round) {
      auto damaged = whole;
      random = random * 747796405U + 2891336453U;
      const auto put = round == 0 ? 0xffU : round == 1 ? 0x7fU : round == 2 ? 0U : random >> 24U;
      if (damaged[at] == static_cast<std::byte>(put)) continue;
      damaged[at] = static_cast<std::byte>(put);
      CHECK(!decodeRefusal(damaged).empty());
      sign(damaged);
      static_cast<void>(decodeRefusal(damaged));
    }
}

TEST_CASE("absurd sizes in a trace file allocate no memory") {
  const auto whole = encodeTrace(made({{"a", "b", 5, 5, 2}}, 0, 2, 1000));
  // Offsets of the number fields: first frame, frames, detailed, arrays, then two name lengths, elements,
  // elements per block, steps.
  for (const std::size_t at : {8U, 12U, 16U, 20U, 24U, 29U, 34U, 38U, 42U})
    for (const std::uint32_t value : {0xffffffffU, 0x7fffffffU, 0x40000000U, 0x00ffffffU, 0x80000000U}) {
      if (at == 8 && value == 0xffffffffU) continue;  // Skips a first frame of -1, which is valid.
      auto damaged = whole;
      std::memcpy(damaged.data() + at, &value, sizeof value);
      sign(damaged);
      INFO(at, " ", value);
      CHECK(!decodeRefusal(damaged).empty());
    }
  // A block size that the kernel cannot divide evenly would give other sums.
  auto uneven = encodeTrace(made({{"a", "b", 64, 64, 1}}, 0, 1, 12));
  const std::uint32_t perBlock = 97;
  std::memcpy(uneven.data() + 38, &perBlock, sizeof perBlock);
  sign(uneven);
  CHECK(decodeRefusal(uneven).find("sizes make no sense") != std::string::npos);
}

TEST_CASE("a trace file may contain an object without steps") {
  const auto trace = made({{"fire", "cells", 5, 5, 2}, {"land", "heights", 5, 5, 0}}, 0, 3, 4096);
  const auto decoded = decodeTrace(encodeTrace(trace), "steps.bin");
  CHECK(decoded.words == trace.words);
  CHECK(decoded.arrays.back().steps == 0);
  CHECK(!compareTraces(decoded, trace));
  // Without details, each frame has the words of the first state.
  const auto last = reduced(trace, false, 0);
  REQUIRE(last.words.size() == last.totalWords());
  const std::size_t frame = last.frameWords(1), land = last.arrays.front().words();
  for (std::size_t at = land; at < last.words.size(); at += frame)
    CHECK(last.words[at] == trace.words[land]);
}

TEST_CASE("equal traces do not diverge") {
  const auto trace = made(twoArrays, -3, 5, 4096);
  CHECK(!compareTraces(trace, trace));
  CHECK(!compareTraces(made(twoArrays, -3, 9, 4096), trace));  // Additional frames in the run are ignored.
}

TEST_CASE("a trace without arrays is cheap for any claimed number of frames") {
  StepTrace trace;
  trace.frames = 1U << 31U;
  const std::clock_t start = std::clock();
  CHECK_FALSE(compareTraces(trace, trace));
  StepTrace other = trace;
  other.detailed = 1;
  CHECK_FALSE(compareTraces(trace, other));
  CHECK(reduced(trace, true, 0).words.empty());
  CHECK(std::clock() - start <
        CLOCKS_PER_SEC);  // processor time in microseconds; no time is spent per frame
}

TEST_CASE("one changed element is located exactly at any position") {
  for (const std::size_t max : {std::size_t{96} << 10, std::size_t{2048}, std::size_t{700}}) {
    const auto baseline = made(twoArrays, -3, 5, max);
    for (std::uint32_t element = 0; element < 137; ++element)
      for (const std::uint32_t by : {1U, 6U, 0xfffffff0U, 0x12345678U}) {
        const auto found =
            compareTraces(made(twoArrays, -3, 5, max, from(-1, 0, 2, element, by)), baseline);
        REQUIRE(found.has_value());
        INFO(max, " ", element, " ", by, " ", found->message);
        CHECK(found->frame == -1);
        CHECK(found->step == 2);
        CHECK(found->steps == 3);
        CHECK(found->object == "flag");
        CHECK(found->buffer == "positions");
        CHECK(found->firstElement == element);
        CHECK(found->lastElement == element);
        CHECK(found->message.find(fmt::format("frame -1, step 2 of 3: flag.positions, element {}",
                                              element)) != std::string::npos);
      }
  }
}

TEST_CASE("an element whose hash differs by a high power of two gives a range, not a guessed element") {
  const auto baseline = made(twoArrays, 0, 2, 700);
  const auto found = compareTraces(made(twoArrays, 0, 2, 700, from(1, 0, 1, 10, 0x80000000U)), baseline);
  REQUIRE(found.has_value());
  CHECK(found->firstElement <= 10);
  CHECK(found->lastElement >= 10);
  CHECK(found->lastElement > found->firstElement);  // the factor (i + 1) of the weighted sum makes every
                                                    // second i indistinguishable
}

TEST_CASE("several changed elements give a range, and an earlier step of a later array is reported first") {
  const auto baseline = made(twoArrays, -3, 5, 2048);
  const auto several = made(twoArrays, -3, 5, 2048, [](int f, auto a, auto s, auto i, std::uint32_t h) {
    const bool first = f == 2 && s == 1 && a == 1 && (i == 20 || i == 21 || i == 69);
    const bool second = f == 2 && s == 2 && a == 0;
    return first || second ? h ^ 0x5555U : h;
  });
  const auto found = compareTraces(several, baseline);
  REQUIRE(found.has_value());
  CHECK(found->buffer == "velocities");
  CHECK(found->step == 1);
  CHECK(found->firstElement <= 20);
  CHECK(found->lastElement >= 20);
  CHECK(found->lastElement < 69);
  CHECK(found->message.find("within elements") != std::string::npos);
}

TEST_CASE("among objects with different step lengths, the earliest divergence in time is reported") {
  const Arrays arrays = {{"a", "positions", 9, 9, 5}, {"b", "positions", 9, 9, 2}};
  const auto baseline = made(arrays, 0, 2, 2048);
  for (const auto& [atStep, first] : {std::pair(2U, "a"), std::pair(3U, "b")}) {
    const auto step = atStep;  // This is a copy, because lambdas cannot capture structured bindings.
    const auto run = made(arrays, 0, 2, 2048, [&](int f, auto array, auto s, auto, std::uint32_t h) {
      // Compares times within frame 1. The change is at 2/5 or 3/5 of the frame for the first array, and at
      // 1/2 for the second.
      return f == 1 && s == (array == 0 ? step : 1U) ? h + 1 : h;
    });
    const auto found = compareTraces(run, baseline);
    REQUIRE(found.has_value());
    CHECK(found->object == first);
  }
}

TEST_CASE("a difference in the first state, or after the last frame with steps, is reported as such") {
  const auto first =
      compareTraces(made(twoArrays, -3, 5, 4096, from(-3, 1, 1, 7, 3)), made(twoArrays, -3, 5, 4096));
  REQUIRE(first.has_value());
  CHECK(first->frame == -3);
  CHECK(first->step == 0);
  CHECK(first->message.find("first state: flag.velocities, element 7") != std::string::npos);
  const auto late =
      compareTraces(made(twoArrays, -3, 5, 300, from(5, 0, 2, 7, 3)), made(twoArrays, -3, 5, 300));
  REQUIRE(late.has_value());
  CHECK(late->frame == 5);
  CHECK(late->step == 0);
  CHECK(late->message.find("simreel bisect") != std::string::npos);
}

TEST_CASE("traces of different fineness are compared at the coarser fineness") {
  const auto change = from(3, 0, 2, 99, 12345);
  for (const std::size_t runBytes : {96U << 10, 2048U, 400U, 300U, 10U})
    for (const std::size_t baseBytes : {96U << 10, 2048U, 400U, 300U, 10U}) {
      INFO(runBytes, " ", baseBytes);
      const auto run = made(twoArrays, -3, 5, runBytes, change);
      const auto baseline = made(twoArrays, -3, 7, baseBytes);
      CHECK(!compareTraces(made(twoArrays, -3, 5, runBytes), baseline));
      const auto found = compareTraces(run, baseline);
      REQUIRE(found.has_value());
      CHECK(found->frame == 3);
      CHECK(found->step == (std::min(run.detailed, baseline.detailed) >= 6 ? 2 : 0));
      CHECK(found->buffer == "positions");
      CHECK(found->firstElement == 99);
      CHECK(found->lastElement == 99);
    }
}

TEST_CASE("different arrays, sizes, steps or starts diverge at the first frame") {
  const auto baseline = made(twoArrays, -3, 5, 4096);
  const auto expect = [&](const Arrays& arrays, int first, const char* words) {
    const auto found = compareTraces(made(arrays, first, 5, 4096), baseline);
    REQUIRE(found.has_value());
    INFO(found->message);
    CHECK(found->frame == first);
    CHECK(found->message.find(words) != std::string::npos);
  };
  auto other = twoArrays;
  other[1].name = "spins";
  expect(other, -3, "flag.spins");
  other = twoArrays;
  other[0].elements = 138;
  expect(other, -3, "138 elements");
  other = twoArrays;
  other[0].steps = 4;
  expect(other, -3, "4 steps a frame");
  expect({twoArrays[0]}, -3, "no such array");
  expect(twoArrays, -2, "starts at frame -2");
}
