#pragma once
#include "sim/core/port.hpp"

#include <cstddef>
#include <map>
#include <string>

namespace simreel::sim {

/// Port of objects that measure quantities; its parts are their names, as OBJECT.QUANTITY.
struct Measured {
  static const PortInfo port;
};

/// Quantities of other objects that an object wants.
class QuantityReader {
 public:
  /// `links` outlives it; null: it reads nothing.
  QuantityReader(const Links* links, const scene::Object& wanter);

  /// Returns the quantity as it is now; waits for the GPU. Throws UserError(usage) for one that the object
  /// does not want or that its owner does not measure.
  double operator()(const std::string& object, const std::string& quantity) const;

 private:
  const Links* links_;
  std::map<std::string, std::size_t> indices_;  ///< OBJECT.QUANTITY: its place in Simulation::measure()
};

}  // namespace simreel::sim
