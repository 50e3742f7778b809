#pragma once
#include <stdexcept>

namespace simreel::sim {

/// Error for an unreadable polygon file. Its text follows the file's name in messages: "has in line 3 ...".
class PolygonProblem : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace simreel::sim
