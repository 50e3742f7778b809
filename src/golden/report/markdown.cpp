#include "golden/report/markdown.hpp"

#include "golden/report/words.hpp"
#include "golden/result.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::golden {

namespace {

/// Max size of the summary. GitHub drops summaries above 1 MiB (1,048,576 bytes), and another step may
/// already have written some text.
constexpr std::size_t summaryBytes = 1'000'000;
constexpr std::size_t commandBytes = 50'000;
constexpr std::size_t cellBytes = 300;

/// Escapes text for Markdown, tables and HTML. Uses character references, which are never markup
/// (CommonMark 6.2). A backslash before '|' would not work, because tables are parsed first.
std::string markdown(std::string_view text) {
  constexpr std::string_view special = "&<>|`\\*_[]~#\"";
  std::string escaped;
  for (const char c : cleanText(text)) {
    if (c == '\n' || c == '\t')
      escaped += ' ';
    else if (special.find(c) != std::string_view::npos)
      escaped += fmt::format("&#{};", static_cast<int>(c));
    else
      escaped += c;
  }
  return escaped;
}

std::string cell(std::string_view text) {
  const std::string escaped = markdown(shortened(cleanText(text), cellBytes));
  return escaped.empty() ? "–" : escaped;
}

std::string failureRow(const SuiteResult& suite, const SceneResult& scene) {
  std::string frame, worst, beyond, ssim, flip;
  if (const FrameResult* f = worstFrame(scene)) {
    frame = std::to_string(f->frame);
    if (f->metrics) {
      worst = fmt::format("{:.4g}", f->metrics->worst);
      beyond = fmt::format("{} ({:.2f}%)", f->metrics->pixelsBeyond, 100 * f->metrics->ratioBeyond);
      if (f->metrics->ssim) ssim = fmt::format("{:.4f}", *f->metrics->ssim);
      if (f->metrics->flipMean) flip = fmt::format("{:.4f}", *f->metrics->flipMean);
    }
  }
  if (suite.unit == "picture")
    return fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", statusName(scene.status), cell(scene.name),
                       cell(worst), cell(beyond), cell(ssim), cell(flip), cell(firstReason(scene)));
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", statusName(scene.status),
                     cell(scene.name), cell(frame), cell(worst), cell(beyond), cell(ssim), cell(flip),
                     cell(scene.divergence ? scene.divergence->message : ""), cell(firstReason(scene)));
}

/// Lists the stale baselines and notes of the run.
std::string aboutRun(const SuiteResult& suite) {
  constexpr std::size_t maximum = 50;
  std::vector<std::string> lines;
  for (const Stale& stale : suite.stale)
    lines.push_back(fmt::format("- {}: {}: {}\n", stale.removed ? "removed" : "stale", cell(stale.path),
                                cell(stale.message)));
  for (const std::string& note : suite.notes) lines.push_back(fmt::format("- {}\n", cell(note)));
  if (lines.empty()) return "";
  if (lines.size() > maximum) {
    const std::size_t more = lines.size() - maximum;
    lines.resize(maximum);
    lines.push_back(fmt::format("- and {} more\n", more));
  }
  return fmt::format("{}\n", fmt::join(lines, ""));
}

std::string heading(const SuiteResult& suite) {
  const std::size_t failed = failures(suite).size();
  const auto scenes = counted(static_cast<long>(suite.scenes.size()), suite.unit);
  std::string text = failed == 0 ? fmt::format("## simreel: {} good\n\n", scenes)
                                 : fmt::format("## simreel: {} of {} failed\n\n", failed, scenes);
  std::string counts;
  for (int i = 0; i < statusCount; ++i)
    if (const long n = countOf(suite, static_cast<Status>(i)); n > 0)
      counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", n, statusName(static_cast<Status>(i)));
  const std::string where =
      suite.driver.empty() ? "" : fmt::format(" on {} ({})", cell(suite.driver), cell(suite.profile));
  text += fmt::format("{}{}{:.1f} s{}.\n\n", counts, counts.empty() ? "" : " in ", suite.seconds, where);
  text += aboutRun(suite);
  if (const std::string compared = comparedText(suite); !compared.empty())
    text += fmt::format("Pictures compared: {}.\n\n", compared);
  return text;
}

/// Returns the command in a code fence that is longer than any sequence of backticks in the command.
std::string commandBlock(const std::string& command) {
  if (command.empty()) return "";
  const std::string clean = cleanText(command);
  if (clean.size() > commandBytes)
    return "The command that accepts this run is too long to be shown here.\n";
  std::size_t run = 0, longest = 2;
  for (const char c : clean) longest = std::max(longest, run = c == '`' ? run + 1 : 0);
  const std::string fence(longest + 1, '`');
  return fmt::format("Look at the pictures first. To accept this run:\n\n{0}sh\n{1}\n{0}\n", fence, clean);
}

