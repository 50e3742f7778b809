#pragma once
#include "frame/mesh/gltf_materials.hpp"
#include "sim/world/world.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace simreel::cli {

/// Formats of `simreel bake` that hold one object's state at one frame. ply: points or a mesh. obj: a mesh.
/// glb: a mesh, or copies of a mesh. svg, geojson: contours. npy, pfm: the values of a field. rle: the
/// cells of an automaton.
inline constexpr std::array<const char*, 8> stateFormats = {"ply", "obj", "glb",     "svg",
                                                            "npy", "pfm", "geojson", "rle"};

/// Returns the format in which an object is written. This is `wanted`, or, if `wanted` is empty, the first
/// of rle, ply and npy that suits the object. Returns an empty text if the object cannot be written in that
/// format.
[[nodiscard]] std::string formatFor(const sim::World& world, std::size_t object, const std::string& wanted);
/// Returns the kind of content that a format has, for messages: "points or a mesh", "cells", .... For an
/// empty format, returns "state".
[[nodiscard]] const char* contentsOf(const std::string& format);
/// Returns the names of an object's files. A format for fields gives one file per field ("NAME", "NAME.u");
/// other formats give one file. `format` must be a result of formatFor().
[[nodiscard]] std::vector<std::string> fileNames(const sim::World& world, std::size_t object,
                                                 const std::string& format);
/// Returns the contents of the file `name`. `comments` are written if the format supports comments. `skins`
/// returns the pictures of materials, which glb contains.
[[nodiscard]] std::vector<std::byte> stateFile(const sim::World& world, std::size_t object,
                                               const std::string& name, const std::string& format,
                                               std::span<const std::string> comments,
                                               const frame::SkinPicturesOf& skins = {});

/// Returns the contents of a glb file with all objects that have a mesh or copies of one, a node each.
[[nodiscard]] std::vector<std::byte> sceneGlb(const sim::World& world,
                                              std::span<const std::string> comments,
                                              const frame::SkinPicturesOf& skins);

/// Simulates up to `frame` without drawing the frames before it. Returns false after an interrupt, with a
/// message that the `files` files written so far are complete.
[[nodiscard]] bool simulateTo(sim::World& world, int frame, int files);

}  // namespace simreel::cli
