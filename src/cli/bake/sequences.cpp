#include "cli/bake/sequences.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "cli/bake/files.hpp"
#include "frame/mesh/mesh_sequence.hpp"
#include "frame/mesh/named_vertices.hpp"
#include "frame/mesh/obj.hpp"
#include "sim/world/shown_mesh.hpp"

#include <memory>
#include <optional>

namespace simreel::cli {

namespace {

namespace fs = std::filesystem;

/// Writes the mesh sequence of one object. Formats without triangles (pc2, mdd) also get an OBJ file of the
/// first frame in the same folder.
class ObjectSequence {
 public:
  ObjectSequence(const sim::World& world, std::size_t object, const SequencesOptions& o)
      : world_(world), object_(object), options_(o) {}

  [[nodiscard]] std::vector<fs::path> files() const {
    std::vector<fs::path> all = {place(options_.format)};
    if (options_.format != "glb") all.push_back(place("obj"));
    return all;
  }
  /// Appends the object's current mesh. Must be called once per baked frame, in order.
  void add() {
    const sim::MeshTable mesh = world_.object(object_).mesh().value();
    if (!sequence_) {
      comments_ = options_.comments(object_);
      sequence_ = frame::openSequence(options_.format, place(options_.format),
                                      {world_.objectName(object_), options_.frames, options_.fps, comments_,
                                       sim::looksOfMesh(world_, object_, mesh), options_.skins});
      if (options_.format != "glb") first_ = frame::NamedVertices(mesh).of(mesh);
    }
    sequence_->add(mesh);
  }
  void finish() {
    sequence_->finish();
    if (first_) writeFileAtomically(place("obj"), frame::encodeObj(*first_, comments_));
  }

 private:
  [[nodiscard]] fs::path place(const std::string& suffix) const {
    return options_.output / (world_.objectName(object_) + "." + suffix);
  }

  const sim::World& world_;
  std::size_t object_;
  const SequencesOptions& options_;
  std::unique_ptr<frame::MeshSequence> sequence_;
  std::vector<std::string> comments_;
  std::optional<sim::MeshTable> first_;
};

}  // namespace

void bakeSequences(sim::World& world, const SequencesOptions& o) {
  std::vector<ObjectSequence> all;
  std::vector<fs::path> files;
  for (const std::size_t object : o.objects) {
    all.emplace_back(world, object, o);
    for (const fs::path& file : all.back().files()) files.push_back(file);
  }
  for (const fs::path& file : files)
    if (!o.overwrite && pathExists(file))
      fail(ExitCode::inputOutput, "{} exists; use --overwrite to replace it", file.string());
  makeFolders(o.output);
  for (const int frame : o.frames) {
    if (!simulateTo(world, frame, 0)) return;
    for (ObjectSequence& one : all) one.add();
  }
  for (ObjectSequence& one : all) one.finish();
  info("{} frames in {} {} -> {}", o.frames.size(), files.size(), files.size() > 1 ? "files" : "file",
       files.front().string() + (files.size() > 1 ? " ..." : ""));
}

}  // namespace simreel::cli
