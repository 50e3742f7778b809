#pragma once
#include <filesystem>
#include <map>
#include <span>
#include <string>

namespace simreel::golden {

/// Hash of each input file of a scene, by path. Paths are relative to the current folder if the file is
/// below it. Paths of shipped assets are "<assets>/...", so that reports of different machines use the same
/// names. An optional file that does not exist (the sidecar) has an empty hash.
using Inputs = std::map<std::string, std::string>;

/// Returns the hashes of the scene, its sidecar, the files that it names, and the buffers of named glTF
/// files.
[[nodiscard]] Inputs inputsOf(const std::filesystem::path& scene,
                              std::span<const std::filesystem::path> named);

/// Throws UserError(usage) if the content of any file has changed. The message names the first such file.
void checkUnchanged(const Inputs& inputs);

}  // namespace simreel::golden
