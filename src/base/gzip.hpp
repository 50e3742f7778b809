#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace simreel {

/// True if bytes begin as a gzip file (RFC 1952).
[[nodiscard]] bool isGzip(std::string_view bytes);

/// Contents of a gzip file, its members one after the other. `name` is what messages call it. Throws
/// UserError(inputOutput) for one that is cut off or damaged, and usage for one that holds more than
/// `maxBytes`.
[[nodiscard]] std::string unpackedGzip(std::string_view bytes, const std::string& name,
                                       std::size_t maxBytes);

}  // namespace simreel
