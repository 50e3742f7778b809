#pragma once
#include "sim/cave/regions.hpp"

#include <string>
#include <vector>

namespace simreel::sim {

struct CaveWaveStart;
struct CaveWave;
struct CaveDisplay;
struct CaveWavePart;

/// Computes distances over a cave's open cells, in steps over edges, by breadth-first search on the GPU.
class CaveWaves {
 public:
  struct Farthest {
    unsigned cell = noCell;  ///< Lowest index among the cells farthest from the start.
    unsigned steps = 0;
  };

  CaveWaves(const std::string& name, const CaveGrid& grid);

  /// Computes the distances of all cells that can be reached from the open cell `start`, and returns the
  /// farthest cell. Waits for the GPU.
  Farthest run(const gl::Buffer& cells, unsigned start);
  /// Writes the distances of the last run to `field` as 32-bit floats, one per cell index. The value is -1
  /// for unreachable cells.
  void writeDistances(const gl::Buffer& cells, const gl::Buffer& field) const;
  /// Returns the distances of the last run, one per cell index. The value is noCell for unreachable cells.
  [[nodiscard]] std::vector<unsigned> distances() const { return distances_.readAll<unsigned>(); }

 private:
  [[nodiscard]] CaveWavePart part(const gl::Buffer& cells) const;

  CaveGrid grid_;
  gl::Kernel<CaveWaveStart> start_;
  gl::Kernel<CaveWave> waves_;
  gl::Kernel<CaveDisplay> display_;
  gl::Buffer distances_, queue_, wave_;
};

}  // namespace simreel::sim
