#include "gl/sort/radix_sort.hpp"

#include "gpu/context.hpp"

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

std::uint64_t keyOf(const glm::uvec4& record, int lowBits, int highBits) {
  const auto mask = [](int bits) { return (std::uint64_t{1} << bits) - 1; };
  return ((record.y & mask(highBits)) << 32) | (record.x & mask(lowBits));
}

/// Sorts random records on the GPU and on the CPU and compares the results. The words of the keys are below
/// `max`; 0 means no limit.
void compare(int count, int capacity, int lowBits, int highBits, std::uint32_t max) {
  CAPTURE(count);
  testContext();
  std::mt19937 random(3);
  std::vector<glm::uvec4> records(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < records.size(); ++i) {
    const auto word = [&] { return max == 0 ? random() : random() % max; };
    records[i] = glm::uvec4(word(), word(), i, ~i);
  }
  gl::RadixSort sort("numbers", capacity);
  sort.records().write(records);
  sort.sort(count, lowBits, highBits);
  const auto got = sort.records().buffer().readAll<glm::uvec4>();
  std::stable_sort(records.begin(), records.end(), [&](const glm::uvec4& a, const glm::uvec4& b) {
    return keyOf(a, lowBits, highBits) < keyOf(b, lowBits, highBits);
  });
  REQUIRE(got.size() == static_cast<std::size_t>(capacity));
  std::size_t different = 0;
  for (std::size_t i = 0; i < records.size(); ++i) different += got[i] == records[i] ? 0 : 1;
  CHECK(different == 0);
}

}  // namespace

TEST_CASE("radix sort equals std::stable_sort on odd sizes") {
  for (const int count : {1, 2, 63, 65, 255, 257, 2049, 70001}) compare(count, count, 32, 0, 0);
}

TEST_CASE("radix sort sorts by two words, the second word more significant") {
  for (const int count : {257, 20011}) {
    compare(count, count, 24, 24, 0);
    compare(count, count, 32, 32, 0);
    compare(count, count, 4, 8, 0);
  }
}

TEST_CASE("radix sort is stable") {
  compare(5003, 5003, 32, 32, 3);
  compare(5003, 5003, 32, 0, 1);
  compare(2047, 2047, 24, 0, 16);
}

TEST_CASE("radix sort does not change records beyond the count") {
  compare(1021, 4096, 24, 24, 0);
  compare(0, 7, 24, 24, 0);
}
