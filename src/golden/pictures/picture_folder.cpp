#include "golden/pictures/picture_folder.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "golden/files/picture.hpp"

#include <algorithm>
#include <string_view>

namespace simreel::golden {

namespace fs = std::filesystem;

namespace {

constexpr const char* reportMark = "simreel-report.txt";

}  // namespace

void markReport(const fs::path& folder) {
  if (isReport(folder)) return;
  writeFileAtomically(folder / reportMark,
                      std::string_view("The pictures in and below this folder belong to a report that "
                                       "simreel test wrote. It does not use them as baselines.\n"));
}

bool isReport(const fs::path& folder) {
  return pathExists(folder / reportMark);
}

PictureFolder listPictures(const fs::path& folder) {
  PictureFolder found;
  std::error_code error;
  fs::recursive_directory_iterator entries(folder, fs::directory_options::follow_directory_symlink, error);
  for (; !error && entries != fs::recursive_directory_iterator(); entries.increment(error)) {
    constexpr int deepest = 100;
    const fs::path path = entries->path();
    const std::string name = path.lexically_relative(folder).generic_string();
    if (entries.depth() > deepest)
      fail(ExitCode::inputOutput,
           "cannot search folder {}: its links go round in a circle, or it is deeper than {}",
           folder.string(), deepest);
    std::error_code unknown;
    if (entries->is_directory(unknown)) {
      if (!path.filename().string().starts_with('.') && !isReport(path)) continue;
      entries.disable_recursion_pending();
      found.others.push_back(name + "/");
    } else {
      (isPictureName(path) || holdsPicture(path) ? found.pictures : found.others).push_back(name);
    }
  }
  if (error) fail(ExitCode::inputOutput, "cannot list folder {}: {}", folder.string(), error.message());
  std::sort(found.pictures.begin(), found.pictures.end());
  std::sort(found.others.begin(), found.others.end());
  return found;
}

std::string someOf(const std::vector<std::string>& names) {
  constexpr std::size_t maximum = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(maximum, names.size()); ++i)
    text += (i == 0 ? "" : ", ") + oneLine(names[i]);
  if (names.size() > maximum) text += fmt::format(" and {} more", names.size() - maximum);
  return text;
}

}  // namespace simreel::golden
