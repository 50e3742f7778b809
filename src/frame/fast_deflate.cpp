#include "frame/fast_deflate.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <vector>

#include <libdeflate.h>

namespace simreel::frame {

namespace {

constexpr std::size_t blockSize = std::size_t{1} << 18;  ///< input bytes that share a Huffman code
constexpr std::size_t window = 32768;
constexpr int hashBits = 13;
constexpr int longestMatch = 258;
constexpr int literalSymbols = 286, distanceSymbols = 30, lengthCodeSymbols = 19;
/// Codes are held to 12 bits, so that four literals fit into the 64-bit accumulator at once.
constexpr int longestCode = 12;
constexpr int endOfBlock = 256;

/// Literals followed by one match; the last of a block has no match (length 0).
struct Sequence {
  std::uint32_t literals;
  std::uint16_t length;
  std::uint16_t distance;
};

struct Code {
  std::uint16_t bits = 0;
  std::uint16_t length = 0;
};

/// A symbol and the extra bits that follow it (RFC 1951, 3.2.5).
struct Split {
  int symbol;
  int extraLength;
  std::uint32_t extra;
};

Split splitLength(int length) {
  const auto x = static_cast<std::uint32_t>(length - 3);
  if (x < 8) return {257 + static_cast<int>(x), 0, 0};
  if (length == longestMatch) return {285, 0, 0};
  const int bits = std::bit_width(x) - 3;
  return {257 + 4 * (bits + 1) + static_cast<int>((x >> bits) & 3), bits, x & ((1u << bits) - 1)};
}

Split splitDistance(int distance) {
  const auto x = static_cast<std::uint32_t>(distance - 1);
  if (x < 4) return {static_cast<int>(x), 0, 0};
  const int bits = std::bit_width(x) - 2;
  return {2 * (bits + 1) + static_cast<int>((x >> bits) & 1), bits, x & ((1u << bits) - 1)};
}

std::uint32_t load32(const std::uint8_t* p) {
  std::uint32_t value;
  std::memcpy(&value, p, sizeof value);
  return value;
}

std::uint64_t load64(const std::uint8_t* p) {
  std::uint64_t value;
  std::memcpy(&value, p, sizeof value);
  return value;
}

/// Little-endian bit writer; the caller keeps at most 64 bits between two calls of flush().
class BitWriter {
 public:
  explicit BitWriter(std::uint8_t* out) : begin_(out), out_(out) {}
  void put(std::uint64_t bits, int length) {
    held_ |= bits << count_;
    count_ += length;
  }
  void put(Code code) { put(code.bits, code.length); }
  /// Leaves at most 7 bits held. Writes 8 bytes, of which only whole ones count.
  void flush() {
    static_assert(std::endian::native == std::endian::little);
    std::memcpy(out_, &held_, sizeof held_);
    out_ += count_ >> 3;
    held_ >>= count_ & ~7;
    count_ &= 7;
  }
  void alignToByte() {
    count_ = (count_ + 7) & ~7;
    flush();
  }
  void putBytes(std::span<const std::uint8_t> bytes) {
    std::memcpy(out_, bytes.data(), bytes.size());
    out_ += bytes.size();
  }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(out_ - begin_); }

