#pragma once
#include "kernels/compile/front_end.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace simreel::kernels {

/// Converts glslang's name of a file to the file's index in Files. Returns 0 (the first file) if the name
/// is not a valid index.
[[nodiscard]] std::size_t fileNumber(std::string_view name, std::size_t count);

/// Returns the errors of a glslang log with the message texts of glslang.
[[nodiscard]] std::vector<Mistake> errorsInLog(std::string_view log, std::size_t files);

/// Warning of glslang if the text has no function of the kernel's name.
inline constexpr const char* noEntry = "Entry point not found";

/// Returns the errors of a glslang log with clearer message texts. `failed`: names of includes that could
/// not be read, and the reasons.
[[nodiscard]] std::vector<Mistake> rewordedErrors(
    std::string_view log, const Files& files,
    const std::vector<std::pair<std::string, std::string>>& failed, const Unit& unit);

}  // namespace simreel::kernels
