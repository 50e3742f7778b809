#pragma once
#include "frame/image.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace simreel::golden {

/// Rejects files that cannot be compared exactly. These are files that are empty, cut off, corrupt (every
/// chunk's checksum is checked), animated, not PNG, or not the real file (placeholderProblem()). Throws
/// UserError(inputOutput) with a one-line message that starts with `what` ("baseline") and `name`.
void checkPng(std::span<const std::byte> file, const char* what, const std::string& name);

/// Reads, checks and decodes a PNG of at most 8 bits per channel. Throws the same errors as checkPng(),
/// also if the file cannot be read.
[[nodiscard]] frame::Image readPng(const std::filesystem::path& path, const char* what);

/// Returns width and height of a file that passed checkPng, or nothing if it is not a PNG.
[[nodiscard]] std::optional<std::pair<int, int>> sizeOfPng(std::span<const std::byte> file);

/// True if two files that passed checkPng have the same chunks except for text and time, which implies
/// equal pixels. False if one file is not a PNG. If the result is false, the pixels may still be equal.
[[nodiscard]] bool sameEncodedPixels(std::span<const std::byte> a, std::span<const std::byte> b);

}  // namespace simreel::golden
