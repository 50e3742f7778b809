#include "golden/baseline/stale.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "golden/baseline/baseline.hpp"
#include "golden/baseline/profile.hpp"

#include <algorithm>
#include <cctype>
#include <set>

namespace simreel::golden {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> entriesOf(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    entries.push_back(entry->path());
  if (error) fail(ExitCode::inputOutput, "cannot list folder {}: {}", folder.string(), error.message());
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// True for names like "000060.png" and "000060.alt2.png".
bool isPictureOfBaseline(const std::string& name) {
  const std::size_t digits = static_cast<std::size_t>(
      std::find_if(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c) == 0; }) -
      name.begin());
  const std::string rest = name.substr(digits);
  return digits >= 6 && (rest == ".png" || (rest.starts_with(".alt") && rest.ends_with(".png")));
}

bool isOfBaseline(const std::string& name) {
  return name == "baseline.json" || name == "state.json" || name == "steps.bin" ||
         isPictureOfBaseline(name);
}

/// Finds the unused baseline parts of one scene.
class StaleParts {
 public:
  StaleParts(const fs::path& folder, std::span<const int> frames, bool exactPictures, bool remove)
      : folder_(folder),
        frames_(frames.begin(), frames.end()),
        exactPictures_(exactPictures),
        remove_(remove) {}

  std::vector<Stale> find() {
    ofState(folder_);
    for (const fs::path& entry : entriesOf(folder_)) {
      std::error_code unknown;
      if (!fs::is_directory(entry, unknown)) continue;
      if (exactPictures_ && entry.filename() != sharedProfile && pathExists(entry / "baseline.json"))
        add(entry, "exact pictures have one baseline for all machines", remove_ && removeBaselines(entry));
      else
        ofProfile(entry);
    }
    return std::move(found_);
  }

 private:
  void add(const fs::path& path, const std::string& message, bool removed) {
    found_.push_back({path.generic_string(), message, removed});
  }

  /// Runs `look`, which checks the file `path`. If `look` throws a UserError, adds the file and the error
  /// to the result, and marks the file as not removed.
  template <class Look>
  void looking(const fs::path& path, const Look& look) {
    try {
      look();
    } catch (const UserError& error) {
      add(path, error.what(), false);
    }
  }

  void ofState(const fs::path& place) {
    const fs::path file = place / "state.json";
    looking(file, [&] {
      auto state = readState(place);
      if (!state) return;
      const auto gone = untested(state->frames);
      for (const int frame : gone) {
        state->frames.erase(frame);
        add(file, fmt::format("frame {} is not tested", frame), remove_);
      }
      if (remove_ && !gone.empty()) writeFileAtomically(file, stateText(*state));
    });
  }

  void ofProfile(const fs::path& place) {
    ofState(place);
    looking(place / "baseline.json", [&] {
      auto pictures = readPictures(folder_, place.filename().string());
      if (!pictures) return;
      const auto gone = untested(pictures->frames);
      for (const int frame : gone) {
        pictures->frames.erase(frame);
        add(place / pictureName(frame), fmt::format("frame {} is not tested", frame), remove_);
      }
      // Writes the list before deleting files. If deleting fails, a picture that is not listed does no
      // harm.
      if (remove_ && !gone.empty()) writeFileAtomically(place / "baseline.json", picturesText(*pictures));
      ofFiles(place, *pictures, gone);
    });
  }

  void ofFiles(const fs::path& place, const PictureBaseline& pictures, const std::set<int>& gone) {
    std::set<std::string> listed;
    for (const auto& [frame, stored] : pictures.frames)
      for (int i = 0; i <= static_cast<int>(stored.alternates.size()); ++i)
        listed.insert(pictureName(frame, i));
    for (const fs::path& file : entriesOf(place)) {
      const std::string name = file.filename().string();
      if (!isPictureOfBaseline(name) || listed.contains(name)) continue;
      const bool named = std::any_of(gone.begin(), gone.end(), [&](int frame) {
        return name.starts_with(fmt::format("{:06}.", frame));
      });
      if (!named) add(file, "no baseline.json lists it", remove_);
      if (remove_) removeFile(file);
    }
  }

  template <class Frames>
  std::set<int> untested(const Frames& frames) const {
    std::set<int> gone;
    for (const auto& [frame, stored] : frames)
      if (!frames_.contains(frame)) gone.insert(frame);
    return gone;
  }

  fs::path folder_;
  std::set<int> frames_;
  bool exactPictures_, remove_;
  std::vector<Stale> found_;
};

/// True if the folder or a direct subfolder contains a baseline file.
bool holdsBaselines(const fs::path& folder) {
  for (const fs::path& entry : entriesOf(folder)) {
    std::error_code unknown;
    if (fs::is_directory(entry, unknown)) {
      for (const fs::path& file : entriesOf(entry))
        if (isOfBaseline(file.filename().string())) return true;
    } else if (isOfBaseline(entry.filename().string())) {
      return true;
    }
  }
  return false;
}

void searchGolden(const fs::path& golden, std::vector<fs::path>& found) {
  for (const fs::path& entry : entriesOf(golden)) {
    std::error_code unknown;
    fs::path scene = golden.parent_path() / entry.filename();
    scene += ".json";
    if (fs::is_directory(entry, unknown) && !pathExists(scene) && holdsBaselines(entry))
      found.push_back(entry);
  }
}

}  // namespace

std::vector<Stale> staleParts(const fs::path& folder, std::span<const int> frames, bool exactPictures,
                              bool remove) {
  if (!pathExists(folder)) return {};
  return StaleParts(folder, frames, exactPictures, remove).find();
}

std::vector<fs::path> baselinesWithoutScene(std::span<const std::string> paths) {
  std::vector<fs::path> found;
  for (const std::string& path : paths) {
    std::error_code error;
    if (!fs::is_directory(path, error)) continue;
    fs::recursive_directory_iterator entries(path, error);
    if (!error && pathExists(fs::path(path) / "golden")) searchGolden(fs::path(path) / "golden", found);
    for (; !error && entries != fs::recursive_directory_iterator(); entries.increment(error)) {
      std::error_code unknown;
      if (!entries->is_directory(unknown)) continue;
      const std::string name = entries->path().filename().string();
      if (name.starts_with('.') || name == "golden")
        entries.disable_recursion_pending();
      else if (pathExists(entries->path() / "golden"))
        searchGolden(entries->path() / "golden", found);
    }
    if (error) fail(ExitCode::inputOutput, "cannot read folder {}: {}", path, error.message());
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool removeBaselines(const fs::path& folder) {
  bool all = true;
  for (const fs::path& entry : entriesOf(folder)) {
    std::error_code unknown;
    if (fs::is_directory(fs::symlink_status(entry, unknown)))
      all = removeBaselines(entry) && all;
    else if (isOfBaseline(entry.filename().string()))
      removeFile(entry);
    else
      all = false;
  }
  if (all) removeFile(folder);
  return all;
}

}  // namespace simreel::golden
