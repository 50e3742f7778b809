#pragma once
#include <string>
#include <vector>

namespace simreel::sim {

/// Parameters of objects that publish more fields than the one of their name: what follows the dot in the
/// names of these, as u in NAME.u.
struct FieldParts {
  virtual ~FieldParts() = default;
  [[nodiscard]] virtual std::vector<std::string> fieldParts() const = 0;
  /// Where its cells are no grid of the picture: what an object is on, and who takes its field, as " on a
  /// mesh, whose field only one on the same mesh takes".
  [[nodiscard]] virtual std::string takenBy() const { return {}; }

 protected:
  FieldParts() = default;
  FieldParts(const FieldParts&) = default;
  FieldParts& operator=(const FieldParts&) = default;
  FieldParts(FieldParts&&) = default;
  FieldParts& operator=(FieldParts&&) = default;
};

/// Parameters of objects that take in fields of others: their names, an object or NAME.u, and where the
/// parameters name them.
struct FieldReading {
  struct From {
    std::string name;
    std::vector<std::string> path;
  };
  virtual ~FieldReading() = default;
  [[nodiscard]] virtual std::vector<From> readsFields() const = 0;
  /// Whether it takes fields of an object whose cells are no grid of the picture: of the same mesh cell by
  /// cell, of a volume of the same proportions.
  [[nodiscard]] virtual bool readsCellsOf(const FieldParts& /*other*/) const { return false; }

 protected:
  FieldReading() = default;
  FieldReading(const FieldReading&) = default;
  FieldReading& operator=(const FieldReading&) = default;
  FieldReading(FieldReading&&) = default;
  FieldReading& operator=(FieldReading&&) = default;
};

/// A simulation that does.
class FieldReader {
 public:
  virtual ~FieldReader() = default;
  /// Once, before readOthers: whose field it is that has this name.
  virtual void meets(const std::string& /*field*/, const FieldParts& /*owner*/) {}
  /// Before any object of a frame steps, and once when all are made: takes in the fields as they are then,
  /// so that no order counts and objects may read one another.
  virtual void readOthers() = 0;

 protected:
  FieldReader() = default;
  FieldReader(const FieldReader&) = default;
  FieldReader& operator=(const FieldReader&) = default;
  FieldReader(FieldReader&&) = default;
  FieldReader& operator=(FieldReader&&) = default;
};

}  // namespace simreel::sim
