// Tests fluid functions. This is a separate source file because the water and fluid headers define border
// constants of the same names.
#include "gpu/functions/ask.hpp"
#include "sim/core/shader_code.hpp"
#include "sim/fluid/plan.hpp"

#include <doctest/doctest.h>

namespace {

using namespace simreel::shader;

#define FUNCTION
#define precise
#include "gpu/functions/inputs.glsl"

struct Tanks {
#include "gpu/functions/fluid.glsl"
};
#undef precise
#undef FUNCTION

}  // namespace

TEST_CASE("functions: updates of a fluid cell on the GPU equal C++") {
  checkAll<Tanks>("fluid.glsl", "#include \"fluid/model.glsl\"\n");
}
