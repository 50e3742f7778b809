#pragma once
#include "sim/world/world.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace simreel::cli {

/// Formats of `simreel bake` that hold one object's state at one frame. ply: points, or a mesh; obj, glb: a
/// mesh; svg, geojson: contours; npy, pfm: the values of a field; rle: cells of automata.
inline constexpr std::array<const char*, 8> stateFormats = {"ply", "obj", "glb",     "svg",
                                                            "npy", "pfm", "geojson", "rle"};

/// The format in which an object is written: the one asked for, or with "" what suits it best; "" when it
/// has nothing for that.
[[nodiscard]] std::string formatFor(const sim::World& world, std::size_t object, const std::string& wanted);
/// What a format holds, for messages: "points or a mesh", "cells", ...; of "": "state".
[[nodiscard]] const char* contentsOf(const std::string& format);
/// What its files are called, one each: the object, and of fields NAME.u as well. `format` is one that
/// formatFor gave.
[[nodiscard]] std::vector<std::string> fileNames(const sim::World& world, std::size_t object,
                                                 const std::string& format);
/// The file of that name. `comments` are written where the format has room for them.
[[nodiscard]] std::vector<std::byte> stateFile(const sim::World& world, std::size_t object,
                                               const std::string& name, const std::string& format,
                                               std::span<const std::string> comments);

/// Simulates up to a frame, the only one that is looked at. After an interrupt false, having said that so
/// many files are whole, or none was written.
[[nodiscard]] bool simulateTo(sim::World& world, int frame, int files);

}  // namespace simreel::cli
