#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace simreel {

/// True if the bytes begin like a gzip file (RFC 1952).
[[nodiscard]] bool isGzip(std::string_view bytes);

/// Returns the contents of a gzip file, with all its members concatenated. `name`: name of the file in
/// messages. Throws UserError(inputOutput) if the data are truncated or damaged, and UserError(usage) if
/// they unpack to more than `maxBytes`.
[[nodiscard]] std::string unpackedGzip(std::string_view bytes, const std::string& name,
                                       std::size_t maxBytes);

}  // namespace simreel
