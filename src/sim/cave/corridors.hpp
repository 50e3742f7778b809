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

/// Joins the rooms of a cave by corridors along a minimum spanning tree: the distance between two rooms is
/// that of their nearest cells (L1); of equal ones the lowest goes first (Boruvka 1926). On the GPU, exact.
class CaveCorridors {
 public:
  CaveCorridors(const std::string& name, const CaveGrid& grid);

  /// `regions` has just labelled the open cells, of which there is at least one; what it counted is lost.
  /// Corridors are `width` cells across. Waits for the GPU.
  void dig(gl::Buffer& cells, const CaveRegions& regions, int width);

 private:
  void findNearest(const gl::Buffer& cells);
  void digChosen(const CaveTreesPart& part, int width) const;
  /// The trees that the rooms now form; false when there is but one.
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
