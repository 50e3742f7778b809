#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace simreel {

constexpr std::size_t hashDigits = 32;

/// Returns the 128-bit XXH3 hash of the bytes as lower-case hexadecimal digits. The hash is not
/// cryptographic.
[[nodiscard]] std::string hashHex(std::span<const std::byte> bytes);
[[nodiscard]] std::string hashHex(std::string_view text);

}  // namespace simreel
