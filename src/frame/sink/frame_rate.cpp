#include "frame/sink/frame_rate.hpp"

#include "base/log.hpp"

#include <cmath>
#include <cstddef>
#include <numeric>

namespace simreel::frame {

namespace {

FrameRate rateOf(double fps) {
  if (std::abs(fps - std::round(fps)) < 1e-9) return {std::lround(fps), 1};
  const double film = fps * 1.001;
  if (std::abs(film - std::round(film)) < 1e-3) return {std::lround(film) * 1000, 1001};
  constexpr long parts = 1000;
  return {std::lround(fps * parts), parts};
}

}  // namespace

std::string FrameRate::text(char between) const {
  return fmt::format("{}{}{}", numerator, between, denominator);
}

FrameRate playedRate(double fps, std::span<const int> frames) {
  FrameRate rate = rateOf(fps);
  if (frames.size() < 2) return rate;
  const long step = long{frames[1]} - frames[0];
  for (std::size_t i = 1; i < frames.size(); ++i)
    if (long{frames[i]} - frames[i - 1] != step) {
      warn("the frames are not evenly spaced; each is shown for 1/{:g} s all the same", fps);
      return rate;
    }
  rate.denominator *= step;
  const long common = std::gcd(rate.numerator, rate.denominator);
  if (step != 1) rate = {rate.numerator / common, rate.denominator / common};
  return rate;
}

}  // namespace simreel::frame
