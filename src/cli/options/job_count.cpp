#include "cli/options/job_count.hpp"

#include "base/error.hpp"
#include "base/processor.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace simreel::cli {

std::size_t jobCount(const std::string& jobs) {
  constexpr int maximum = 256;
  if (jobs == "auto") return std::min<std::size_t>(processorCount(), maximum);
  int count = 0;
  const char* const end = jobs.data() + jobs.size();
  const auto read = std::from_chars(jobs.data(), end, count);
  if (read.ec != std::errc() || read.ptr != end || count < 1 || count > maximum)
    fail(ExitCode::usage, "--jobs takes a number from 1 to {}, or auto, not \"{}\"", maximum, jobs);
  return static_cast<std::size_t>(count);
}

std::size_t jobCount(const std::string& jobs, const gl::ContextOptions& on) {
  return std::max(jobCount(jobs), on.deviceCount());
}

}  // namespace simreel::cli
