#pragma once
#include <filesystem>
#include <string>

namespace simreel::sim {

/// The text of a scene around a pattern file, whose object is called "cells": the pattern in the middle,
/// room around it, ten seconds. Empty for names that are no pattern's. Throws UserError as readPattern
/// does.
[[nodiscard]] std::string sceneAroundPattern(const std::filesystem::path& file);

}  // namespace simreel::sim
