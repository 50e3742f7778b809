#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace simreel::golden {

/// One side of a bisection: a shell command that answers as `simreel trace` does when options of trace are
/// appended to it.
struct Side {
  std::string command;
};

/// Where two sides first differ.
struct Difference {
  int frame = 0;  ///< that is being stepped to; negative in the pre-roll
  int step = 0;   ///< from 1; 0: in the first state
  int steps = 0;
  std::string object, array;
  long element = 0;                 ///< vec4
  int component = 0;                ///< 0 to 3
  std::uint32_t words[2] = {0, 0};  ///< the component's bits on both sides
  long elementsThatDiffer = 0;
  std::uint32_t mostUlp = 0;  ///< largest distance of two floats, in units in the last place
};

struct Bisection {
  std::string drivers[2], versions[2];
  int frames = 0;  ///< compared
  std::optional<Difference> difference;
};

/// Runs both sides, first frame by frame until they differ, then step by step in that frame, then compares
/// the arrays. `lastFrame`: of the run; nothing: the scene's. Throws UserError(inputOutput) when a side
/// fails or does not speak as `simreel trace` does, usage when they simulate different arrays.
[[nodiscard]] Bisection bisect(const Side (&sides)[2], std::optional<int> lastFrame);

}  // namespace simreel::golden
