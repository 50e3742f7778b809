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

/// Searches the dispatches of a user's kernels for races. Each dispatch runs twice from the same state: the
/// first run records which invocation changes each word, the second run compares its accesses with the
/// record.
class KernelRaces {
 public:
  /// Throws the same errors as KernelPlan::shaderOf().
  KernelRaces(const std::string& name, const kernels::Request& request);

  /// Runs an entry's kernel in both variants. Afterwards the store holds the state after the dispatch. An
  /// entry that has been searched twice before runs once, without a search.
  void dispatch(KernelStore& store, const PlannedEntry& entry, const KernelPlan::Now& now);
  /// Returns the races found, one line each.
  [[nodiscard]] const std::vector<std::string>& found() const { return found_; }

 private:
  void collect(const KernelStore& store, const PlannedEntry& entry, const KernelPlan::Now& now,
               const std::vector<glm::uvec4>& words);

  std::string name_;
  std::shared_ptr<const kernels::Shader> recording_, checking_;
  KernelPrograms record_, check_;
  std::map<const PlannedEntry*, int> searches_;
  std::set<std::pair<int, std::size_t>> told_;  ///< kernels, and places in them
  std::vector<std::string> found_;
};

}  // namespace simreel::sim
