#pragma once
#include "sim/cave/regions.hpp"

#include <string>

namespace simreel::sim {

struct CaveTreesPart;
struct CaveRooms;
struct CaveNearest;
struct CaveWeigh;
struct CaveDig;
struct CaveLink;
struct CaveFollow;
struct CaveMerge;

/// Connects the rooms of a cave by corridors along a minimum spanning tree (Boruvka 1926). The distance
/// between two rooms is the L1 distance of their nearest cells; among equal distances, the lowest index is
/// chosen. Runs on the GPU and is exact.
class CaveCorridors {
 public:
  CaveCorridors(const std::string& name, const CaveGrid& grid);

  /// Digs corridors of `width` cells. Call it directly after `regions` has labelled the open cells; there
  /// must be at least one. Overwrites the counts of `regions`. Waits for the GPU.
  void dig(gl::Buffer& cells, const CaveRegions& regions, int width);

 private:
  void findNearest(const gl::Buffer& cells);
  void digChosen(const CaveTreesPart& part, int width) const;
  /// Merges the trees of rooms that the chosen edges connect. Returns false if only one tree remains.
  bool joinTrees(const CaveTreesPart& part);

  std::string name_;
  CaveGrid grid_;
  gl::Kernel<CaveRooms> rooms_;
  gl::Kernel<CaveNearest> nearest_;
  gl::Kernel<CaveWeigh> weigh_;
  gl::Kernel<CaveDig> dig_;
  gl::Kernel<CaveLink> link_;
  gl::Kernel<CaveFollow> follow_;
  gl::Kernel<CaveMerge> merge_;
  gl::Buffer sources_, nextSources_, weights_, edges_, links_, dug_, flags_;
};

}  // namespace simreel::sim
