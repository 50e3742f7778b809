#include "cli/bake/maps.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/version.hpp"
#include "batch/render/chosen_frames.hpp"
#include "cli/bake/files.hpp"
#include "cli/bake/skins.hpp"
#include "cli/commands.hpp"
#include "draw/overlay/field_textures.hpp"
#include "draw/surface/skin_maps.hpp"
#include "draw/surface/skin_textures.hpp"
#include "frame/file/map_pictures.hpp"
#include "frame/interrupt.hpp"
#include "gl/context.hpp"
#include "scene/json/words.hpp"
#include "sim/core/kind.hpp"
#include "sim/ports/field_source.hpp"
#include "sim/world/survey.hpp"
#include "sim/world/world.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include <fmt/ranges.h>

namespace simreel::cli {

namespace {

namespace fs = std::filesystem;

constexpr int largestSide =
    8192;  // max number of texels per side; larger maps would take gigabytes of memory during encoding

/// Returns the size of the maps, or nullopt without --size. Since --size overrides render.size, the size is
/// read from the scene.
std::optional<glm::ivec2> mapSize(const MapsOptions& o, const scene::Scene& scene) {
  if (!o.scene.size) return std::nullopt;
  const glm::ivec2 size = scene.render.size;
  if (size.x > largestSide || size.y > largestSide)
    fail(ExitCode::usage, "--size: maps are at most {}x{}, not {}x{}", largestSide, largestSide, size.x,
         size.y);
  return size;
}

/// Applies --look. If no object has the field as its skin, gives the object with the field a skin with that
/// look.
void wearOwnField(const MapsOptions& o, scene::Scene& scene) {
  static const std::array<std::string, 4> looks = {"leather", "spots", "cracks", "map"};
  const auto* const look = std::find(looks.begin(), looks.end(), o.look);
  if (look == looks.end())
    fail(ExitCode::usage, "--look: there is no \"{}\"; {}", o.look, scene::suggestion(o.look, looks));
  std::vector<std::string> fields;
  for (scene::Object& object : scene.objects) {
    if (!sim::provides(object, sim::FieldSource::port)) continue;
    fields.push_back(object.name);
    if (!o.object.empty() && o.object != object.name) continue;
    object.material.skin.emplace();
    object.material.skin->field = object.name;
    object.material.skin->look = static_cast<scene::Skin::Look>(look - looks.begin());
  }
  if (fields.empty()) fail(ExitCode::usage, "--look: the scene has no field");
  if (!o.object.empty() && std::find(fields.begin(), fields.end(), o.object) == fields.end())
    fail(ExitCode::usage, "--look: \"{}\" is no field of the scene; {}", o.object,
         scene::suggestion(o.object, fields));
}

/// Returns the objects whose skins are baked: the object given by --object, or all objects with a skin.
std::vector<const scene::Object*> bakedSkins(const MapsOptions& o, const scene::Scene& scene) {
  std::vector<const scene::Object*> found;
  std::vector<std::string> names;
  for (const scene::Object& object : scene.objects) {
    if (!object.material.skin) continue;
    if (!o.look.empty() && object.material.skin->field != object.name) continue;
    names.push_back(object.name);
    if (o.object.empty() || o.object == object.name) found.push_back(&object);
  }
  if (names.empty())
    fail(ExitCode::usage, "no material of the scene has a skin to bake; --look takes a field as it is");
  if (found.empty())
    fail(ExitCode::usage, "--object: there is no \"{}\" with a skin; {}", o.object,
         scene::suggestion(o.object, names));
  return found;
}

fs::path fileOf(const MapsOptions& o, const scene::Object& object, int frame, const std::string& map) {
  return fs::path(o.output) / fmt::format("{}_{:06}_{}.png", object.name, frame, map);
}

void refuseExisting(const MapsOptions& o, const std::vector<const scene::Object*>& objects,
                    const std::vector<int>& frames) {
  if (o.overwrite) return;
  for (const int frame : frames)
    for (const scene::Object* object : objects)
      for (const std::string& map : frame::mapNames(glowOf(*object->material.skin)))
        if (const fs::path file = fileOf(o, *object, frame, map); pathExists(file))
          fail(ExitCode::inputOutput, "{} exists; use --overwrite to replace it", file.string());
}

/// Draws and writes the maps of one frame.
class MapWriter {
 public:
  MapWriter(const MapsOptions& o, const scene::Scene& scene, std::optional<glm::ivec2> size)
      : options_(o), scene_(scene), size_(size), fields_(scene), skins_(scene) {}

  void write(const sim::World& world, const std::vector<const scene::Object*>& objects) {
    const sim::Drawables drawables = world.drawables();
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    fields_.update(drawables);
    skins_.update(fields_);
    for (const scene::Object* object : objects) write(world, *object);
  }
  [[nodiscard]] int files() const { return files_; }

 private:
  void write(const sim::World& world, const scene::Object& object) {
    const scene::Skin& skin = *object.material.skin;
    const draw::SkinTextures::Entry* entry = skins_.find(skin);
    if (entry == nullptr)
      fail(ExitCode::usage, "frame {}: \"{}\" shows no field to grow the skin of \"{}\" from",
           world.frame(), skin.field, object.name);
    const glm::ivec2 size = size_.value_or(glm::min(entry->cells, glm::ivec2(largestSide)));
    frame::ImageText text = {{"Software", fmt::format("simreel {}", version())},
                             {"simreel:scene", scene_.hash},
                             {"simreel:object", object.name},
                             {"simreel:frame", std::to_string(world.frame())},
                             {"simreel:seed", std::to_string(scene_.seed)}};
    if (!scene_.overrides.empty())
      text.emplace_back("simreel:overrides", scene::asArguments(scene_.overrides));
    for (const frame::MapPicture& map :
         frame::encodeMaps(mapper_.draw(*entry, skin, size), glowOf(skin), text)) {
      writeFileAtomically(fileOf(options_, object, world.frame(), map.name), map.png);
      ++files_;
    }
  }

  const MapsOptions& options_;
  const scene::Scene& scene_;
  std::optional<glm::ivec2> size_;
  draw::FieldTextures fields_;
  draw::SkinTextures skins_;
  draw::SkinMapper mapper_;
  int files_ = 0;
};

}  // namespace

void bakeMaps(const MapsOptions& o) {
  scene::Scene scene = o.scene.load();
  const std::optional<glm::ivec2> size = mapSize(o, scene);
  if (!o.look.empty()) wearOwnField(o, scene);
  const auto objects = bakedSkins(o, scene);
  const std::vector<int> frames =
      o.frames ? batch::chosenFrames(o.frames, scene) : std::vector<int>{scene.frameCount() - 1};
  refuseExisting(o, objects, frames);
  frame::catchInterrupts();
  const gl::Context context(o.on);
  if (sim::needsRanges(scene))
    static_cast<void>(sim::frameMotion(scene));  // The appearance depends on the ranges of colours, which
                                                 // are measured first.
  sim::World world(scene);
  MapWriter writer(o, scene, size);
  makeFolders(o.output);
  for (const int frame : frames) {
    if (!simulateTo(world, frame, writer.files())) return;
    writer.write(world, objects);
  }
  info("{} files -> {}", writer.files(),
       fileOf(o, *objects.front(), frames.front(), "albedo").string() + " ...");
}

}  // namespace simreel::cli
