#include "golden/report/words.hpp"

#include "base/text.hpp"
#include "golden/baseline/origin.hpp"
#include "golden/compare/compare.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace simreel::golden {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // replacement character U+FFFD

/// True if every program can display this well-formed UTF-8 character.
bool isPlain(std::string_view character) {
  if (character == "\t" || character == "\n") return true;
  return !isTerminalControl(character) && character != "\xEF\xBF\xBE" &&
         character != "\xEF\xBF\xBF";  // noncharacters U+FFFE, U+FFFF
}

}  // namespace

std::string cleanText(std::string_view text) {
  std::string clean;
  clean.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t bytes = codePointLength(text, at);
    const std::string_view character = text.substr(at, std::max<std::size_t>(bytes, 1));
    if (character == "\r")
      clean += text.substr(at + 1, 1) == "\n" ? "" : "\n";
    else
      clean += bytes != 0 && isPlain(character) ? character : replacement;
    at += character.size();
  }
  return clean;
}

std::string_view firstLine(std::string_view text) {
  return text.substr(0, text.find_first_of("\r\n"));
}

std::string shortened(std::string_view text, std::size_t bytes) {
  if (text.size() <= bytes) return std::string(text);
  constexpr std::string_view rest = "...";
  std::size_t end = bytes - std::min(bytes, rest.size());
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80) --end;
  return std::string(text.substr(0, end)) + std::string(rest);
}

std::string counted(long count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::vector<std::string> reasons(const SceneResult& scene) {
  std::vector<std::string> lines;
  const auto add = [&](const std::string& line) {
    if (!line.empty() && std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
  };
  for (const std::string& message : scene.messages) add(message);
  for (const FrameResult& frame : scene.frames) add(frame.message);
  for (const CheckResult& check : scene.checks)
    if (!check.passed) add(check.message);
  if (scene.divergence) add(scene.divergence->message);
  return lines;
}

std::string firstReason(const SceneResult& scene) {
  const std::vector<std::string> all = reasons(scene);
  for (const std::string& reason : all)
    if (!firstLine(reason).empty()) return std::string(firstLine(reason));
  return scene.status == Status::flaky ? flakyText(scene) : wordsOf(scene.status).reason;
}

std::string flakyText(const SceneResult& scene) {
  return fmt::format("failed, then passed on attempt {}", scene.attempts.size() + 1);
}

std::string comparedText(const SceneResult& scene) {
  if (scene.asked.empty()) return "";
  if (scene.asked == requiredMatchName(RequiredMatch::exact)) return "exactly: drawn in exact arithmetic";
  if (scene.asked == requiredMatchName(RequiredMatch::equal))
    return "exactly: this machine drew the baseline";
  if (scene.asked == requiredMatchName(RequiredMatch::near))
    return fmt::format("within {} of 255: another machine with the same numerics drew the baseline",
                       nearChannel);
  return "within the tolerance: other numerics drew the baseline";
}

std::string comparedText(const SuiteResult& suite) {
  const auto count = [&](RequiredMatch asked) {
    return std::count_if(suite.scenes.begin(), suite.scenes.end(),
                         [&](const SceneResult& scene) { return scene.asked == requiredMatchName(asked); });
  };
  std::string text;
  if (const auto near = count(RequiredMatch::near); near > 0)
    text = fmt::format("{} within {} of 255 (another machine with the same numerics drew the baseline)",
                       counted(near, "scene"), nearChannel);
  if (const auto loose = count(RequiredMatch::tolerance); loose > 0)
    text += fmt::format("{}{} within the tolerance (other numerics drew the baseline)",
                        text.empty() ? "" : ", ", counted(loose, "scene"));
  return text;
}

long countOf(const SuiteResult& suite, Status status) {
  return std::count_if(suite.scenes.begin(), suite.scenes.end(),
                       [&](const SceneResult& scene) { return scene.status == status; });
}

const FrameResult* worstFrame(const SceneResult& scene) {
  const auto rank = [](const FrameResult& f) {
    return f.metrics ? std::pair(f.metrics->pixelsBeyond, f.metrics->worst) : std::pair(-1L, -1.0);
  };
  const FrameResult* worst = nullptr;
  for (const FrameResult& frame : scene.frames)
    if (frame.status != Status::pass && (worst == nullptr || rank(frame) > rank(*worst))) worst = &frame;
  return worst;
}

std::vector<const SceneResult*> failures(const SuiteResult& suite) {
  std::vector<const SceneResult*> found;
  for (const SceneResult& scene : suite.scenes)
    if (isFailure(scene.status, suite.allowFlaky)) found.push_back(&scene);
  return found;
}

}  // namespace simreel::golden
