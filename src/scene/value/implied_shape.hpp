#pragma once
#include "scene/value/fields.hpp"

#include <filesystem>

#include <fmt/format.h>

namespace simreel::scene {

/// Handles a file that only one shape uses. If the field `key` gives `file` and the scene leaves "shape"
/// out, sets `shape` to `ofFile` (`name` in scenes). Reports an error if "shape" has another value, because
/// other shapes do not read the file. `usual`: default of "shape" without a file, for the help. Must be
/// called after both fields have been declared.
template <class Shape>
void implyShape(Fields& f, Shape& shape, Shape ofFile, const char* key, const std::filesystem::path& file,
                const char* name, const char* usual) {
  f.leftOut("shape", fmt::format("\"{}\", or \"{}\" where \"{}\" is given", usual, name, key).c_str());
  if (file.empty()) return;
  if (!f.given("shape"))
    shape = ofFile;
  else if (shape != ofFile)
    f.error(key,
            fmt::format("\"{}\" needs \"shape\": \"{}\"; correct \"shape\" or leave it out", key, name));
}

}  // namespace simreel::scene
