#include "cli/list/kind_notes.hpp"

#include <algorithm>
#include <array>

namespace simreel::cli {

std::span<const KindNotes> kindNotes() {
  static constexpr std::array<KindNotes, 19> all = {{
      {"cloth",
       "positions: place of each particle or vertex, m|"
       "velocities: m/s|"
       "trends: rates that constraints keep from step to step; only with a solver or fabric that has them",
       "Provot 1995, \"Deformation constraints in a mass-spring model\"|"
       "Macklin, Mueller and Chentanez 2016, \"XPBD\"|"
       "Macklin et al. 2019, \"Small steps in physics simulation\"|"
       "Baraff and Witkin 1998, \"Large steps in cloth simulation\"|"
       "Tonge, Benevolenski and Voroshilov 2012, \"Mass splitting\"|"
       "Timoshenko and Woinowsky-Krieger, *Theory of Plates and Shells*"},
      {"particles",
       "positions: place of each particle, m|"
       "velocities: m/s",
       "Barnes and Hut 1986, \"A hierarchical O(N log N) force-calculation algorithm\"|"
       "Barnes 1994 (opening criterion)|"
       "Hockney and Eastwood 1988, *Computer Simulation Using Particles*|"
       "Plummer 1911; Aarseth, Henon and Wielen 1974 (Plummer spheres)|"
       "Binney and Tremaine 2008, *Galactic Dynamics* (disks)|"
       "Bridson, Hourihan and Nordenstam 2007, \"Curl-noise\""},
      {"life",
       "cells: state of each cell|"
       "trail: steps since each cell last lived",
       "Gardner 1970, \"The fantastic combinations of John Conway's new solitaire game\"|"
       "Wolfram 1983, \"Statistical mechanics of cellular automata\"|"
       "Evans 1996 (Larger than Life)|"
       "Griffeath 1988 (cyclic automata)|"
       "Bryant 1986, \"Graph-based algorithms for Boolean function manipulation\"|"
       "Golly's notations and .rule files"},
      {"lenia", "cells: value of each cell, 0 to 1",
       "Chan 2019, \"Lenia: biology of artificial life\"|"
       "Rafler 2011, \"Generalization of Conway's Game of Life to a continuous domain\" (SmoothLife)"},
      {"grayScott", "cells: u and v of each cell",
       "Gray and Scott 1984|"
       "Pearson 1993, \"Complex patterns in a simple system\""},
      {"reaction", "cells: the species of each cell",
       "Patra and Karttunen 2006 (isotropic Laplacian)|"
       "O'Reilly and Beck 2006 (in a volume)|"
       "Pinkall and Polthier 1993 (on a mesh)|"
       "The presets name their own sources."},
      {"epidemic", "cells: state of each cell",
       "Kermack and McKendrick 1927, \"A contribution to the mathematical theory of epidemics\""},
      {"wildfire", "cells: state and fuel of each cell",
       "Alexandridis et al. 2008, \"A cellular automata model for forest fire spread prediction\""},
      {"fluid",
       "flow: velocity on the sides of cells, cells/s|"
       "dye: red, green and blue, and temperature, of each cell",
       "Harlow and Welch 1965 (staggered grid)|"
       "Chorin 1968; van Kan 1986 (projection)|"
       "Selle, Fedkiw, Kim, Liu and Rossignac 2008 (MacCormack)|"
       "Stam 1999, \"Stable fluids\"|"
       "Fedkiw, Stam and Jensen 2001, \"Visual simulation of smoke\" (confinement)|"
       "Batty, Bertails and Bridson 2007 (obstacles)|"
       "van Leer 1977 (dye)|"
       "Trottenberg, Oosterlee and Schueller, *Multigrid*|"
       "Cabral and Leedom 1993, \"Imaging vector fields using line integral convolution\""},
      {"water",
       "cells: level, depth and discharge of each cell|"
       "floats: place and motion of each float|"
       "displaced: water that floats displace",
       "Audusse, Bouchut, Bristeau, Klein and Perthame 2004 (well-balanced scheme)|"
       "Toro 2001, *Shock-Capturing Methods for Free-Surface Shallow Flows*|"
       "Kurganov and Petrova 2007 (thin water)|"
       "van Leer 1977 (slopes)|"
       "Manning 1891 (friction)"},
      {"cave",
       "cells: rock or floor|"
       "distances: steps from the entrance|"
       "tallies: what the solid's making counts",
       "Johnson, Yannakakis and Togelius 2010, \"Cellular automata for real-time generation of infinite "
       "cave levels\"|"
       "Shiloach and Vishkin 1982 (regions)|"
       "Lorensen and Cline 1987 (marching squares, in the plane)"},
      {"contour", "tallies: what the solid's making counts",
       "Lorensen and Cline 1987, \"Marching cubes\", in the plane"},
      {"mesh", "positions: place of each vertex, m; only of a mesh that is deformed",
       "Gerstner 1809 (waves); Tessendorf 2001|"
       "glTF 2.0 (materials of files)"},
      {"body", "positions: place of each vertex of the skin, m",
       "glTF 2.0 (skins and motions)|"
       "Eberly 2011, \"A fast and accurate algorithm for computing SLERP\""},
      {"sphere", "", ""},
      {"capsule", "", ""},
      {"plane", "", ""},
      {"text", "", "Open Sans, which ships with simreel"},
      {"chart", "", ""},
  }};
  return all;
}

KindNotes notesOf(std::string_view kind) {
  const auto all = kindNotes();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const KindNotes& one) { return one.kind == kind; });
  return found == all.end() ? KindNotes{} : *found;
}

}  // namespace simreel::cli
