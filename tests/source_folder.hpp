#pragma once
#include <string>

/// Returns the root of the source tree, with the shipped assets.
std::string sourceFolder();
