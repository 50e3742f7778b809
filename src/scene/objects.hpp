#pragma once
#include "scene/scene.hpp"
#include "scene/value/reader.hpp"

#include <vector>

namespace simreel::scene {

/// Reads the section "objects" of a scene: appends an object for each member, also for those with errors.
/// Reports all errors to the context's diagnostics. kinds.check then checks the objects together.
/// `hasGround`: true if the scene has a ground that collides.
void readObjects(const Node& node, ReadContext context, const Kinds& kinds, bool hasGround,
                 std::vector<Object>& objects);

}  // namespace simreel::scene
