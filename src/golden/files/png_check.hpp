#pragma once
#include "frame/image.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace simreel::golden {

/// Refuses what cannot be compared exactly: a file that is empty, cut off, corrupt (every chunk's checksum
/// is computed) or no PNG, and one whose pixels are not 8 bits of grey or colour, with or without alpha.
/// Throws UserError(inputOutput) in one line that begins with `what` ("baseline") and `name`.
void checkPng(std::span<const std::byte> file, const char* what, const std::string& name);

/// Fills `file`, whose memory is used again, with the bytes of a PNG file that checkPng is content with.
/// Throws as it does, also when the file cannot be read.
void readPngFile(const std::filesystem::path& path, const char* what, std::string& file);

/// Reads, checks and decodes. Throws as readPngFile does.
[[nodiscard]] frame::Image readPng(const std::filesystem::path& path, const char* what);

/// Whether two files that checkPng is content with hold the same chunks, text and time left out; their
/// pixels are equal then. Pixels of files for which this is false may still be equal.
[[nodiscard]] bool sameEncodedPixels(std::span<const std::byte> a, std::span<const std::byte> b);

}  // namespace simreel::golden
