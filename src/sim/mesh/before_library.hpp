#pragma once
#include <filesystem>
#include <string_view>

namespace simreel::sim {

/// Most corners of a face: the mesh library reads faces (since assimp 5.3) and cuts them into triangles in
/// a time that grows with their square.
inline constexpr unsigned maxCorners = 10'000;

/// Refuses faces, lines and points of OBJ with more than maxCorners corners; a UserError names the line.
void checkObj(const std::filesystem::path& file, std::string_view text);

/// Refuses a PLY whose header has a line that the format does not know, for which the library looks for
/// ever, or counts more elements than the file has bytes, for which it takes memory first. A UserError
/// names the line. (Greg Turk, The PLY Polygon File Format, 1994.)
void checkPly(const std::filesystem::path& file, std::string_view text);

}  // namespace simreel::sim
