#pragma once
#include "scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace simreel::batch {

/// One parameter of a sweep. Its forms are `path=a,b,c`, `path=first:last:step`, several of these separated
/// by commas, or `path=low:high`, a range for --sample. Commas inside [ ], { } and quotes are part of the
/// value.
struct Vary {
  std::string path;
  std::vector<std::string> values;  ///< values in the syntax of -D; empty for a range
  double low = 0, high = 0;         ///< bounds of the range; unused if there are `values`
  [[nodiscard]] bool isRange() const { return values.empty(); }
};

/// Parses an argument of --vary. Throws UserError(usage) with the error and the correct forms.
[[nodiscard]] Vary parseVary(const std::string& text);

/// Method of combining the values of several parameters to jobs.
enum class Combination {
  grid,   ///< all combinations; the last parameter varies fastest
  zip,    ///< one job with the first value of each parameter, one with the second values, ...
  sample  ///< random combinations of values
};

inline constexpr std::size_t maxJobs = 100'000;

/// Returns the values of each job, in the order of the parameters. With Combination::sample, the result
/// depends only on `seed`. Each range is divided into `samples` equal parts, and one job gets a value from
/// each part. The numbers of times that listed values occur differ by at most one. The assignment of values
/// of different parameters to the same job is random. Throws UserError(usage).
[[nodiscard]] std::vector<std::vector<scene::Override>> combine(const std::vector<Vary>& varied,
                                                                Combination how, std::size_t samples,
                                                                std::uint64_t seed);

}  // namespace simreel::batch
