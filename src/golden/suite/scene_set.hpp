#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace simreel::golden {

/// A scene to test. `name` is unique in a set: the path below the folder that was given, without extension.
struct SceneFile {
  std::string name;
  std::filesystem::path file;
};

/// The scenes among files and folders, sorted by name. A file is taken as it is. A folder is searched with
/// all below it, except hidden folders and those called "golden"; a .json file there counts unless it is a
/// sidecar (*.test.json) or plainly something else: valid JSON with neither "version" nor "objects". Throws
/// UserError(usage) for a path that does not exist.
[[nodiscard]] std::vector<SceneFile> findScenes(std::span<const std::string> paths);

/// Those whose name or path matches one of the globs (`*`, `?`, `[a-z]`; `*` crosses '/'); all without
/// globs.
[[nodiscard]] std::vector<SceneFile> filtered(const std::vector<SceneFile>& scenes,
                                              std::span<const std::string> globs);
/// Whether the whole name matches the glob.
[[nodiscard]] bool matches(const std::string& glob, const std::string& name);

/// k and n of "k/n", 1 <= k <= n. Throws UserError(usage).
[[nodiscard]] std::pair<std::size_t, std::size_t> shardNumbers(const std::string& shard);
/// The k-th of n nearly equal parts, "k/n" counted from 1, as every n-th item. Throws UserError(usage).
template <class Item>
[[nodiscard]] std::vector<Item> shardOf(const std::vector<Item>& all, const std::string& shard) {
  const auto [k, n] = shardNumbers(shard);
  std::vector<Item> kept;
  for (std::size_t i = k - 1; i < all.size(); i += n) kept.push_back(all[i]);
  return kept;
}
/// "shard 2/4: 8 of 33 scenes"
[[nodiscard]] std::string shardNote(const std::string& shard, std::size_t tested, std::size_t whole,
                                    const char* unit);

}  // namespace simreel::golden
