#pragma once
#include <string>
#include <string_view>

namespace simreel::scene {

/// Returns what a message says it expects in place of the group `key`: "an object", with an example for the
/// groups that users often give as a word or a list.
std::string expectedGroup(std::string_view key);

}  // namespace simreel::scene
