#pragma once
#include <algorithm>
#include <utility>
#include <vector>

namespace simreel::scene {

/// How a value moves between two keys.
enum class Ease { linear, smooth };

/// A value that may move along keyframes. Before the first and after the last key it holds still.
template <class T>
class Animated {
 public:
  struct Key {
    double time;  ///< s
    T value;
  };

  Animated() = default;
  Animated(T constant) : keys_{{0.0, constant}} {}  // NOLINT: a plain value is the common case
  Animated(std::vector<Key> keys, Ease ease) : keys_(std::move(keys)), ease_(ease) {}

  [[nodiscard]] bool moves() const { return keys_.size() > 1; }
  [[nodiscard]] const std::vector<Key>& keys() const { return keys_; }
  [[nodiscard]] Ease ease() const { return ease_; }

  /// Value at `seconds`. Smooth: s = 3u^2 - 2u^3 between neighbouring keys. Only plain arithmetic, so
  /// every machine computes the same bits.
  [[nodiscard]] T at(double seconds) const {
    if (keys_.empty()) return T{};
    const auto next =
        std::find_if(keys_.begin(), keys_.end(), [&](const Key& k) { return k.time > seconds; });
    if (next == keys_.begin()) return next->value;
    if (next == keys_.end()) return keys_.back().value;
    const Key& from = *(next - 1);
    double u = (seconds - from.time) / (next->time - from.time);
    if (ease_ == Ease::smooth) u = u * u * (3.0 - 2.0 * u);
    return from.value + (next->value - from.value) * static_cast<float>(u);
  }

 private:
  std::vector<Key> keys_ = {{0.0, T{}}};
  Ease ease_ = Ease::linear;
};

}  // namespace simreel::scene
