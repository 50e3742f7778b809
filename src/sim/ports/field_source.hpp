#pragma once
#include "sim/core/drawable.hpp"
#include "sim/core/port.hpp"

#include <string>

namespace simreel::sim {

/// Port of objects that publish a field, named OBJECT, and fields for its parts, named OBJECT.PART.
struct FieldSource {
  static const PortInfo port;
};

/// Parameters of objects whose field cells do not form a grid of an image: they are the vertices of a mesh
/// or the layers of a volume.
struct OwnCells {
  virtual ~OwnCells() = default;
  /// Returns true if this object can read the fields of `other` cell by cell.
  [[nodiscard]] virtual bool readsCellsOf(const OwnCells& other) const = 0;

 protected:
  OwnCells() = default;
  OwnCells(const OwnCells&) = default;
  OwnCells& operator=(const OwnCells&) = default;
  OwnCells(OwnCells&&) = default;
  OwnCells& operator=(OwnCells&&) = default;
};

/// Returns the current field with the name OBJECT or OBJECT.PART. The pointers in it are valid until the
/// object's next step. Throws UserError(usage) for an unknown name.
[[nodiscard]] Field fieldNamed(const Links& links, const std::string& name);

}  // namespace simreel::sim
