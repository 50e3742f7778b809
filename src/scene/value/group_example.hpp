#pragma once
#include <string>
#include <string_view>

namespace simreel::scene {

/// Returns the part of a message that states what was expected instead of the group `key`. This is "an
/// object", followed by an example for groups that users often give as a word or a list.
std::string expectedGroup(std::string_view key);

}  // namespace simreel::scene
