#include "sim/mesh/file/mesh_file.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/isolated.hpp"
#include "base/packed.hpp"
#include "sim/mesh/file/builder.hpp"
#include "sim/mesh/file/gltf_file.hpp"
#include "sim/mesh/file/polygon_meshes.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace simreel::sim {

bool isGltf(const std::filesystem::path& file) {
  const std::string extension = lowerExtension(file);
  return extension == ".gltf" || extension == ".glb";
}

bool isMeshFile(const std::filesystem::path& file) {
  const std::string extension = lowerExtension(file);
  return extension == ".obj" || extension == ".ply" || extension == ".stl" || isGltf(file);
}

Mesh importMesh(const std::filesystem::path& file, MeshNormals normals) {
  if (!isMeshFile(file))
    fail(ExitCode::usage, "the mesh {} is in none of the formats {}", file.string(), meshEndings);
  const std::string extension = lowerExtension(file);
  const std::string text = readFile(file, "mesh");  // throws if the file is unreadable or too large
  if (isGltf(file)) return readGltf(file, text, normals);
  if (extension == ".stl") return readStl(file, text, normals);
  return extension == ".obj" ? readObj(file, text, normals) : readPly(file, text);
}

std::string readInSeparateProcess(const std::filesystem::path& file,
                                  const std::function<std::string()>& read) {
  std::error_code unknown;
  const auto size = std::filesystem::file_size(file, unknown);
  const std::size_t bytes = unknown ? 0 : size;
  // Parsing text takes some 30 bytes of memory per byte; glTF validates its sizes before it allocates
  // memory.
  const ProcessLimits allotment{isGltf(file) ? std::size_t{4} << 30 : (std::size_t{256} << 20) + 64 * bytes,
                                10 + static_cast<int>(std::min<std::size_t>(bytes >> 20U, 3600))};
  // The folders are looked up before the fork, because the child of a multithreaded process must not wait
  // for a lock that another thread holds.
  const ReadableFolders readable(file);
  try {
    return runIsolated(allotment, read);
  } catch (const UserError&) {
    throw;
  } catch (const std::runtime_error& end) {
    refuseMesh(file, fmt::format("cannot be read: the reader {}", end.what()));
  }
}

Mesh loadMesh(const std::filesystem::path& file, MeshNormals normals) {
  return unpacked<Mesh>(readInSeparateProcess(file, [&] { return packed(importMesh(file, normals)); }));
}

}  // namespace simreel::sim
