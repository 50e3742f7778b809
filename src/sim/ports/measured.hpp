#pragma once
#include "sim/core/port.hpp"

#include <cstddef>
#include <map>
#include <string>

namespace simreel::sim {

/// Port of objects that measure quantities. Its parts are the names of the quantities, as in
/// OBJECT.QUANTITY.
struct Measured {
  static const PortInfo port;
};

/// Reads the quantities of other objects to which an object refers.
class QuantityReader {
 public:
  /// `links` must outlive this object; if it is null, nothing is read.
  QuantityReader(const Links* links, const scene::Object& wanter);

  /// Returns the current value of a quantity; waits for the GPU. Throws UserError(usage) if the reading
  /// object does not refer to the quantity or if `object` does not measure it.
  double operator()(const std::string& object, const std::string& quantity) const;

 private:
  const Links* links_;
  std::map<std::string, std::size_t> indices_;  ///< maps OBJECT.QUANTITY to an index into the result of
                                                ///< Simulation::measure()
};

}  // namespace simreel::sim
