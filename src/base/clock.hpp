#pragma once
#include <chrono>

namespace simreel {

using Clock = std::chrono::steady_clock;

/// Seconds from `begin` to now.
[[nodiscard]] inline double secondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace simreel
