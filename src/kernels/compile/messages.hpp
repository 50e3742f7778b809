#pragma once
#include "kernels/compile/front_end.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace simreel::kernels {

/// The number that a name of glslang's is; 0, the first file, for what is no number of a file.
[[nodiscard]] std::size_t fileNumber(std::string_view name, std::size_t count);

/// The mistakes of a log as glslang tells them.
[[nodiscard]] std::vector<Mistake> told(std::string_view log, std::size_t files);

/// Warning of glslang where the kernel has no function.
inline constexpr const char* noEntry = "Entry point not found";

/// The mistakes that a log of glslang's tells, in our words. `failed`: includes, and why they were not
/// read.
[[nodiscard]] std::vector<Mistake> explained(std::string_view log, const Files& files,
                                             const std::vector<std::pair<std::string, std::string>>& failed,
                                             const Unit& unit);

}  // namespace simreel::kernels
