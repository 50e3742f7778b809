#pragma once
#include <string>

/// The root of the source tree, where tests find the shipped assets.
std::string sourceFolder();
