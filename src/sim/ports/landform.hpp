#pragma once
#include "sim/core/port.hpp"
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Port of objects with a surface whose heights isolines can join.
class Landform {
 public:
  static const PortInfo port;

  virtual ~Landform() = default;
  /// Returns the surface of the finished frame as triangles in world space. Reads it back from the GPU.
  [[nodiscard]] virtual MeshTable landform() const = 0;

 protected:
  Landform() = default;
  Landform(const Landform&) = default;
  Landform& operator=(const Landform&) = default;
  Landform(Landform&&) = default;
  Landform& operator=(Landform&&) = default;
};

}  // namespace simreel::sim
