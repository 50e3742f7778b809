#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace simreel::golden {

/// A scene to test. `name` is the path below the given folder, without extension. It is unique within a
/// set.
struct SceneFile {
  std::string name;
  std::filesystem::path file;
};

/// Returns the scenes in files and folders, sorted by name. A given file is always included. Folders are
/// searched recursively, except hidden folders and folders named "golden". A .json file in a folder is
/// included unless it is a sidecar (*.test.json) or valid JSON with neither "version" nor "objects". Throws
/// UserError(usage) for a path that does not exist.
[[nodiscard]] std::vector<SceneFile> findScenes(std::span<const std::string> paths);

/// Returns the scenes whose name or path matches one of the globs (`*`, `?`, `[a-z]`; `*` also matches
/// '/'). Returns all scenes if there are no globs.
[[nodiscard]] std::vector<SceneFile> filtered(const std::vector<SceneFile>& scenes,
                                              std::span<const std::string> globs);
/// True if the whole name matches the glob.
[[nodiscard]] bool matches(const std::string& glob, const std::string& name);

/// Parses "k/n" with 1 <= k <= n. Throws UserError(usage).
[[nodiscard]] std::pair<std::size_t, std::size_t> shardNumbers(const std::string& shard);
/// Returns every n-th item, starting with item k (from 1), for `shard` "k/n". Throws UserError(usage).
template <class Item>
[[nodiscard]] std::vector<Item> shardOf(const std::vector<Item>& all, const std::string& shard) {
  const auto [k, n] = shardNumbers(shard);
  std::vector<Item> kept;
  for (std::size_t i = k - 1; i < all.size(); i += n) kept.push_back(all[i]);
  return kept;
}
/// Returns text such as "shard 2/4: 8 of 33 scenes".
[[nodiscard]] std::string shardNote(const std::string& shard, std::size_t tested, std::size_t whole,
                                    const char* unit);

}  // namespace simreel::golden
