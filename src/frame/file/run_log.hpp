#pragma once
#include "frame/file/run_info.hpp"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace simreel::frame {

/// One program's part in an output: what it ran on, when, and the frames that it drew.
struct RunRecord {
  std::string program;  ///< version
  std::string host;
  long process = 0;
  std::string began;  ///< UTC, 2026-11-25T03:24:06.123Z
  double seconds = 0;
  std::string driver, processor, fingerprint;
  std::string command;
  std::vector<std::string> folders;
  std::set<int> frames;

  /// Whether both are of the same process.
  [[nodiscard]] bool isOf(const RunRecord& other) const {
    return host == other.host && process == other.process && began == other.began;
  }
  /// Processor and driver; empty where the processor is not known.
  [[nodiscard]] std::string machine() const;
};

/// run.json, beside a manifest: all that the manifest leaves out since it differs from one run of a scene
/// to the next.
struct RunLog {
  std::vector<RunRecord> runs;  ///< in the order in which they began to write

  /// What is known of the machine that drew a frame; empty where none is.
  [[nodiscard]] std::string machineOf(int frame) const;
  /// Puts a run's record in place of its former one. Its frames are nobody else's any more; who has none
  /// left is forgotten.
  void put(const RunRecord& record);
};

/// Of this process, which begins now.
[[nodiscard]] RunRecord beginRecord(const RunInfo& run);
[[nodiscard]] std::string runLogText(const RunLog& log);
/// Throws UserError(usage) naming the file and what is wrong in it.
[[nodiscard]] RunLog parseRunLog(const std::string& text, const std::string& name);
/// Empty where there is none, or none that can be read: it tells of what is past, and nothing depends on
/// it.
[[nodiscard]] RunLog readRunLog(const std::filesystem::path& file);

}  // namespace simreel::frame
