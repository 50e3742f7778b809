#pragma once
#include "base/error.hpp"
#include "golden/result.hpp"

namespace simreel::golden {

/// Accumulates results into the exit code of a run.
class Tally {
 public:
  /// `error` is the exit code to use for a result of Status::error.
  void add(Status status, bool allowFlaky, ExitCode error = ExitCode::inputOutput);
  /// Records a failure that does not belong to a result.
  void addFailure() { differs_ = true; }
  /// Returns 1 if anything differs, else the code of the first error, else 3 if a baseline is missing, else
  /// 0. Returns 5 if nothing was added.
  [[nodiscard]] ExitCode exitCode() const;

 private:
  bool differs_ = false, missing_ = false, any_ = false;
  ExitCode error_ = ExitCode::ok;
};

}  // namespace simreel::golden
