#include "serve/beside/verdict_words.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::serve {

namespace {

bool hasNone(const golden::Reference& held) {
  return !held.pictures && !held.state;
}

std::string measuredWords(const golden::Metrics& metrics, const frame::Image& made) {
  const long pixels = static_cast<long>(made.width) * made.height;
  std::string text = fmt::format(
      "{} of {} pixels differ ({:.3g}%), by {:g} of 255 at most, at ({}, {})", metrics.differentPixels,
      pixels, 100.0 * static_cast<double>(metrics.differentPixels) / static_cast<double>(pixels),
      metrics.worst, metrics.worstX, metrics.worstY);
  if (metrics.flipMean) text += fmt::format("; mean FLIP error {:.3g}", *metrics.flipMean);
  if (metrics.ssim) text += fmt::format(", SSIM {:.4f}", *metrics.ssim);
  return text + ".";
}

}  // namespace

std::string verdictWords(const golden::FrameResult& frame, const golden::Reference& held,
                         const frame::Image& made) {
  if (hasNone(held))
    return fmt::format("This scene has no baseline yet, so frame {} cannot be compared.", frame.frame);
  std::string text;
  if (frame.metrics)
    text = measuredWords(*frame.metrics, made);
  else if (!frame.expectedPixels.empty() && frame.status == golden::Status::pass)
    text = frame.alternate > 0
               ? fmt::format("Every pixel is equal to the accepted alternate {}.", frame.alternate)
               : "Every pixel is equal to the baseline.";
  if (!frame.message.empty())
    text += fmt::format("{}Fails: {}.", text.empty() ? "" : " ", frame.message);
  else if (frame.metrics)
    text += " Near enough to pass.";
  return text;
}

std::string untestedWords(int frame, std::span<const int> tested, const golden::Reference& held) {
  return fmt::format("Frame {} is not a tested frame; {} {}.{}", frame,
                     tested.size() == 1 ? "that is" : "those are", fmt::join(tested, ", "),
                     hasNone(held) ? " The scene has no baseline yet." : "");
}

}  // namespace simreel::serve
