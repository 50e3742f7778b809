#pragma once
#include <stdexcept>

namespace simreel::sim {

/// A file of polygons that cannot be read. The text follows the file's name: "has in line 3 ...".
class PolygonProblem : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace simreel::sim
