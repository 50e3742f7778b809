#include "golden/report/github.hpp"

#include "golden/report/words.hpp"
#include "golden/result.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::golden {

namespace {

/// GitHub drops a summary above 1 MiB (1,048,576 bytes); another step may have written before.
constexpr std::size_t summaryBytes = 1'000'000;
constexpr std::size_t commandBytes = 50'000;
constexpr std::size_t cellBytes = 300;

/// The value of a workflow command, the part after "::"; of a property (file=, title=) ':' and ',' are
/// separators as well.
std::string escaped(std::string_view text, std::string_view separators = "") {
  std::string result;
  for (const char c : cleanText(text)) {
    if (c == '%' || c == '\n' || separators.find(c) != std::string_view::npos)
      result += fmt::format("%{:02X}", static_cast<int>(c));
    else
      result += c;
  }
  return result;
}

/// Relative to the folder the program ran in; GitHub wants no "./" before it.
std::string annotation(const char* level, const SceneResult& scene, std::string_view what,
                       const std::string& message) {
  const std::string file = std::filesystem::path(scene.file).lexically_normal().string();
  return fmt::format("::{} file={},title={}::{}\n", level, escaped(file, ":,"),
                     escaped(fmt::format("simreel: {} ({})", scene.name, what), ":,"), escaped(message));
}

/// Text that Markdown, its tables and HTML show as it is. A character reference is never markup (CommonMark
/// 6.2), unlike a backslash before '|', which tables read first.
std::string markdown(std::string_view text) {
  constexpr std::string_view special = "&<>|`\\*_[]~#";
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

/// The frame that a table of one line a scene shows: the one with most pixels beyond the tolerance among
/// those that did not pass.
const FrameResult* worstFrame(const SceneResult& scene) {
  const auto rank = [](const FrameResult& f) {
    return f.metrics ? std::pair(f.metrics->pixelsBeyond, f.metrics->worst) : std::pair(-1L, -1.0);
  };
  const FrameResult* worst = nullptr;
  for (const FrameResult& frame : scene.frames)
    if (frame.status != Status::pass && (worst == nullptr || rank(frame) > rank(*worst))) worst = &frame;
  return worst;
}

std::string failureRow(const SuiteResult& suite, const SceneResult& scene) {
  std::string frame, worst, beyond, ssim, flip;
  if (const FrameResult* f = worstFrame(scene)) {
    frame = std::to_string(f->frame);
    if (f->metrics) {
      worst = fmt::format("{:.4g}", f->metrics->worst);
      beyond = fmt::format("{} ({:.2f}%)", f->metrics->pixelsBeyond, 100 * f->metrics->ratioBeyond);
      ssim = fmt::format("{:.4f}", f->metrics->ssim);
      flip = fmt::format("{:.4f}", f->metrics->flipMean);
    }
  }
  if (suite.unit == "picture")
    return fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", statusName(scene.status), cell(scene.name),
                       cell(worst), cell(beyond), cell(ssim), cell(flip), cell(firstReason(scene)));
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", statusName(scene.status),
                     cell(scene.name), cell(frame), cell(worst), cell(beyond), cell(ssim), cell(flip),
                     cell(scene.divergence ? scene.divergence->message : ""), cell(firstReason(scene)));
}

/// What is stale, and notes of the run.
std::string aboutRun(const SuiteResult& suite) {
  constexpr std::size_t most = 50;
  std::vector<std::string> lines;
  for (const Stale& stale : suite.stale)
    lines.push_back(fmt::format("- {}: {}: {}\n", stale.removed ? "removed" : "stale", cell(stale.path),
                                cell(stale.message)));
  for (const std::string& note : suite.notes) lines.push_back(fmt::format("- {}\n", cell(note)));
  if (lines.empty()) return "";
  if (lines.size() > most) {
    const std::size_t more = lines.size() - most;
    lines.resize(most);
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

/// The command in a fence longer than any run of backticks in it.
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

/// As many of the lines as fit into `room` bytes, and how many do not.
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

}  // namespace

std::string githubAnnotations(const SuiteResult& suite) {
  std::string errors, warnings, notices;
  for (const SceneResult& scene : suite.scenes) {
    if (isFailure(scene.status, suite.allowFlaky)) {
      std::string message = firstReason(scene);
      if (!suite.acceptCommand.empty()) message += "\nTo accept: " + suite.acceptCommand;
      errors += annotation("error", scene, statusName(scene.status), message);
    } else if (scene.status == Status::flaky) {
      warnings += annotation("warning", scene, "flaky", firstReason(scene));
    } else if (scene.status == Status::updated) {
      notices += annotation("notice", scene, "updated", firstReason(scene));
    }
    for (const std::string& note : scene.notes)
      if (note.find("loose") != std::string::npos)
        warnings += annotation("warning", scene, "tolerance", note);
  }
  for (const Stale& stale : suite.stale) {
    SceneResult about;
    about.name = about.file = stale.path;
    if (!stale.removed)
      (suite.strict ? errors : warnings) +=
          annotation(suite.strict ? "error" : "warning", about, "stale", stale.message);
  }
  // GitHub shows the first ten of a kind.
  return errors + warnings + notices;
}

std::string githubSummary(const SuiteResult& suite) {
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
  constexpr std::size_t words = 2000;  // of the headings and sentences around the lists
  const std::size_t used = text.size() + command.size() + words;
  if (!failed.empty()) {
    const auto [rows, more] = fitting(failed, summaryBytes - used);
    text += suite.unit == "picture" ? "| Status | Picture | Worst | Pixels beyond | SSIM | FLIP | Message "
                                      "|\n|---|---|--:|--:|--:|--:|---|\n"
                                    : "| Status | Scene | Frame | Worst | Pixels beyond | SSIM | FLIP | "
                                      "First divergence | Message |\n"
                                      "|---|---|--:|--:|--:|--:|--:|---|---|\n";
    text += rows + leftOut(more, "failing " + suite.unit) + "\n";
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
