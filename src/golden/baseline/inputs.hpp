#pragma once
#include <filesystem>
#include <map>
#include <span>
#include <string>

namespace simreel::golden {

/// The hash of each file that a scene is made of, by its path: relative to this folder where it lies below
/// it, "<assets>/..." for one of the shipped assets, so that reports of other machines name the same. One
/// that may be there and is not (the sidecar) has an empty hash.
using Inputs = std::map<std::string, std::string>;

/// Of the scene, its sidecar, the files that it names, and the buffers that glTF names.
[[nodiscard]] Inputs inputsOf(const std::filesystem::path& scene,
                              std::span<const std::filesystem::path> named);

/// Throws UserError(usage) naming the first file that is no longer what it was.
void checkUnchanged(const Inputs& inputs);

}  // namespace simreel::golden
