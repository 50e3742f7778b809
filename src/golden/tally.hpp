#pragma once
#include "base/error.hpp"
#include "golden/result.hpp"

namespace simreel::golden {

/// What a run's results make of its exit code.
class Tally {
 public:
  /// `error`: what kept a result of Status::error from being one.
  void add(Status status, bool allowFlaky, ExitCode error = ExitCode::inputOutput);
  /// Something beside the results fails the run.
  void addFailure() { differs_ = true; }
  /// 1 when anything differs, else the code of the first error, else 3 when a baseline is missing, else 0;
  /// 5 when there was nothing.
  [[nodiscard]] ExitCode exitCode() const;

 private:
  bool differs_ = false, missing_ = false, any_ = false;
  ExitCode error_ = ExitCode::ok;
};

}  // namespace simreel::golden
