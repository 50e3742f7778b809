#pragma once
#include <string>
#include <vector>

namespace simreel::sim {

/// Parameters of objects that publish more fields than the one of their name: what follows the dot in the
/// names of these, as u in NAME.u.
struct FieldParts {
  virtual ~FieldParts() = default;
  [[nodiscard]] virtual std::vector<std::string> fieldParts() const = 0;
  /// Whether its cells are no grid, but those of a mesh.
  [[nodiscard]] virtual bool isOnMesh() const { return false; }

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
  /// Whether it takes fields of an object whose cells are no grid: cell by cell.
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
