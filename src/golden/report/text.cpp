#include "golden/report/text.hpp"

#include "base/text.hpp"
#include "golden/report/words.hpp"
#include "golden/result.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

namespace simreel::golden {

namespace {

constexpr const char* green = "32";
constexpr const char* yellow = "33";
constexpr const char* red = "1;31";

const char* colorOf(Status status) {
  if (status == Status::xfail || status == Status::flaky) return yellow;
  return isFailure(status, false) ? red : green;
}

std::string painted(const std::string& text, const char* ansi, bool color) {
  return color ? fmt::format("\x1B[{}m{}\x1B[0m", ansi, text) : text;
}

/// Returns the status name, in capitals for failures so that they stand out.
std::string label(Status status) {
  std::string text = statusName(status);
  if (status != Status::flaky && isFailure(status, false))
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// Indents every line of `text` below the scene's name.
std::string indented(const std::string& text) {
  std::string lines;
  const std::string clean = cleanText(text);
  for (std::string_view rest = clean; !rest.empty();) {
    const std::string_view line = firstLine(rest);
    lines += fmt::format("      {}\n", line);
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
  }
  return lines;
}

std::string imageLine(const FrameResult& frame, const std::filesystem::path& folder, bool isPicture) {
  std::string line;
  const auto add = [&](const std::string& what, const std::string& path) {
    if (!path.empty())
      line += fmt::format("{}{} {}", line.empty() ? "" : ", ", what, (folder / path).string());
  };
  if (frame.status != Status::nondeterministic) {
    add("expected", frame.expectedImage);
    add("actual", frame.actualImage);
  }
  for (const OtherPicture& other : frame.others) add(other.label, other.image);
  add("difference", frame.differenceImage);
  if (line.empty()) return line;
  return (isPicture ? "pictures: " : fmt::format("pictures of frame {}: ", frame.frame)) + line;
}

std::string staleText(const SuiteResult& suite, bool color) {
  std::string text;
  for (const Stale& stale : suite.stale)
    text += fmt::format("{}  {}: {}\n", painted(stale.removed ? "removed" : "stale", yellow, color),
                        oneLine(stale.path), oneLine(stale.message));
  for (const std::string& note : suite.notes) text += "note: " + oneLine(note) + "\n";
  return text;
}

/// Returns the names of the scenes with a status: " (flag, curtain and 3 more)".
std::string namesOf(const SuiteResult& suite, Status status) {
  constexpr long maxNames = 5;
  const long count = countOf(suite, status);
  std::string names;
  long shown = 0;
  for (const SceneResult& scene : suite.scenes) {
    if (scene.status != status || shown == maxNames) continue;
    names += (shown++ == 0 ? "" : ", ") + oneLine(scene.name);
  }
  if (count > shown) names += fmt::format(" and {} more", count - shown);
  return " (" + names + ")";
}

}  // namespace

std::string sceneLine(const SceneResult& scene, bool color, const std::filesystem::path& reportFolder,
                      const std::string& unit) {
  const bool isPicture = unit == "picture";
  std::string about = isPicture ? "" : counted(static_cast<long>(scene.frames.size()), "frame") + ", ";
  about += fmt::format("{:.1f} s", scene.seconds);
  if (scene.status == Status::xfail && !scene.xfail.empty()) about += ": " + oneLine(scene.xfail);
  if (scene.status == Status::flaky) about += ": " + flakyText(scene);
  std::string text =
      fmt::format("{}  {}  ({})\n", painted(label(scene.status), colorOf(scene.status), color),
                  oneLine(scene.name), about);
  if (isFailure(scene.status, false)) {
    const std::vector<std::string> why = reasons(scene);
    if (why.empty() && scene.status != Status::flaky) text += indented(firstReason(scene));
    for (const std::string& reason : why) text += indented(reason);
    for (std::size_t i = 0; i < scene.attempts.size(); ++i)
      for (const std::string& message : scene.attempts[i].messages)
        text += indented(fmt::format("attempt {}: {}", i + 1, message));
    for (const FrameResult& frame : scene.frames)
      if (frame.status != Status::pass || !frame.others.empty())
        text += indented(imageLine(frame, reportFolder, isPicture));
  }
  for (const std::string& note : scene.notes) text += indented("note: " + note);
  return text;
}

std::string closingText(const SuiteResult& suite, bool color, const std::filesystem::path& report) {
  std::string counts;
  for (int i = 0; i < statusCount; ++i) {
    const auto status = static_cast<Status>(i);
    const long count = countOf(suite, status);
    if (count == 0) continue;
    const std::string names = isFailure(status, false) ? namesOf(suite, status) : "";
    counts +=
        (counts.empty() ? ": " : ", ") +
        painted(fmt::format("{} {}{}", count, wordsOf(status).counted, names), colorOf(status), color);
  }
  std::string text = staleText(suite, color);
  text += fmt::format("{}{} in {:.1f} s\n", counted(static_cast<long>(suite.scenes.size()), suite.unit),
                      counts, suite.seconds);
  if (const auto stale =
          std::count_if(suite.stale.begin(), suite.stale.end(), [](const Stale& s) { return !s.removed; });
      stale > 0)
    text +=
        fmt::format("{} that nothing is tested against; --update=prune removes {}, --strict fails for {}\n",
                    counted(static_cast<long>(stale), "stale baseline"), stale == 1 ? "it" : "them",
                    stale == 1 ? "it" : "them");
  if (const std::string compared = comparedText(suite); !compared.empty())
    text += fmt::format("Pictures compared: {}\n", oneLine(compared));
  if (!suite.acceptCommand.empty()) text += fmt::format("To accept: {}\n", oneLine(suite.acceptCommand));
  if (!report.empty()) text += fmt::format("Report: {}\n", oneLine(report.string()));
  return text;
}

}  // namespace simreel::golden
