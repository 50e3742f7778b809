#pragma once
#include "kernels/spirv/module.hpp"

#include <set>

namespace simreel::kernels {

/// Converts the cube maps of a module to array textures of six layers in the order +x, -x, +y, -y, +z, -z.
/// Returns their variables, whose reads filterExactly() replaces. Does not change cube maps if a read uses
/// something other than a direction and a mip level.
std::set<Id> flattenCubes(Module& module);

}  // namespace simreel::kernels
