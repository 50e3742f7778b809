#pragma once
#include "frame/image.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace simreel::golden {

/// Refuses what cannot be compared exactly: a file that is empty, cut off, corrupt (every chunk's checksum
/// is computed), animated, no PNG, or stands for another (standsForAnother()). Throws
/// UserError(inputOutput) in one line that begins with `what` ("baseline") and `name`.
void checkPng(std::span<const std::byte> file, const char* what, const std::string& name);

/// Reads, checks and decodes a PNG of at most 8 bits a channel. Throws as checkPng does, also when the file
/// cannot be read.
[[nodiscard]] frame::Image readPng(const std::filesystem::path& path, const char* what);

/// Width and height of a file that checkPng is content with; nothing where it is no PNG.
[[nodiscard]] std::optional<std::pair<int, int>> sizeOfPng(std::span<const std::byte> file);

/// Whether two files that checkPng is content with hold the same chunks, text and time left out; their
/// pixels are equal then. False where one is no PNG. Pixels of files for which this is false may still be
/// equal.
[[nodiscard]] bool sameEncodedPixels(std::span<const std::byte> a, std::span<const std::byte> b);

}  // namespace simreel::golden
