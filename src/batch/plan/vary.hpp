#pragma once
#include "scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace simreel::batch {

/// One parameter of a sweep: `path=a,b,c`, `path=first:last:step`, several of both, or `path=low:high`, a
/// range that --sample draws from. Commas within [ ], { } and quotes belong to the value.
struct Vary {
  std::string path;
  std::vector<std::string> values;  ///< as -D takes them; empty for a range
  double low = 0, high = 0;         ///< of a range
  [[nodiscard]] bool isRange() const { return values.empty(); }
};

/// Throws UserError(usage) saying what is wrong and how it is written.
[[nodiscard]] Vary parseVary(const std::string& text);

/// How several parameters make jobs.
enum class Combination {
  grid,   ///< each value with each, the last parameter fastest
  zip,    ///< the first of each, the second of each, ...
  sample  ///< some, drawn at random
};

inline constexpr std::size_t maxJobs = 100'000;

/// The values of each job, in the order of the parameters. Of --sample the seed decides alone: each range
/// is cut into `samples` equal parts and each part gets one job, and of listed values each comes as often
/// as any other, or once more; which of one meets which of another is by chance. Throws UserError(usage).
[[nodiscard]] std::vector<std::vector<scene::Override>> combine(const std::vector<Vary>& varied,
                                                                Combination how, std::size_t samples,
                                                                std::uint64_t seed);

}  // namespace simreel::batch
