#include "sim/world/setup.hpp"

#include "base/file.hpp"
#include "sim/collide/mesh_colliders.hpp"
#include "sim/grid/picture_file.hpp"
#include "sim/light/surroundings.hpp"
#include "sim/shape/shape.hpp"
#include "sim/world/list.hpp"
#include "sim/world/object_links.hpp"
#include "sim/world/port_check.hpp"
#include "sim/world/world.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Maximum texture side that every OpenGL 4.5 device supports.
constexpr int maxTextureSide = 16384;

/// Returns true if an earlier problem ends with the text of the last one.
bool isReported(const std::vector<UserError>& problems) {
  return std::any_of(problems.begin(), problems.end() - 1, [&](const UserError& problem) {
    return std::string(problem.what()).ends_with(problems.back().what());
  });
}

/// Opens the images of a material in the same way as the renderer that will draw the material. Only the
/// exact rasterizer, for a material with a finish, handles transparency.
template <class Attempt>
void checkPictures(const scene::Material& material, bool exact, const Attempt& attempt) {
  const auto check = [&](const std::filesystem::path& file) {
    if (file.empty()) return;
    attempt([&] {
      static_cast<void>(decodePicture(readFile(file, "texture"), file.string(), "texture", maxTextureSide));
    });
  };
  const scene::Finish& finish = material.finish;
  if (exact && finish.used())
    check(material.texture);
  else if (!material.texture.empty())
    attempt([&] { static_cast<void>(loadPicture(material.texture, "texture", maxTextureSide)); });
  for (const scene::Map* map :
       {&finish.normals, &finish.metalRough, &finish.occlusion, &finish.emissionMap})
    check(map->file);
}

}  // namespace

std::vector<ColliderShape> collidersOf(const scene::Scene& scene, const Bones* bones) {
  std::vector<ColliderShape> shapes;
  for (const scene::Object& object : scene.objects)
    if (const auto* shape = dynamic_cast<const ShapeParameters*>(object.parameters.get()))
      if (shape->collides) shapes.push_back(shape->shape);
  if (scene.ground && scene.ground->solid) {
    ColliderShape ground;
    ground.kind = ColliderShape::Kind::plane;
    ground.position = glm::vec3(0, scene.ground->height, 0);
    ground.friction = scene.ground->friction;
    shapes.push_back(ground);
  }
  if (bones != nullptr) bones->addCapsules(shapes);
  return shapes;
}

int prerollOf(const scene::Scene& scene) {
  return static_cast<int>(std::lround(scene.time.start * scene.time.fps));
}

double startOf(const scene::Scene& scene) {
  return -prerollOf(scene) / scene.time.fps;
}

void namingObject(const scene::Object& object, const std::function<void()>& work) {
  try {
    work();
  } catch (const UserError& error) {
    const bool named =
        std::string(error.what()).find(fmt::format("\"{}\"", object.name)) != std::string::npos;
    if (named || error.code() != ExitCode::usage || error.form() == UserError::Form::report) throw;
    fail(error.code(), "objects.{}.{}: {}", object.name, object.kind, error.what());
  }
}

std::vector<UserError> findProblems(const scene::Scene& scene) {
  Bones bones(scene);
  std::vector<ColliderShape> colliders;
  Setting setting{scene.numerics == scene::Numerics::fast, scene.seed, 1.0 / scene.time.fps, &colliders};
  setting.aspect = static_cast<float>(scene.render.size.x) / static_cast<float>(scene.render.size.y);
  setting.startTime = startOf(scene);
  ObjectLinks links(scene.objects, [&] { return setting.startTime; });
  links.provide(&bones);
  setting.links = &links;
  try {
    colliders = collidersOf(scene, &bones);
  } catch (const UserError&) {  // The check of the body itself reports this error.
    colliders = collidersOf(scene, nullptr);
  }
  std::vector<UserError> problems;
  const auto attempt = [&](const auto& work) {
    try {
      work();
    } catch (const UserError& error) {
      problems.push_back(error);
    }
  };
  for (const std::string& mistake : portMistakes(scene)) problems.emplace_back(ExitCode::usage, mistake);
  for (const scene::Object& object : scene.objects) {
    if (const auto& check = simulationNamed(object.kind).check)
      attempt([&] { namingObject(object, [&] { check(object, setting); }); });
    checkPictures(object.material, scene.render.rasterizer == scene::Rasterizer::exact, attempt);
  }
  if (const auto& sky = scene.sky.picture; !sky.empty())
    attempt([&] { checkSurroundings(readSurroundings(sky), surroundingsLabel(sky)); });
  const std::size_t others = problems.size();
  attempt([&] { static_cast<void>(MeshColliderPlan(scene, meshReach(scene))); });
  // An unreadable file is already reported for its object.
  if (others > 0 && problems.size() > others && isReported(problems)) problems.pop_back();
  return problems;
}

std::vector<std::string> tooLargeForMany(const scene::Scene& scene) {
  std::vector<std::string> sentences;
  for (const scene::Object& object : scene.objects) {
    const auto bytes = parametersOf<ObjectParameters>(object).minLargestBufferBytes();
    if (bytes > ObjectParameters::commonBlockBytes)
      sentences.push_back(
          fmt::format("{} \"{}\" needs {} bytes in one buffer, and software drivers allow {} "
                      "(GL_MAX_SHADER_STORAGE_BLOCK_SIZE); --device shows what yours allows",
                      object.kind, object.name, bytes, ObjectParameters::commonBlockBytes));
  }
  return sentences;
}

}  // namespace simreel::sim
