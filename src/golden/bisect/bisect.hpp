#pragma once
#include "golden/trace/lines.hpp"
#include "golden/trace/pass_difference.hpp"
#include "golden/trace/state_difference.hpp"

#include <optional>
#include <string>
#include <vector>

namespace simreel::golden {

/// One of the two programs that are compared.
struct BisectSide {
  std::string name;                    ///< in messages: "this side"
  std::string command;                 ///< for /bin/sh; `trace` and the arguments are appended
  std::vector<std::string> arguments;  ///< scene, its options, the device: what says which run it is
};

/// An array that differs after the first step that does.
struct DifferentArray {
  std::string object, array;
  ArrayDifference difference;
};

struct StateDifference {
  int frame = 0;
  int step = 0;  ///< of `steps`, from 1; 0: the first state, before any step
  int steps = 0;
  std::vector<DifferentArray> arrays;  ///< those of one object; none when the runs do not repeat
  std::string unstable;  ///< why the search ended early: a side does not repeat itself; or empty
};

struct BisectResult {
  TraceHeader here, there;
  int lastFrame = 0;
  bool passes = false;  ///< whether pictures were compared, too
  std::optional<StateDifference> difference;
  std::optional<PassDifference> pass;  ///< of the first picture that differs, where the state does not
};

/// Finds the first frame, step and element at which two runs differ, by running `trace` on both sides:
/// frame by frame side by side, then the steps of the first frame that differs, then the state itself.
/// Throws UserError with a child's own message when it fails, UserError(usage) when the sides simulate
/// different arrays, and Interrupted after SIGINT or SIGTERM. `passes`: compares the passes of exact
/// pictures, too, of frames whose states are equal.
[[nodiscard]] BisectResult bisect(const BisectSide& here, const BisectSide& there, int lastFrame,
                                  bool passes = false);

}  // namespace simreel::golden
