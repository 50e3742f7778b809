#pragma once
#include "kernels/spirv/module.hpp"

#include <set>

namespace simreel::kernels {

/// Makes array textures of six layers of the cube maps of a module, in the order +x, -x, +y, -y, +z, -z.
/// Returns their variables, whose reads filterExactly() replaces. Cube maps that are read in another way
/// than by a direction and a level stay as they are.
std::set<Id> flattenCubes(Module& module);

}  // namespace simreel::kernels
