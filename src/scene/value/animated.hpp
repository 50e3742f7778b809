#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace simreel::scene {

/// Interpolation between two keys. linear: straight line. smooth: the velocity is 0 at every key. spline:
/// the velocity is continuous, and 0 at the first and last key. hold: the value is constant until the next
/// key.
enum class Ease { linear, smooth, spline, hold };
inline constexpr std::array<const char*, 4> easeWords = {"linear", "smooth", "spline", "hold"};

/// Value that is constant or changes along keyframes. It is constant before the first key and after the
/// last. Two keys at the same time make the value jump. At that time the value of the second key applies.
template <class T>
class Animated {
 public:
  struct Key {
    double time;  ///< time of the key in seconds
    T value;
  };

  Animated() = default;
  Animated(T constant) : keys_{{0.0, constant}} {}  // NOLINT: a plain value is the common case
  Animated(std::vector<Key> keys, Ease ease) : keys_(std::move(keys)), ease_(ease) {}

  [[nodiscard]] bool moves() const { return keys_.size() > 1; }
  [[nodiscard]] const std::vector<Key>& keys() const { return keys_; }
  [[nodiscard]] Ease ease() const { return ease_; }

  /// Returns the time in seconds of the last jump at or before `seconds`. A jump is made by two keys at the
  /// same time or, with Ease::hold, by any key with a new value. Returns minus infinity if the value has
  /// not jumped.
  [[nodiscard]] double jumpedBy(double seconds) const {
    for (std::size_t k = keys_.size(); k-- > 1;)
      if (keys_[k].time <= seconds && keys_[k].value != keys_[k - 1].value &&
          (ease_ == Ease::hold || keys_[k].time == keys_[k - 1].time))
        return keys_[k].time;
    return -std::numeric_limits<double>::infinity();
  }
  /// Returns the value at `seconds`. Ease::smooth uses 3u^2 - 2u^3, where u is the fraction of the time
  /// between two adjacent keys. Ease::spline uses a cubic with the velocities of speedAt(). Both use only
  /// basic arithmetic, so that every machine computes the same bits.
  [[nodiscard]] T at(double seconds) const {
    if (keys_.empty()) return T{};
    const auto next =
        std::find_if(keys_.begin(), keys_.end(), [&](const Key& k) { return k.time > seconds; });
    if (next == keys_.begin()) return next->value;
    if (next == keys_.end()) return keys_.back().value;
    const Key& from = *(next - 1);
    if (ease_ == Ease::hold) return from.value;
    double u = (seconds - from.time) / (next->time - from.time);
    if (ease_ == Ease::spline) return splined(static_cast<std::size_t>(next - keys_.begin()) - 1, u);
    if (ease_ == Ease::smooth) u = u * u * (3.0 - 2.0 * u);
    return from.value + (next->value - from.value) * static_cast<float>(u);
  }

 private:
  static double part(const T& value, int i) {
    if constexpr (std::is_arithmetic_v<T>)
      return static_cast<double>(value);
    else
      return static_cast<double>(value[i]);
  }
  /// Returns the slope per second of component i between keys k and k + 1, whose times must differ.
  [[nodiscard]] double slope(std::size_t k, int i) const {
    return (part(keys_[k + 1].value, i) - part(keys_[k].value, i)) / (keys_[k + 1].time - keys_[k].time);
  }
  /// Returns the velocity per second of component i at key k. This is the weighted harmonic mean of the
  /// slopes on both sides (Fritsch and Butland 1984), which prevents overshoot. Returns 0 at the first and
  /// last key. At a jump, returns the slope on the side away from the jump.
  [[nodiscard]] double speedAt(std::size_t k, int i) const {
    if (k == 0 || k + 1 == keys_.size()) return 0;
    if (keys_[k - 1].time == keys_[k].time) return slope(k, i);
    if (keys_[k + 1].time == keys_[k].time) return slope(k - 1, i);
    const double before = slope(k - 1, i), after = slope(k, i);
    if (!(before * after > 0)) return 0;
    const double long_ = keys_[k].time - keys_[k - 1].time, next = keys_[k + 1].time - keys_[k].time;
    const double first = 2 * next + long_, second = next + 2 * long_;
    return (first + second) / (first / before + second / after);
  }
  /// Returns the spline's value between keys k and k + 1. u is the fraction of the time between them.
  [[nodiscard]] T splined(std::size_t k, double u) const {
    const double seconds = keys_[k + 1].time - keys_[k].time, v = 1 - u;
    const auto one = [&](int i) {
      const double from = part(keys_[k].value, i), to = part(keys_[k + 1].value, i);
      return static_cast<float>(from * (v * v * (1 + 2 * u)) + to * (u * u * (1 + 2 * v)) +
                                seconds * u * v * (speedAt(k, i) * v - speedAt(k + 1, i) * u));
    };
    if constexpr (std::is_arithmetic_v<T>) {
      return static_cast<T>(one(0));
    } else {
      T value{};
      for (int i = 0; i < T::length(); ++i) value[i] = one(i);
      return value;
    }
  }

  std::vector<Key> keys_ = {{0.0, T{}}};
  Ease ease_ = Ease::linear;
};

/// True if the value is always 0.
template <class T>
bool isNothing(const Animated<T>& value) {
  return !value.moves() && value.at(0) == T(0);
}

}  // namespace simreel::scene
