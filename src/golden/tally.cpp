#include "golden/tally.hpp"

namespace simreel::golden {

void Tally::add(Status status, bool allowFlaky, ExitCode error) {
  any_ = true;
  if (status == Status::missing)
    missing_ = true;
  else if (status == Status::error)
    error_ = error_ == ExitCode::ok ? error : error_;
  else if (isFailure(status, allowFlaky))
    differs_ = true;
}

ExitCode Tally::exitCode() const {
  if (differs_) return ExitCode::different;
  if (!any_) return ExitCode::nothingRan;
  if (error_ != ExitCode::ok) return error_;
  return missing_ ? ExitCode::baselineMissing : ExitCode::ok;
}

}  // namespace simreel::golden
