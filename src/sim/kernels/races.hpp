#pragma once
#include "kernels/kernels.hpp"
#include "sim/kernels/memory.hpp"
#include "sim/kernels/plan.hpp"
#include "sim/kernels/programs.hpp"

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace simreel::sim {

/// Searches the dispatches of a user's kernels for data races. Each dispatch runs twice from the same
/// state: the first run records which invocation changes each word, and the second run compares its
/// accesses with that record.
class KernelRaces {
 public:
  /// Throws the same errors as KernelPlan::shaderOf().
  KernelRaces(const std::string& name, const kernels::Request& request);

  /// Runs an entry's kernel in both variants. Afterwards, the store holds the state after the dispatch. If
  /// the entry has already been checked twice, runs it once without a check.
  void dispatch(KernelStore& store, const PlannedEntry& entry, const KernelPlan::Now& now);
  /// Returns one line for each race that was found.
  [[nodiscard]] const std::vector<std::string>& found() const { return found_; }

 private:
  void collect(const KernelStore& store, const PlannedEntry& entry, const KernelPlan::Now& now,
               const std::vector<glm::uvec4>& words);

  std::string name_;
  KernelPrograms record_, check_;
  std::map<const PlannedEntry*, int> searches_;
  std::set<std::pair<int, std::size_t>> reported_;  ///< kernels and source positions in them for which a
                                                    ///< race was reported
  std::vector<std::string> found_;
};

}  // namespace simreel::sim
