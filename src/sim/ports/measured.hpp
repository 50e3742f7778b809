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

/// Reads the quantities of other objects that an object refers to.
class QuantityReader {
 public:
  /// `links` must outlive this object; null: reads nothing.
  QuantityReader(const Links* links, const scene::Object& wanter);

  /// Returns the current value of a quantity; waits for the GPU. Throws UserError(usage) if the object does
  /// not refer to the quantity or its owner does not measure it.
  double operator()(const std::string& object, const std::string& quantity) const;

 private:
  const Links* links_;
  std::map<std::string, std::size_t> indices_;  ///< OBJECT.QUANTITY: index into the result of
                                                ///< Simulation::measure()
};

}  // namespace simreel::sim
