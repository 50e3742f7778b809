#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace simreel::frame {

/// Bits of a code word in the order of writing (first bit lowest), and how many. No length: not used.
struct Code {
  std::uint16_t bits = 0;
  std::uint16_t length = 0;
};

/// Depth of each leaf of the Huffman tree over ascending weights (two queues: leaves and sums).
inline std::vector<int> leafDepths(const std::vector<std::uint32_t>& ascending) {
  const std::size_t leaves = ascending.size();
  std::vector<std::uint32_t> weight(ascending);
  std::vector<std::size_t> parent(2 * leaves - 1);
  std::size_t leaf = 0, sum = leaves;
  while (weight.size() < 2 * leaves - 1) {
    std::uint32_t total = 0;
    for (int k = 0; k < 2; ++k) {
      const bool takeLeaf = leaf < leaves && (sum >= weight.size() || weight[leaf] <= weight[sum]);
      const std::size_t node = takeLeaf ? leaf++ : sum++;
      parent[node] = weight.size();
      total += weight[node];
    }
    weight.push_back(total);
  }
  std::vector<int> depth(weight.size());
  for (std::size_t node = weight.size() - 1; node-- > 0;) depth[node] = depth[parent[node]] + 1;
  depth.resize(leaves);
  return depth;
}

/// Canonical Huffman code of at most `limit` (15 or fewer) bits, from how often each symbol occurs. At
/// least two symbols must have a count.
template <std::size_t N>
std::array<Code, N> makeCode(const std::array<std::uint32_t, N>& counts, int limit) {
  std::vector<std::size_t> used;
  for (std::size_t s = 0; s < N; ++s)
    if (counts[s] != 0) used.push_back(s);
  std::stable_sort(used.begin(), used.end(), [&](auto a, auto b) { return counts[a] < counts[b]; });
  std::vector<std::uint32_t> ascending;
  ascending.reserve(used.size());
  for (const std::size_t s : used) ascending.push_back(counts[s]);

  std::array<std::uint32_t, 16> ofLength{};
  for (const int depth : leafDepths(ascending))
    ++ofLength[static_cast<std::size_t>(std::min(depth, limit))];
  // Codes cut to the limit overfill the tree: split shorter codes until Kraft's sum is one again.
  std::uint32_t kraft = 0;
  for (int n = 1; n <= limit; ++n) kraft += ofLength[static_cast<std::size_t>(n)] << (limit - n);
  for (; kraft > (1u << limit); --kraft) {
    auto n = static_cast<std::size_t>(limit - 1);
    while (ofLength[n] == 0) --n;
    --ofLength[static_cast<std::size_t>(limit)];
    --ofLength[n];
    ofLength[n + 1] += 2;
  }

  std::array<Code, N> code{};
  std::size_t next = 0;
  for (auto n = static_cast<std::size_t>(limit); n >= 1; --n)  // the rarest get the longest
    for (std::uint32_t k = 0; k < ofLength[n]; ++k)
      code[used[next++]].length = static_cast<std::uint16_t>(n);
  std::array<std::uint32_t, 17> first{};
  for (std::size_t n = 1; n <= 15; ++n) first[n + 1] = (first[n] + ofLength[n]) << 1;
  for (Code& c : code) {
    if (c.length == 0) continue;
    std::uint32_t value = first[c.length]++, reversed = 0;
    for (int bit = 0; bit < c.length; ++bit, value >>= 1) reversed = (reversed << 1) | (value & 1);
    c.bits = static_cast<std::uint16_t>(reversed);
  }
  return code;
}

}  // namespace simreel::frame
