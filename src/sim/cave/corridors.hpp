#pragma once
#include "sim/cave/regions.hpp"

#include <string>

namespace simreel::sim {

/// Joins the rooms of a cave by corridors along a minimum spanning tree: the distance between two rooms is
/// that of their nearest cells (L1); of equal ones the lowest goes first (Boruvka 1926). On the GPU, exact.
class CaveCorridors {
 public:
  CaveCorridors(const std::string& name, const CaveGrid& grid);

  /// `regions` has just labelled the open cells, of which there is at least one; what it counted is lost.
  /// Corridors are `width` cells across. Waits for the GPU.
  void dig(gl::Buffer& cells, const CaveRegions& regions, int width);

 private:
  void findNearest();
  void digChosen(int width);
  /// The trees that the rooms now form; false when there is but one.
  bool joinTrees();

  std::string name_;
  CaveGrid grid_;
  gl::Program rooms_, nearest_, weigh_, dig_, link_, follow_, merge_;
  gl::Buffer sources_, nextSources_, weights_, edges_, links_, dug_, flags_;
};

}  // namespace simreel::sim
