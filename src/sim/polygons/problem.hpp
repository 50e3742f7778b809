#pragma once
#include <stdexcept>

namespace simreel::sim {

/// Error for an unreadable polygon file. In messages, its text ("has in line 3 ...") follows the file's
/// name.
class PolygonProblem : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace simreel::sim