/// Returns as many lines as fit into `room` bytes, and the number of omitted lines.
std::pair<std::string, std::size_t> fitting(const std::vector<std::string>& lines, std::size_t room) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (text.size() + lines[i].size() > room) return {text, lines.size() - i};
    text += lines[i];
  }
  return {text, 0};
}

std::string leftOut(std::size_t count, const std::string& which) {
  if (count == 0) return "";
  return fmt::format("\n{} more {}{} left out here; report.json has all.\n", count, which,
                     count == 1 ? " is" : "s are");
}

/// Returns a table row with the pictures of the scene's worst frame.
std::string pictureRow(const SceneResult& scene, const PictureAddress& address) {
  const FrameResult* frame = worstFrame(scene);
  if (frame == nullptr || !address) return "";
  std::string row;
  bool any = false;
  for (const auto& [what, picture] :
       {std::pair("before", &frame->expectedImage), std::pair("after", &frame->actualImage),
        std::pair("difference", &frame->differenceImage)}) {
    const std::string where = picture->empty() ? "" : address(*picture);
    any = any || !where.empty();
    row += where.empty() ? " – |"
                         : fmt::format(" <img src=\"{}\" width=\"{}\" alt=\"{} ({})\"> |", where,
                                       thumbnailWidth, what, markdown(*picture));
  }
  return any ? fmt::format("| {} |{}\n", cell(scene.name), row) : "";
}

/// Returns a table with the pictures of at most 50 scenes, as many as fit into `room` bytes.
std::string pictureTable(const SuiteResult& suite, const PictureAddress& address, std::size_t room) {
  constexpr std::size_t maximum = 50;
  std::string rows;
  std::size_t shown = 0, left = 0;
  for (const SceneResult* scene : failures(suite)) {
    if (shown == maximum || rows.size() > room) {
      ++left;
      continue;
    }
    const std::string row = pictureRow(*scene, address);
    if (row.empty()) continue;
    if (rows.size() + row.size() > room) {
      ++left;
      continue;
    }
    rows += row;
    ++shown;
  }
  if (rows.empty()) return "";
  return fmt::format("| {} | Before | After | Difference |\n|---|---|---|---|\n{}{}\n",
                     suite.unit == "picture" ? "Picture" : "Scene", rows,
                     left == 0 ? "" : fmt::format("\nPictures of {} more are in the report.\n", left));
}

}  // namespace

std::string markdownSummary(const SuiteResult& suite, const PictureAddress& address) {
  std::vector<std::string> failed, good;
  for (const SceneResult& scene : suite.scenes) {
    if (isFailure(scene.status, suite.allowFlaky))
      failed.push_back(failureRow(suite, scene));
    else
      good.push_back(
          fmt::format("- {}: {} ({:.1f} s)\n", cell(scene.name), statusName(scene.status), scene.seconds));
  }
  std::string text = heading(suite);
  const std::string command = commandBlock(suite.acceptCommand);
  constexpr std::size_t words = 2000;  // space (bytes) for the headings and sentences around the lists
  const std::size_t used = text.size() + command.size() + words;
  if (!failed.empty()) {
    const auto [rows, more] = fitting(failed, summaryBytes - used);
    text += suite.unit == "picture" ? "| Status | Picture | Worst | Pixels beyond | SSIM | FLIP | Message "
                                      "|\n|---|---|--:|--:|--:|--:|---|\n"
                                    : "| Status | Scene | Frame | Worst | Pixels beyond | SSIM | FLIP | "
                                      "First divergence | Message |\n"
                                      "|---|---|--:|--:|--:|--:|--:|---|---|\n";
    text += rows + leftOut(more, "failing " + suite.unit) + "\n";
    if (const std::size_t taken = text.size() + command.size() + words; taken < summaryBytes)
      text += pictureTable(suite, address, summaryBytes - taken);
  }
  text += command;
  if (!good.empty()) {
    const auto [lines, more] = fitting(good, summaryBytes - std::min(summaryBytes, text.size() + words));
    text += fmt::format("\n<details><summary>{} did not fail</summary>\n\n",
                        counted(static_cast<long>(good.size()), suite.unit));
    text += lines + leftOut(more, "good " + suite.unit) + "\n</details>\n";
  }
  return text;
}

}  // namespace simreel::golden
