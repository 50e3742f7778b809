#include "batch/plan/plan_json.hpp"

#include "base/error.hpp"
#include "base/file.hpp"

namespace simreel::batch {

PlanJson overrideList(const std::vector<scene::Override>& overrides) {
  PlanJson list = PlanJson::array();
  for (const scene::Override& change : overrides) list.push_back(change.path + "=" + change.value);
  return list;
}

PlanJson folderList(const std::vector<std::filesystem::path>& folders) {
  PlanJson list = PlanJson::array();
  for (const std::filesystem::path& folder : folders) list.push_back(folder.string());
  return list;
}

std::vector<scene::Override> overridesIn(const JsonValue& list) {
  std::vector<scene::Override> overrides;
  for (const std::string& text : list.texts()) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) list.wrong("must be path=value");
    overrides.push_back({text.substr(0, equals), text.substr(equals + 1)});
  }
  return overrides;
}

std::vector<std::filesystem::path> foldersIn(const JsonValue& list) {
  std::vector<std::filesystem::path> folders;
  for (const std::string& folder : list.texts()) folders.emplace_back(folder);
  return folders;
}

std::string lineOf(const PlanJson& value) {
  return value.dump(-1, ' ', false, PlanJson::error_handler_t::replace);
}

std::string openObject(const PlanJson& members) {
  std::string text = members.dump(2, ' ', false, PlanJson::error_handler_t::replace);
  text.resize(text.size() - 2);  // The closing " }" is removed, because more members follow.
  return text;
}

std::string readPlan(const std::filesystem::path& file, const char* what) {
  constexpr std::size_t maxBytes = std::size_t{1} << 28U;
  if (!pathExists(file))
    fail(ExitCode::usage, "{} contains no {}: there is no file {}",
         file.parent_path().empty() ? "." : file.parent_path().string(), what, file.string());
  return readFile(file, "plan", maxBytes);
}

void expectFormat(const JsonValue& object, const char* format, int version) {
  if (const auto found = object.find("format"); !found || !found->is(format))
    throw JsonError(fmt::format("its format is not {}", format));
  if (const int found = object.at("version").integer(); found != version)
    throw JsonError(fmt::format("its version is {}, this program reads {}", found, version));
}

}  // namespace simreel::batch
