#include "cli/compare/diff_report.hpp"

#include "base/text.hpp"
#include "golden/pictures/picture_folder.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::cli {

namespace {

using golden::Metrics;
using golden::PairResult;
using nlohmann::ordered_json;

std::string percent(double part, double whole) {
  return fmt::format("{:.3g}%", 100 * part / whole);
}

std::string verdict(const PairResult& result) {
  if (result.broken.empty()) return golden::outcomeName(result.outcome);
  return fmt::format("different: {}", fmt::join(result.broken, "; "));
}

ordered_json metricsJson(const Metrics& m) {
  // JSON has no infinity, so an infinite PSNR is written as null. A metric that was not measured is also
  // null.
  const auto measured = [](const std::optional<double>& value) {
    return value ? ordered_json(*value) : ordered_json(nullptr);
  };
  const ordered_json psnr = std::isfinite(m.psnr) ? ordered_json(m.psnr) : ordered_json(nullptr);
  return {{"worst", m.worst},
          {"worstX", m.worstX},
          {"worstY", m.worstY},
          {"differentPixels", m.differentPixels},
          {"pixelsBeyond", m.pixelsBeyond},
          {"ratioBeyond", m.ratioBeyond},
          {"windowRatio", m.windowRatio},
          {"windowX", m.windowX},
          {"windowY", m.windowY},
          {"psnr", psnr},
          {"ssim", measured(m.ssim)},
          {"flipMean", measured(m.flipMean)},
          {"maskedPixels", m.maskedPixels},
          {"antialiasedPixels", m.antialiasedPixels},
          {"movedPixels", m.movedPixels}};
}

/// Adds the members that the report of a single pair and of a pair in a sequence have in common. The JSON
/// text for pairs that differ within tolerance is "within".
void addResult(ordered_json& json, const PairResult& result) {
  json["result"] =
      result.outcome == PairResult::Outcome::within ? "within" : golden::outcomeName(result.outcome);
  if (result.width > 0) {
    json["width"] = result.width;
    json["height"] = result.height;
  }
  if (result.metrics) json["metrics"] = metricsJson(*result.metrics);
  if (!result.broken.empty()) json["broken"] = result.broken;
  if (!result.message.empty()) json["message"] = result.message;
  if (!result.notes.empty()) json["notes"] = result.notes;
}

std::string onlyLine(const std::vector<std::string>& names, const std::string& place) {
  if (names.empty()) return {};
  return oneLine(fmt::format("only in {}: {}", place, fmt::join(names, ", "))) + "\n";
}

/// Returns one line for each kind of pixel that was excluded from the comparison.
std::string excusedText(const Metrics& m) {
  std::string text;
  for (const auto& [count, what] :
       {std::pair(m.maskedPixels, "masked"), std::pair(m.antialiasedPixels, "of smoothed edges"),
        std::pair(m.movedPixels, "found nearby")})
    if (count > 0) text += fmt::format("left out        {} pixels {}\n", count, what);
  return text;
}

std::string notesText(const PairResult& result, const std::string& name = {}) {
  std::string text;
  for (const std::string& note : result.notes)
    text += oneLine(fmt::format("{}{}note: {}", name, name.empty() ? "" : ": ", note)) + "\n";
  return text;
}

}  // namespace

