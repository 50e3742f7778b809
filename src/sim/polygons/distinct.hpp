#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace simreel::sim {

/// Assigns consecutive numbers, from 0 on, to keys in the order of their first use. `Hash` must return 64
/// well-mixed bits. The hash table uses open addressing and takes 4 to 16 bytes per key in addition to the
/// keys.
template <class Key, class Hash>
class Distinct {
 public:
  /// Returns a key's number, and true if the key is new.
  std::pair<unsigned, bool> number(const Key& key) {
    if (2 * (keys_.size() + 1) > slots_.size()) grow();
    const std::size_t at = find(key);
    if (slots_[at] != none) return {slots_[at], false};
    slots_[at] = static_cast<std::uint32_t>(keys_.size());
    keys_.push_back(key);
    return {slots_[at], true};
  }
  [[nodiscard]] const std::vector<Key>& keys() const { return keys_; }
  /// Returns the keys and leaves this object empty.
  [[nodiscard]] std::vector<Key> release() {
    slots_.clear();
    return std::move(keys_);
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// Returns the slot that a key has or would get.
  [[nodiscard]] std::size_t find(const Key& key) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = static_cast<std::size_t>(Hash{}(key)) & mask;
    while (slots_[at] != none && !(keys_[slots_[at]] == key)) at = (at + 1) & mask;
    return at;
  }

  void grow() {
    slots_.assign(slots_.empty() ? 64 : 2 * slots_.size(), none);
    for (std::size_t i = 0; i < keys_.size(); ++i) slots_[find(keys_[i])] = static_cast<std::uint32_t>(i);
  }

  std::vector<Key> keys_;
  std::vector<std::uint32_t> slots_;  ///< hash table; its size is a power of two
};

/// Computes a 64-bit hash of 32-bit words with the finalizer of MurmurHash3 (by Appleby).
class WordHash {
 public:
  void add(std::uint32_t word) {
    state_ = (state_ ^ word) * 0x9e3779b97f4a7c15U;
    state_ ^= state_ >> 32U;
  }
  [[nodiscard]] std::uint64_t value() const {
    std::uint64_t h = state_;
    h = (h ^ h >> 33U) * 0xff51afd7ed558ccdU;
    h = (h ^ h >> 33U) * 0xc4ceb9fe1a85ec53U;
    return h ^ h >> 33U;
  }

 private:
  std::uint64_t state_ = 0x2545f4914f6cdd1dU;
};

}  // namespace simreel::sim
