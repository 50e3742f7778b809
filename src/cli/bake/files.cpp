#include "cli/bake/files.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "cli/commands.hpp"
#include "frame/file/contour_file.hpp"
#include "frame/file/field_file.hpp"
#include "frame/interrupt.hpp"
#include "frame/mesh/glb.hpp"
#include "frame/mesh/obj.hpp"
#include "frame/mesh/ply.hpp"
#include "frame/summaries.hpp"
#include "sim/grid/field_values.hpp"
#include "sim/world/shown_mesh.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace simreel::cli {

namespace {

/// Returns the field with this name among the objects' drawables, or null.
const sim::Field* fieldOf(const sim::Drawables& drawables, const std::string& name) {
  for (const sim::Field& field : drawables.fields)
    if (*field.name == name && !field.decoration) return &field;
  return nullptr;
}

bool isContourFormat(const std::string& format) {
  return format == "svg" || format == "geojson";
}

/// True for formats that can contain only meshes. PLY is not one of them, because it can also contain
/// points.
bool isMeshFormat(const std::string& format) {
  return format == "obj" || format == "glb" || format == "pc2" || format == "mdd";
}

bool isFieldFormat(const std::string& format) {
  return format == "npy" || format == "pfm";
}

/// Returns the numbers of columns and rows.
glm::ivec2 shapeOf(const sim::PointTable& table) {
  const std::size_t columns = std::max<std::size_t>(1, table.columns.size());
  return {static_cast<int>(columns), static_cast<int>(table.values.size() / columns)};
}

std::vector<std::byte> bytesOf(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

/// Encodes a mesh as PLY. Each vertex has its position, its normal, its uv if the mesh has uvs, and the
/// other columns of `points`, whose rows are the vertices. The triangles follow.
std::vector<std::byte> meshPly(const sim::MeshTable& mesh, const sim::PointTable& points,
                               std::span<const std::string> comments) {
  constexpr std::size_t own = 3;  // The first three columns of `points` are x, y and z. They have already
                                  // been written.
  std::vector<const char*> columns = {"x", "y", "z", "nx", "ny", "nz"};
  if (!mesh.uvs.empty()) columns.insert(columns.end(), {"s", "t"});
  const std::size_t width = points.columns.size();
  if (width > own) {
    columns.insert(columns.end(), points.columns.begin() + own, points.columns.end());
  }
  std::vector<float> values;
  values.reserve(mesh.positions.size() * columns.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3& p = mesh.positions[i];
    const glm::vec3& n = mesh.normals[i];
    values.insert(values.end(), {p.x, p.y, p.z, n.x, n.y, n.z});
    // v is flipped, because in PLY, as in OBJ, v points up.
    if (!mesh.uvs.empty()) values.insert(values.end(), {mesh.uvs[i].x, 1 - mesh.uvs[i].y});
    for (std::size_t k = own; k < width; ++k) values.push_back(points.values[i * width + k]);
  }
  return frame::encodePly(columns, values, mesh.indices, comments);
}

bool has(const sim::World& world, std::size_t object, const std::string& format) {
  const sim::Simulation& simulation = world.object(object);
  if (isFieldFormat(format) && fieldOf(world.drawables(), world.objectName(object)) != nullptr) return true;
  if (format == "npy") return !simulation.points().columns.empty();
  if (format == "pfm") return false;
  if (isContourFormat(format)) return simulation.lines().has_value();
  if (isMeshFormat(format))
    return sim::showsMesh(world, object) || (format == "glb" && sim::showsCopies(world, object));
  if (format == "ply") return !simulation.points().columns.empty() || simulation.mesh();
  const char* own = simulation.stateFile().suffix;
  return own != nullptr && format == own;
}

frame::GlbObject glbObject(const sim::World& world, std::size_t object) {
  frame::GlbObject made{world.objectName(object), {}, {}, sim::shownCopies(world, object)};
  if (auto mesh = sim::shownMesh(world, object)) {
    made.looks = sim::looksOfMesh(world, object, *mesh);
    made.mesh = std::move(*mesh);
  }
  return made;
}

}  // namespace

std::vector<std::byte> sceneGlb(const sim::World& world, std::span<const std::string> comments,
                                const frame::SkinPicturesOf& skins) {
  std::vector<frame::GlbObject> objects;
  for (std::size_t i = 0; i < world.objectCount(); ++i)
    if (has(world, i, "glb")) objects.push_back(glbObject(world, i));
  return frame::encodeGlb(objects, comments, skins);
}

std::string formatFor(const sim::World& world, std::size_t object, const std::string& wanted) {
  if (wanted == "ply" && sim::showsMesh(world, object)) return wanted;
  if (!wanted.empty()) return has(world, object, wanted) ? wanted : "";
  for (const char* format : {"rle", "ply", "npy"})
    if (has(world, object, format)) return format;
  return "";
}

const char* contentsOf(const std::string& format) {
  if (format == "ply") return "points or a mesh";
  if (isMeshFormat(format)) return "a mesh";
  if (isContourFormat(format)) return "contours";
  if (format == "rle") return "cells";
  if (format == "npy") return "a field or points";
  return format.empty() ? "state" : "a field";
}

std::vector<std::string> fileNames(const sim::World& world, std::size_t object, const std::string& format) {
  const std::string& name = world.objectName(object);
  if (!isFieldFormat(format)) return {name};
  std::vector<std::string> names;
  const sim::Drawables drawables = world.drawables();
  for (const sim::Field& field : drawables.fields)
    if (*field.name == name || field.name->starts_with(name + ".")) names.push_back(*field.name);
  if (fieldOf(drawables, name) == nullptr)
    return {name};  // The file has the object's name, because the object's points are written.
  return names;
}

std::vector<std::byte> stateFile(const sim::World& world, std::size_t object, const std::string& name,
                                 const std::string& format, std::span<const std::string> comments,
                                 const frame::SkinPicturesOf& skins) {
  const sim::Simulation& simulation = world.object(object);
  const sim::Drawables drawables = world.drawables();
  if (const sim::Field* field = fieldOf(drawables, name); field != nullptr && isFieldFormat(format))
    return frame::encodeField(frame::parseFieldFormat(format), field->size, sim::fieldValues(*field));
  if (const sim::StateFile own = simulation.stateFile(); own.suffix != nullptr && format == own.suffix) {
    std::string lines;
    for (const std::string& line : comments) lines += line + "\n";
    return bytesOf(own.text(lines));
  }
  if (isContourFormat(format)) {
    const sim::ContourLines lines = simulation.lines().value();
    return bytesOf(format == "svg" ? frame::encodeSvg(lines, lines.size, comments)
                                   : frame::encodeGeoJson(lines, lines.path, comments));
  }
  if (format == "npy") {
    const sim::PointTable table = simulation.points();
    return frame::encodeField(frame::FieldFormat::npy, shapeOf(table), table.values);
  }
  if (format == "glb") return frame::encodeGlb(std::array{glbObject(world, object)}, comments, skins);
  const std::optional<sim::MeshTable> mesh = sim::shownMesh(world, object);
  if (format == "obj") return bytesOf(frame::encodeObj(*mesh, comments));
  const sim::PointTable table = simulation.points();
  const bool vertices =
      table.columns.size() <= 3 || (mesh && shapeOf(table).y == static_cast<int>(mesh->positions.size()));
  if (mesh && vertices) return meshPly(*mesh, table, comments);
  return frame::encodePly(table.columns, table.values, comments);
}

bool simulateTo(sim::World& world, int frame, int files) {
  try {
    for (int next = std::min(world.frame() + 1, frame); next <= frame; ++next) {
      frame::throwIfInterrupted();
      if (next < frame)
        world.advanceUndrawn(next);
      else
        world.advanceTo(next);
      frame::checkState(world);
    }
  } catch (const frame::Interrupted& interrupted) {
    if (files > 0)
      info("simreel: interrupted; the {} files written so far are whole", files);
    else
      info("simreel: interrupted; no file was written");
    setExitCode(128 + interrupted.signal);
    return false;
  }
  static_cast<void>(world.grow());
  return true;
}

}  // namespace simreel::cli
