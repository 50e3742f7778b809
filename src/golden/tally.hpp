#pragma once
#include "base/error.hpp"
#include "golden/result.hpp"

namespace simreel::golden {

/// Computes the exit code of a run from the results of all tests.
class Tally {
 public:
  /// `error` is the exit code to use for a result of Status::error.
  void add(Status status, bool allowFlaky, ExitCode error = ExitCode::inputOutput);
  /// Records a failure that does not belong to a result.
  void addFailure() { differs_ = true; }
  /// Returns 1 if any result differs, otherwise the code of the first error, otherwise 3 if a baseline is
  /// missing, and otherwise 0. Returns 5 if there were no results.
  [[nodiscard]] ExitCode exitCode() const;

 private:
  bool differs_ = false, missing_ = false, any_ = false;
  ExitCode error_ = ExitCode::ok;
};

}  // namespace simreel::golden
