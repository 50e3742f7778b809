#include "cli/list/kind_notes.hpp"

#include <algorithm>
#include <array>

namespace simreel::cli {

std::span<const KindNotes> kindNotes() {
  static constexpr std::array<KindNotes, 20> all = {{
      {"cloth",
       "positions: x, y, z: place of each particle or vertex, m; w: 1 / mass, 1/kg, 0 while it is pinned|"
       "velocities: m/s|"
       "trends: part of each velocity that constraints gave it in the last substep, m/s; only with "
       "constraints, a fabric or a mesh, and not of a grid that keeps its energy",
       "Provot 1995, \"Deformation constraints in a mass-spring model\"|"
       "Macklin, Mueller and Chentanez 2016, \"XPBD\"|"
       "Macklin et al. 2019, \"Small steps in physics simulation\"|"
       "Baraff and Witkin 1998, \"Large steps in cloth simulation\"|"
       "Tonge, Benevolenski and Voroshilov 2012, \"Mass splitting\"|"
       "Timoshenko and Woinowsky-Krieger, *Theory of Plates and Shells*"},
      {"particles",
       "positions: x, y, z: place of each particle, m; w: mass, kg|"
       "velocities: x, y, z: m/s; w: age from 0 to 1, below 0 while the particle does not live",
       "Barnes and Hut 1986, \"A hierarchical O(N log N) force-calculation algorithm\"|"
       "Barnes 1994 (opening criterion)|"
       "Hockney and Eastwood 1988, *Computer Simulation Using Particles*|"
       "Plummer 1911; Aarseth, Henon and Wielen 1974 (Plummer spheres)|"
       "Binney and Tremaine 2008, *Galactic Dynamics* (disks)|"
       "Bridson, Hourihan and Nordenstam 2007, \"Curl-noise\""},
      {"life",
       "cells: state of each cell: a bit with two states, else a byte|"
       "trail: a byte for each cell: its brightness, the greatest while it lives, then \"trail\" after "
       "death and one less after each step; only with a \"trail\" and two states",
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
      {"epidemic", "cells: state of each cell, and its age in steps of the trail",
       "Kermack and McKendrick 1927, \"A contribution to the mathematical theory of epidemics\""},
      {"wildfire", "cells: state of each cell, with its shade or its age",
       "Alexandridis et al. 2008, \"A cellular automata model for forest fire spread prediction\""},
      {"fluid",
       "flow: x, y: velocity on the left and top side of each cell, cells/s; z: temperature; w: pressure|"
       "dye: red, green and blue of each cell|"
       "tracers: x, y: place of each tracer, cells; z: its age, s; w: times that it began again; only with "
       "\"tracers\"|"
       "trail: strength of the streaks in each cell; only with \"tracers\"",
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
       "cells: x: level, m; y, z: discharge along x and z, m^2/s; w: height of the bed, m|"
       "floats: place, rotation and motion of each float; only with \"floats\"|"
       "displaced: depth of water that floats displace in each cell, in whole units; only with \"floats\"",
       "Audusse, Bouchut, Bristeau, Klein and Perthame 2004 (well-balanced scheme)|"
       "Toro 2001, *Shock-Capturing Methods for Free-Surface Shallow Flows*|"
       "Kurganov and Petrova 2007 (thin water)|"
       "van Leer 1977 (slopes)|"
       "Manning 1891 (friction)"},
      {"cave",
       "cells: rock or floor|"
       "distances: steps from the entrance; -1 where no way leads|"
       "tallies: sums of points, flat squares and triangles of the solid before each 16 samples",
       "Johnson, Yannakakis and Togelius 2010, \"Cellular automata for real-time generation of infinite "
       "cave levels\"|"
       "Shiloach and Vishkin 1982 (regions)|"
       "Lorensen and Cline 1987 (marching squares, in the plane)"},
      {"contour", "tallies: sums of points, flat squares and triangles of the solid before each 16 samples",
       "Lorensen and Cline 1987, \"Marching cubes\", in the plane"},
      {"mesh",
       "positions: place of each vertex, m; only of a mesh with \"deform\", and not with the technique "
       "\"vertex-shader\"|"
       "trail: x: depth of the prints in each cell, m; y: height of the rim, m; only with \"footprints\"",
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
      {"streamlines", "",
       "Jobard and Lefer 1997, \"Creating evenly-spaced streamlines of arbitrary density\"|"
       "Bishop 1975, \"There is more than one way to frame a curve\" (tubes)"},
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
