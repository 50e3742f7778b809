#include "golden/report/github.hpp"

#include "golden/report/words.hpp"
#include "golden/result.hpp"

#include <filesystem>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace simreel::golden {

namespace {

/// Max number of annotations of each kind that GitHub shows.
constexpr std::size_t shownLimit = 10;

/// Escapes the value of a workflow command (the part after "::"). Properties such as file= and title= must
/// also escape ':' and ',', which `separators` adds.
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

std::string lineAnnotation(const char* level, const std::string& place, const std::string& title,
                           const std::string& message) {
  return fmt::format("::{} {}title={}::{}\n", level, place, escaped(title, ":,"), escaped(message));
}

/// Returns an annotation for a scene. The path is relative to the current folder, without "./", which
/// GitHub does not accept.
std::string annotation(const char* level, const SceneResult& scene, std::string_view what,
                       const std::string& message) {
  const std::string named = scene.blame ? scene.blame->file : scene.file;
  const std::string file = std::filesystem::path(named).lexically_normal().string();
  std::string place = fmt::format("file={},", escaped(file, ":,"));
  if (scene.blame) place += fmt::format("line={},", scene.blame->line);
  return lineAnnotation(level, place, fmt::format("simreel: {} ({})", scene.name, what), message);
}

/// Joins the annotations of one kind. If there are too many, joins nine of them and one annotation with the
/// number of omitted annotations.
std::string asMany(const std::vector<std::string>& all, const char* level) {
  const std::size_t shown = all.size() <= shownLimit ? all.size() : shownLimit - 1;
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) text += all[i];
  if (shown < all.size())
    text += lineAnnotation(level, "", "simreel",
                           fmt::format("{} more; the summary and the report have all", all.size() - shown));
  return text;
}

}  // namespace

std::string githubAnnotations(const SuiteResult& suite) {
  std::vector<std::string> errors, warnings, notices;
  for (const SceneResult& scene : suite.scenes) {
    if (isFailure(scene.status, suite.allowFlaky)) {
      std::string message = firstReason(scene);
      if (!suite.acceptCommand.empty()) message += "\nTo accept: " + suite.acceptCommand;
      errors.push_back(annotation("error", scene, statusName(scene.status), message));
    } else if (scene.status == Status::flaky) {
      warnings.push_back(annotation("warning", scene, "flaky", firstReason(scene)));
    } else if (scene.status == Status::updated) {
      notices.push_back(annotation("notice", scene, "updated", firstReason(scene)));
    }
    for (const std::string& note : scene.notes)
      if (note.find("loose") != std::string::npos)
        warnings.push_back(annotation("warning", scene, "tolerance", note));
  }
  for (const Stale& stale : suite.stale) {
    SceneResult about;
    about.name = about.file = stale.path;
    if (!stale.removed)
      (suite.strict ? errors : warnings)
          .push_back(annotation(suite.strict ? "error" : "warning", about, "stale", stale.message));
  }
  return asMany(errors, "error") + asMany(warnings, "warning") + asMany(notices, "notice");
}

}  // namespace simreel::golden