 private:
  std::uint8_t* begin_;
  std::uint8_t* out_;
  std::uint64_t held_ = 0;
  int count_ = 0;
};

/// Depth of each leaf of the Huffman tree over ascending weights (two queues: leaves and sums).
std::vector<int> leafDepths(const std::vector<std::uint32_t>& ascending) {
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

/// Canonical Huffman code of at most `limit` bits. At least two symbols must have a count.
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

/// Finds the matches of a block.
class Parser {
 public:
  /// Sequences of in[begin, end); matches may reach back before `begin`.
  const std::vector<Sequence>& parse(std::span<const std::uint8_t> in, std::size_t begin, std::size_t end) {
    if (begin == 0) recent_.fill(0);
    sequences_.clear();
    std::size_t literalsFrom = begin, at = std::max<std::size_t>(begin, 1), misses = 0;
    while (at + 8 <= end) {
      Match match = find(in.data(), at, end);
      if (match.length == 0) {
        at += 1 + (++misses >> 4);
        continue;
      }
      misses = 0;
      while (at > literalsFrom && at > match.distance && in[at - 1] == in[at - 1 - match.distance]) {
        --at;
        ++match.length;
      }
      push(at - literalsFrom, match);
      at += match.length;
      literalsFrom = at;
    }
    sequences_.push_back({static_cast<std::uint32_t>(end - literalsFrom), 0, 0});
    return sequences_;
  }

 private:
  struct Match {
    std::size_t length;
    std::size_t distance;
  };

  static std::size_t extend(const std::uint8_t* in, std::size_t at, std::size_t distance, std::size_t end) {
    std::size_t length = 4;
    for (; at + length + 8 <= end; length += 8) {
      const std::uint64_t difference = load64(in + at + length) ^ load64(in + at + length - distance);
      if (difference != 0) return length + (static_cast<std::size_t>(std::countr_zero(difference)) >> 3);
    }
    while (at + length < end && in[at + length] == in[at + length - distance]) ++length;
    return length;
  }

  Match find(const std::uint8_t* in, std::size_t at, std::size_t end) {
    const std::uint64_t here = load64(in + at);
    std::uint32_t& slot = recent_[(static_cast<std::uint32_t>(here) * 2654435761u) >> (32 - hashBits)];
    const std::size_t candidate = slot;
    slot = static_cast<std::uint32_t>(at);
    // A run of one byte, or of one pixel. Shorter ones are left to the literals: in noise they come
    // and go at random, and each mispredicted branch costs more than the byte it saves.
    if (here == load64(in + at - 1)) return {extend(in, at, 1, end), 1};
    if (at >= 3 && here == load64(in + at - 3)) return {extend(in, at, 3, end), 3};
    const std::size_t distance = at - candidate;
    if (distance == 0 || distance > window || load32(in + candidate) != static_cast<std::uint32_t>(here))
      return {0, 0};
    // A short match far away costs more bits than the literals, which are frequent ones here.
    const std::size_t length = extend(in, at, distance, end);
    return length < shortestFar ? Match{0, 0} : Match{length, distance};
  }

  void push(std::size_t literals, Match match) {
    while (match.length > 0) {
      std::size_t part = std::min<std::size_t>(match.length, longestMatch);
      if (match.length - part == 1 || match.length - part == 2) part -= 3;  // no rest under 3
      sequences_.push_back({static_cast<std::uint32_t>(literals), static_cast<std::uint16_t>(part),
                            static_cast<std::uint16_t>(match.distance)});
      literals = 0;
      match.length -= part;
    }
  }

  static constexpr std::size_t shortestFar = 12;
  std::array<std::uint32_t, std::size_t{1} << hashBits> recent_{};
  std::vector<Sequence> sequences_;
};

/// How often each symbol occurs in a block, and the extra bits in all.
struct Counts {
  std::array<std::uint32_t, literalSymbols> literal{};
  std::array<std::uint32_t, distanceSymbols> distance{};
  std::size_t extraBits = 0;
};

Counts count(const std::uint8_t* in, const std::vector<Sequence>& sequences) {
  Counts result;
  // Four tables: equal bytes in a row would otherwise wait for one another's store.
  std::array<std::array<std::uint32_t, 256>, 4> tables{};
  for (const Sequence& sequence : sequences) {
    std::uint32_t k = 0;
    for (; k + 4 <= sequence.literals; k += 4)
      for (std::size_t t = 0; t < 4; ++t) ++tables[t][in[k + t]];
    for (; k < sequence.literals; ++k) ++tables[0][in[k]];
    in += sequence.literals + sequence.length;
    if (sequence.length == 0) continue;
    const Split length = splitLength(sequence.length), distance = splitDistance(sequence.distance);
    ++result.literal[static_cast<std::size_t>(length.symbol)];
    ++result.distance[static_cast<std::size_t>(distance.symbol)];
    result.extraBits += static_cast<std::size_t>(length.extraLength + distance.extraLength);
  }
  for (std::size_t s = 0; s < 256; ++s)
    result.literal[s] = tables[0][s] + tables[1][s] + tables[2][s] + tables[3][s];
  result.literal[endOfBlock] = 1;
  // Two symbols in every code: decoders disagree on codes with fewer.
  for (auto* table : {result.literal.data(), result.distance.data()})
    for (const std::size_t s : {0, 1}) table[s] = std::max(table[s], 1u);
  return result;
}

/// The two codes' lengths as RFC 1951 3.2.7 wants them, with runs of zeros shortened.
void putCodeLengths(BitWriter& out, const std::array<Code, literalSymbols>& literal,
                    const std::array<Code, distanceSymbols>& distance) {
  std::vector<std::uint16_t> lengths;
  for (const Code& c : literal) lengths.push_back(c.length);
  for (const Code& c : distance) lengths.push_back(c.length);
  struct Item {
    std::size_t symbol;
    std::uint32_t extra;
    int extraLength;
  };
  std::vector<Item> items;
  std::array<std::uint32_t, lengthCodeSymbols> counts{};
  counts[0] = counts[18] = 1;
  for (std::size_t i = 0; i < lengths.size();) {
    std::size_t zeros = 0;
    while (i + zeros < lengths.size() && lengths[i + zeros] == 0 && zeros < 138) ++zeros;
    if (zeros >= 11)
      items.push_back({18, static_cast<std::uint32_t>(zeros - 11), 7});
    else if (zeros >= 3)
      items.push_back({17, static_cast<std::uint32_t>(zeros - 3), 3});
    else
      items.push_back({lengths[i], 0, 0});
    i += zeros >= 3 ? zeros : 1;
    ++counts[items.back().symbol];
  }
  const auto code = makeCode(counts, 7);
  constexpr std::array<std::size_t, lengthCodeSymbols> order = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                                11, 4,  12, 3, 13, 2, 14, 1, 15};
  out.put(literalSymbols - 257, 5);
  out.put(distanceSymbols - 1, 5);
  out.put(lengthCodeSymbols - 4, 4);
  for (const std::size_t s : order) {
    out.put(code[s].length, 3);
    out.flush();
  }
  for (const Item& item : items) {
    out.put(code[item.symbol]);
    out.put(item.extra, item.extraLength);
    out.flush();
  }
}

void putStored(BitWriter& out, std::span<const std::uint8_t> bytes, bool last) {
  while (!bytes.empty()) {
    const auto part = bytes.first(std::min<std::size_t>(bytes.size(), 65535));
    bytes = bytes.subspan(part.size());
    out.put(last && bytes.empty() ? 1 : 0, 3);  // type 0 in the upper two bits
    out.alignToByte();
    out.put(part.size() | ((part.size() ^ 0xffff) << 16), 32);
    out.flush();
    out.putBytes(part);
  }
}

void putBlock(BitWriter& writer, std::span<const std::uint8_t> bytes,
              const std::vector<Sequence>& sequences, bool last) {
  const Counts counts = count(bytes.data(), sequences);
  const auto literal = makeCode(counts.literal, longestCode);
  const auto distance = makeCode(counts.distance, longestCode);
  std::size_t bits = counts.extraBits + std::size_t{8} * 350;  // more than the lengths take
  for (std::size_t s = 0; s < literal.size(); ++s)
    bits += std::size_t{counts.literal[s]} * literal[s].length;
  for (std::size_t s = 0; s < distance.size(); ++s)
    bits += std::size_t{counts.distance[s]} * distance[s].length;
  if (bits / 8 >= bytes.size()) {
    putStored(writer, bytes, last);
    return;
  }
  writer.put(last ? 5 : 4, 3);  // type 2 in the upper two bits
  putCodeLengths(writer, literal, distance);
  // A copy of which no address is taken stays in registers; bytes written could alias any other.
  BitWriter out = writer;
  const std::uint8_t* in = bytes.data();
  for (const Sequence& sequence : sequences) {
    std::uint32_t k = 0;
    for (; k + 4 <= sequence.literals; k += 4) {
      for (std::uint32_t t = 0; t < 4; ++t) out.put(literal[in[k + t]]);
      out.flush();
    }
    for (; k < sequence.literals; ++k) out.put(literal[in[k]]);
    out.flush();
    in += sequence.literals + sequence.length;
    if (sequence.length == 0) continue;
    const Split length = splitLength(sequence.length), back = splitDistance(sequence.distance);
    out.put(literal[static_cast<std::size_t>(length.symbol)]);
    out.put(length.extra, length.extraLength);
    out.put(distance[static_cast<std::size_t>(back.symbol)]);
    out.put(back.extra, back.extraLength);
    out.flush();
  }
  out.put(literal[endOfBlock]);
  out.flush();
  writer = out;
}

}  // namespace

std::size_t fastZlibBound(std::size_t size) {
  // Stored blocks at worst: 5 bytes each, and one more block at each end of ours; slack for flush().
  return size + 10 * (size / 65535 + size / blockSize + 2) + 1024;
}

std::size_t fastZlib(std::span<const std::uint8_t> in, std::span<std::uint8_t> out) {
  SIMREEL_CHECK(out.size() >= fastZlibBound(in.size()));
  thread_local Parser parser;
  BitWriter writer(out.data());
  writer.put(0x0178, 16);  // deflate with a 32 KiB window, fastest
  writer.flush();
  if (in.empty()) {
    writer.put(3, 10);  // an empty block of fixed codes
    writer.flush();
  }
  for (std::size_t begin = 0; begin < in.size(); begin += blockSize) {
    const std::size_t end = std::min(begin + blockSize, in.size());
    putBlock(writer, in.subspan(begin, end - begin), parser.parse(in, begin, end), end == in.size());
  }
  writer.alignToByte();
  const std::uint32_t check = libdeflate_adler32(1, in.data(), in.size());
  for (const int shift : {24, 16, 8, 0}) writer.put((check >> shift) & 0xff, 8);
  writer.flush();
  return writer.size();
}

}  // namespace simreel::frame