std::string pairText(const PairResult& result, const scene::Tolerance& tolerance) {
  if (!result.metrics) return verdict(result) + "\n";
  const Metrics& m = *result.metrics;
  const double pixels = double(result.width) * result.height;
  std::string text = fmt::format("size            {}x{}\n", result.width, result.height);
  text += m.worst == 0
              ? "worst pixel     0\n"
              : fmt::format("worst pixel     {:.4g} of 255 at x {}, y {}\n", m.worst, m.worstX, m.worstY);
  text += fmt::format("pixels          {} differ ({})", m.differentPixels,
                      percent(double(m.differentPixels), pixels));
  if (tolerance.maxChannelDiff > 0)
    text += fmt::format(", {} by more than {} ({})", m.pixelsBeyond, tolerance.maxChannelDiff,
                        percent(double(m.pixelsBeyond), pixels));
  text += fmt::format("\ndensest window  {}", percent(m.windowRatio, 1));
  if (m.windowRatio > 0)
    text += fmt::format(" of {}x{} pixels at x {}, y {}", std::min(tolerance.windowSize, result.width),
                        std::min(tolerance.windowSize, result.height), m.windowX, m.windowY);
  text += std::isfinite(m.psnr) ? fmt::format("\nPSNR            {:.3f} dB\n", m.psnr)
                                : std::string("\nPSNR            infinite\n");
  if (m.ssim && m.flipMean)
    text += fmt::format("SSIM            {:.6f}\nFLIP mean       {:.6f}\n", *m.ssim, *m.flipMean);
  return text + excusedText(m) + notesText(result) + verdict(result) + "\n";
}

ordered_json pairJson(const std::string& a, const std::string& b, const PairResult& result) {
  ordered_json json = {{"a", a}, {"b", b}};
  addResult(json, result);
  return json;
}

std::string pairLine(const golden::Pair& pair, const PairResult& result) {
  if (result.outcome == PairResult::Outcome::equal) return notesText(result, pair.name);
  if (result.outcome == PairResult::Outcome::unreadable)
    return oneLine(fmt::format("{}: unreadable: {}", pair.name, result.message)) + "\n";
  std::string line = oneLine(fmt::format("{}: {}", pair.name, verdict(result)));
  if (result.metrics) {
    const Metrics& m = *result.metrics;
    line +=
        fmt::format(" [worst {:.4g} at x {}, y {}; PSNR {:.2f} dB", m.worst, m.worstX, m.worstY, m.psnr);
    line += m.ssim && m.flipMean ? fmt::format("; SSIM {:.5f}; FLIP {:.5f}]", *m.ssim, *m.flipMean) : "]";
  }
  return line + "\n" + notesText(result, pair.name);
}

void SequenceReport::add(const golden::Pair& pair, const PairResult& result) {
  ++counts[result.outcome];
  ordered_json frame = {{"name", pair.name}};
  addResult(frame, result);
  frames.push_back(std::move(frame));
}

int SequenceReport::count(Outcome outcome) const {
  const auto found = counts.find(outcome);
  return found == counts.end() ? 0 : found->second;
}

bool SequenceReport::differs() const {
  return count(Outcome::different) > 0 || !onlyA.empty() || !onlyB.empty();
}

std::string SequenceReport::summary(const std::string& a, const std::string& b) const {
  std::string text = onlyLine(onlyA, a) + onlyLine(onlyB, b);
  if (!passedOver.empty()) text += fmt::format("skipped, not pictures: {}\n", golden::someOf(passedOver));
  text += fmt::format("{} pair{}: {} equal", frames.size(), frames.size() == 1 ? "" : "s",
                      count(Outcome::equal));
  for (const Outcome outcome : {Outcome::within, Outcome::different, Outcome::unreadable})
    if (const int n = count(outcome); n > 0)
      text += fmt::format(", {} {}", n, golden::outcomeName(outcome));
  if (const auto single = onlyA.size() + onlyB.size(); single > 0)
    text += fmt::format(", {} without a partner", single);
  return text + "\n";
}

ordered_json SequenceReport::json(const std::string& a, const std::string& b) const {
  const char* result = count(Outcome::unreadable) > 0 ? "unreadable"
                       : differs()                    ? "different"
                       : count(Outcome::within) > 0   ? "within"
                                                      : "equal";
  return {{"a", a},
          {"b", b},
          {"result", result},
          {"pairs", frames.size()},
          {"equal", count(Outcome::equal)},
          {"within", count(Outcome::within)},
          {"different", count(Outcome::different)},
          {"unreadable", count(Outcome::unreadable)},
          {"onlyInA", onlyA},
          {"onlyInB", onlyB},
          {"passedOver", passedOver},
          {"frames", frames}};
}

}  // namespace simreel::cli
