#pragma once
#include "scene/value/fields.hpp"

#include <filesystem>

#include <fmt/format.h>

namespace simreel::scene {

/// What a file is for: where `key` gives one, `file`, and "shape" is left out, `shape` is `ofFile`, which
/// scenes call `name`; a mistake beside another shape, which would not read it. `usual`: what "shape" is
/// without both. After both have been described.
template <class Shape>
void implyShape(Fields& f, Shape& shape, Shape ofFile, const char* key, const std::filesystem::path& file,
                const char* name, const char* usual) {
  f.leftOut("shape", fmt::format("\"{}\", or \"{}\" where \"{}\" is given", usual, name, key).c_str());
  if (file.empty()) return;
  if (!f.given("shape"))
    shape = ofFile;
  else if (shape != ofFile)
    f.error(key, fmt::format("\"{}\" is read only with \"shape\": \"{}\", or none", key, name));
}

}  // namespace simreel::scene
