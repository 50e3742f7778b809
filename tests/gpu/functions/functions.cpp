#include "gpu/functions/ask.hpp"
#include "reference/disc_points.hpp"
#include "sim/cloth/plan.hpp"
#include "sim/collide/colliders.hpp"
#include "sim/collide/mesh_colliders.hpp"
#include "sim/contact/plan.hpp"
#include "sim/contour/wall_plan.hpp"
#include "sim/core/shader_code.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/mesh/deform_plan.hpp"
#include "sim/mesh/height_plan.hpp"
#include "sim/particles/parameters.hpp"
#include "sim/spread/wildfire_plan.hpp"
#include "sim/water/float_plan.hpp"
#include "sim/water/plan.hpp"

#include <doctest/doctest.h>

using namespace simreel;

namespace {

using namespace simreel::shader;
#include "glsl/cloth/segment_links.glsl"
#include "glsl/cloth/thin_rounds.glsl"

#define SEA 1
#define FUNCTION
#define precise
#include "gpu/functions/inputs.glsl"

struct Nearest {
#include "gpu/functions/closest.glsl"
};
struct Fires {
#include "gpu/functions/wildfire.glsl"
};
struct Grounds {
#include "gpu/functions/heights.glsl"
};
struct Solids {
#include "gpu/functions/colliders.glsl"
};
struct Lakes {
#include "gpu/functions/water.glsl"
};
struct Bodies {
#include "gpu/functions/floats.glsl"
};
struct Numbers {
#include "gpu/functions/exact.glsl"
};
struct Walls {
#include "gpu/functions/walls.glsl"
};
struct Shapes {
#include "gpu/functions/deform.glsl"
};
struct Sheets {
#include "gpu/functions/cloth.glsl"
};
struct Crowds {
#include "gpu/functions/particles.glsl"
};
#define discPoints discPoints()
struct Penumbras {
#include "gpu/functions/sun_disc.glsl"
};
#undef discPoints
#define EXACT_PICTURE
struct Overlays {
#include "glsl/draw/surface/overlay.glsl"
#include "gpu/functions/overlay.glsl"
};
#undef EXACT_PICTURE
struct Pairs {
#include "gpu/functions/contact.glsl"
};
#undef precise
#undef FUNCTION

}  // namespace

TEST_CASE("functions: closest points of triangles and segments on the GPU equal C++") {
  checkAll<Nearest>("closest.glsl");
}

TEST_CASE("functions: fire spread on slopes and in wind, and ember flights, on the GPU equal C++") {
  checkAll<Fires>("wildfire.glsl", "#include \"spread/cells.glsl\"\n");
}

TEST_CASE("functions: heights of a deformed grid, also on sides and corners, on the GPU equal C++") {
  checkAll<Grounds>("heights.glsl");
}

TEST_CASE("functions: collisions with shapes and distance fields on the GPU equal C++") {
  checkAll<Solids>("colliders.glsl");
}

TEST_CASE("functions: shallow water steps, look and drops on the GPU equal C++") {
  checkAll<Lakes>("water.glsl",
                  "#define SEA 1\n#include \"water/types.glsl\"\n#include "
                  "\"water/look_types.glsl\"\n#include \"water/model.glsl\"\n");
}

TEST_CASE("functions: floats on water and in contact on the GPU equal C++") {
  checkAll<Bodies>("floats.glsl",
                   "#include \"water/types.glsl\"\n#include \"water/float_types.glsl\"\n#include "
                   "\"water/model.glsl\"\n");
}

TEST_CASE("functions: exact arithmetic on the GPU equals C++") {
  checkAll<Numbers>("exact.glsl");
}

TEST_CASE("functions: collisions with contour walls on the GPU equal C++") {
  checkAll<Walls>("walls.glsl");
}

TEST_CASE("functions: deformations on the GPU equal C++") {
  checkAll<Shapes>("deform.glsl", "#include \"mesh/types.glsl\"\n");
}

TEST_CASE("functions: contact of faces and edges on the GPU equals C++") {
  checkAll<Pairs>("contact.glsl", "#include \"contact/types.glsl\"\n");
}

TEST_CASE("functions: cloth steps, constraint lines and thin colliders on the GPU equal C++") {
  checkAll<Sheets>("cloth.glsl", "#include \"cloth/segment_links.glsl\"\n");
}

TEST_CASE("functions: particle births and force fields on the GPU equal C++") {
  checkAll<Crowds>("particles.glsl");
}

TEST_CASE("functions: the colours of overlays on the GPU equal C++") {
  checkAll<Overlays>("overlay.glsl", "#define EXACT_PICTURE\n#include \"draw/surface/overlay.glsl\"\n");
}

TEST_CASE("functions: the penumbra of the sun's disc on the GPU equals C++") {
  checkAll<Penumbras>("sun_disc.glsl", "#include \"draw/exact/shadows/disc_points.glsl\"\n");
}
