#pragma once
#include "sim/cave/regions.hpp"

#include <string>
#include <vector>

namespace simreel::sim {

struct CaveWaveStart;
struct CaveWave;
struct CaveShow;
struct CaveWavePart;

/// Distances over the open cells of a cave, in steps over edges, by breadth-first waves on the GPU.
class CaveWaves {
 public:
  struct Farthest {
    unsigned cell = noCell;  ///< the lowest of those that lie farthest from the start
    unsigned steps = 0;
  };

  CaveWaves(const std::string& name, const CaveGrid& grid);

  /// Of every cell that can be reached from an open one. Waits for the GPU.
  Farthest run(const gl::Buffer& cells, unsigned start);
  /// The distances of the last run as 32-bit floats, -1 where it did not come, into `field`: one for each
  /// number of a cell.
  void show(const gl::Buffer& cells, const gl::Buffer& field) const;
  /// Of the last run, one for each number of a cell, noCell where it did not come.
  [[nodiscard]] std::vector<unsigned> distances() const { return distances_.readAll<unsigned>(); }

 private:
  [[nodiscard]] CaveWavePart part(const gl::Buffer& cells) const;

  CaveGrid grid_;
  gl::Kernel<CaveWaveStart> start_;
  gl::Kernel<CaveWave> waves_;
  gl::Kernel<CaveShow> show_;
  gl::Buffer distances_, queue_, wave_;
};

}  // namespace simreel::sim
