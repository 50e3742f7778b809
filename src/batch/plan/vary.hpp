#pragma once
#include "scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace simreel::batch {

/// One parameter of a sweep: `path=a,b,c`, `path=first:last:step`, several of both, or `path=low:high`, a
/// range for --sample. Commas within [ ], { } and quotes belong to the value.
struct Vary {
  std::string path;
  std::vector<std::string> values;  ///< values as -D takes them; empty for a range
  double low = 0, high = 0;         ///< bounds of the range, if the parameter is one
  [[nodiscard]] bool isRange() const { return values.empty(); }
};

/// Parses an argument of --vary. Throws UserError(usage) with the error and the correct forms.
[[nodiscard]] Vary parseVary(const std::string& text);

/// Way of combining several parameters to jobs.
enum class Combination {
  grid,   ///< all combinations; the last parameter varies fastest
  zip,    ///< the first value of each parameter, then the second of each, ...
  sample  ///< random combinations of values
};

inline constexpr std::size_t maxJobs = 100'000;

/// Returns the values of each job, in the order of the parameters. Combination::sample depends only on
/// `seed`: each range is cut into `samples` equal parts with one job in each part; listed values occur
/// equally often, up to a difference of one; which values meet in a job is random. Throws UserError(usage).
[[nodiscard]] std::vector<std::vector<scene::Override>> combine(const std::vector<Vary>& varied,
                                                                Combination how, std::size_t samples,
                                                                std::uint64_t seed);

}  // namespace simreel::batch
