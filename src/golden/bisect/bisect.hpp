#pragma once
#include "golden/trace/lines.hpp"
#include "golden/trace/pass_difference.hpp"
#include "golden/trace/state_difference.hpp"

#include <optional>
#include <string>
#include <vector>

namespace simreel::golden {

/// One of the two programs to compare.
struct BisectSide {
  std::string name;                    ///< name in messages: "this side"
  std::string command;                 ///< command for /bin/sh; `trace` and arguments are appended
  std::vector<std::string> arguments;  ///< arguments that select the run: the scene, its options and the
                                       ///< device
};

/// An array that differs after the first differing step.
struct DifferentArray {
  std::string object, array;
  ArrayDifference difference;
};

struct StateDifference {
  int frame = 0;
  int step = 0;  ///< number of the step in the frame, from 1 to `steps`; 0 means the initial state, before
                 ///< any step
  int steps = 0;
  std::vector<DifferentArray> arrays;  ///< arrays of one object; empty if the runs are not repeatable
  /// reason if the search stopped because a side is not repeatable; may be empty
  std::string unstable;
};

struct BisectResult {
  TraceHeader here, there;
  int lastFrame = 0;
  bool passes = false;  ///< true if the passes of pictures were compared, too
  std::optional<StateDifference> difference;
  /// first differing pass and pixel, if the states are equal but a picture differs
  std::optional<PassDifference> pass;
};

/// Finds the first frame, step and element at which two runs differ. Runs `trace` on both sides in three
/// stages. The first compares all frames in parallel, the second the steps of the first differing frame,
/// and the third the state itself. With `passes`, also compares the passes of exact pictures in frames with
/// equal state. If a child process fails, throws UserError with its message. Throws UserError(usage) if the
/// sides simulate different arrays, and Interrupted after SIGINT or SIGTERM.
[[nodiscard]] BisectResult bisect(const BisectSide& here, const BisectSide& there, int lastFrame,
                                  bool passes = false);

}  // namespace simreel::golden
