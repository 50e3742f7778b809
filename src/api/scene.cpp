#include "api/simreel/scene.hpp"

#include "api/arrays.hpp"
#include "api/failure.hpp"
#include "api/rendering_state.hpp"
#include "api/scene_state.hpp"
#include "base/hash.hpp"
#include "frame/file/checkpoint.hpp"
#include "frame/image.hpp"
#include "golden/suite/scene_run.hpp"
#include "scene/shipped_scene.hpp"
#include "sim/grid/field_values.hpp"
#include "sim/world/list.hpp"
#include "sim/world/survey.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace simreel {

Snapshot::Snapshot(std::shared_ptr<const State> state) : state_(std::move(state)) {}
Snapshot::~Snapshot() = default;
Snapshot::Snapshot(const Snapshot&) = default;
Snapshot::Snapshot(Snapshot&&) noexcept = default;
Snapshot& Snapshot::operator=(const Snapshot&) = default;
Snapshot& Snapshot::operator=(Snapshot&&) noexcept = default;
int Snapshot::frame() const {
  return state_->world.frame;
}
std::size_t Snapshot::bytes() const {
  return state_->world.bytes.size();
}

Scene::Scene(std::unique_ptr<State> state) : state_(std::move(state)) {}
Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

Scene Scene::load(const Device& device, const std::string& file, const LoadOptions& options) {
  auto state = std::make_unique<State>(device.state(), api::inputOf(file, {}, options), options.motion);
  state->begin();
  return Scene(std::move(state));
}
Scene Scene::parse(const Device& device, const std::string& text, const std::string& name,
                   const LoadOptions& options) {
  auto state = std::make_unique<State>(device.state(), api::inputOf(name, text, options), options.motion);
  state->begin();
  return Scene(std::move(state));
}

std::string Scene::title() const {
  return state_->scene->title;
}
double Scene::fps() const {
  return state_->scene->time.fps;
}
int Scene::frameCount() const {
  return state_->scene->frameCount();
}
int Scene::width() const {
  return state_->scene->render.size.x;
}
int Scene::height() const {
  return state_->scene->render.size.y;
}
std::vector<std::string> Scene::remarks() const {
  return state_->scene->remarks;
}
std::vector<ObjectInfo> Scene::objects() const {
  std::vector<ObjectInfo> objects;
  for (const scene::Object& object : state_->scene->objects) objects.push_back({object.name, object.kind});
  return objects;
}
bool Scene::isChanged() const {
  return state_->changed;
}

Frame Scene::frame() const {
  return state_->device->run([this] {
    if (!state_->world) state_->requireState();
    return Frame{state_->world->frame(), state_->world->time()};
  });
}
Frame Scene::advanceTo(int frame) {
  return state_->device->run([&] {
    state_->advanceTo(frame);
    return Frame{state_->world->frame(), state_->world->time()};
  });
}
Frame Scene::advanceBy(int frames) {
  return state_->device->run([&] {
    state_->requireState();
    const int present = state_->world->frame();
    if (frames < 0)
      api::fail(ErrorKind::usage,
                fmt::format("a scene cannot go {} frames back; restart() it, or restore() a snapshot",
                            -static_cast<long>(frames)));
    if (frames > std::numeric_limits<int>::max() - present)
      api::fail(ErrorKind::usage, fmt::format("frame {} + {} is beyond the last frame, {}", present, frames,
                                              std::numeric_limits<int>::max()));
    state_->advanceTo(present + frames);
    return Frame{state_->world->frame(), state_->world->time()};
  });
}
void Scene::restart() {
  state_->device->run([this] { state_->restart(); });
}
std::string Scene::stateHash() {
  return state_->device->run([this] {
    state_->complete();
    return state_->stateHash;
  });
}

std::vector<ArrayInfo> Scene::arrays() {
  return state_->device->run([this] {
    std::vector<ArrayInfo> infos;
    for (const State::Described& one : state_->arrays()) infos.push_back(one.info);
    return infos;
  });
}
Array Scene::read(std::string_view object, std::string_view array) {
  return state_->device->run([&] { return state_->read(object, array); });
}
std::optional<DeviceArray> Scene::readOnDevice(std::string_view object, std::string_view array,
                                               std::string_view member) {
  return state_->device->run([&] { return state_->readOnDevice(object, array, member); });
}
void Scene::write(std::string_view object, std::string_view array, std::span<const float> values) {
  state_->device->run([&] { state_->write(object, array, std::as_bytes(values), NumberType::float32); });
}
void Scene::write(std::string_view object, std::string_view array, std::span<const double> values) {
  state_->device->run([&] { state_->write(object, array, std::as_bytes(values), NumberType::float64); });
}
void Scene::write(std::string_view object, std::string_view array, std::span<const std::int32_t> values) {
  state_->device->run([&] { state_->write(object, array, std::as_bytes(values), NumberType::int32); });
}
void Scene::write(std::string_view object, std::string_view array, std::span<const std::uint32_t> values) {
  state_->device->run([&] { state_->write(object, array, std::as_bytes(values), NumberType::uint32); });
}
void Scene::write(std::string_view object, std::string_view array, std::span<const std::byte> structures) {
  state_->device->run([&] { state_->write(object, array, structures, std::nullopt); });
}

std::vector<std::string> Scene::fields() {
  return state_->device->run([this] {
    state_->complete();
    std::vector<std::string> names;
    for (const sim::Field& field : state_->world->drawables().fields)
      if (!field.decoration) names.push_back(*field.name);
    return names;
  });
}

Array Scene::field(std::string_view name) {
  return state_->device->run([&] {
    state_->complete();
    std::string known;
    const sim::Drawables drawables = state_->world->drawables();
    for (const sim::Field& field : drawables.fields) {
      if (field.decoration) continue;
      if (*field.name == name)
        return api::denseArray(
            *field.name, "", NumberType::float32,
            {static_cast<std::size_t>(field.size.y), static_cast<std::size_t>(field.size.x)},
            sim::fieldValues(field));
      known += (known.empty() ? "" : ", ") + *field.name;
    }
    api::fail(ErrorKind::usage, fmt::format("the scene has no field \"{}\"; it has {}", name,
                                            known.empty() ? "none" : known));
  });
}

std::vector<Quantity> Scene::measure(std::string_view object) {
  return state_->device->run([&] {
    state_->complete();
    const std::size_t index = state_->indexOf(object);
    std::vector<Quantity> quantities;
    const scene::Parameters& parameters = *state_->scene->objects[index].parameters;
    if (!parameters.measures()) return quantities;
    const std::vector<double> values = state_->world->object(index).measure();
    const auto names = parameters.quantities();
    for (std::size_t i = 0; i < std::min(names.size(), values.size()); ++i)
      quantities.push_back({names[i].name, names[i].unit, values[i]});
    return quantities;
  });
}

Mesh Scene::mesh(std::string_view object) {
  return state_->device->run([&] {
    state_->complete();
    const std::optional<sim::MeshTable> table = state_->world->object(state_->indexOf(object)).mesh();
    if (!table) api::fail(ErrorKind::usage, fmt::format("object \"{}\" has no mesh", object));
    const std::size_t vertices = table->positions.size();
    constexpr auto real = NumberType::float32;
    return Mesh{api::denseArray("positions", "m", real, {vertices, 3}, table->positions),
                api::denseArray("normals", "", real, {table->normals.size(), 3}, table->normals),
                api::denseArray("uvs", "", real, {table->uvs.size(), 2}, table->uvs),
                api::denseArray("triangles", "", NumberType::uint32, {table->indices.size() / 3, 3},
                                table->indices)};
  });
}

void Scene::saveState(const std::string& file) {
  state_->device->run([&] {
    state_->complete();
    frame::RunInfo run;
    run.numerics = state_->scene->numerics == scene::Numerics::exact ? "exact" : "fast";
    run.fingerprint = state_->device->numerics.fingerprint;
    run.simulation = hashHex(state_->simulationHash());
    frame::Checkpoint::write(file, run, state_->stateHash, "", *state_->world);
  });
}
Snapshot Scene::snapshot() {
  return state_->device->run([this] {
    state_->complete();
    auto made = std::make_shared<Snapshot::State>();
    made->simulation = state_->simulationHash();
    made->world = frame::stateOf(*state_->world);
    made->changed = state_->changed;
    return Snapshot(std::move(made));
  });
}
void Scene::restore(const Snapshot& snapshot) {
  state_->device->run([&] { state_->restore(*snapshot.state_); });
}

Picture Scene::picture() {
  return state_->device->run([this] { return state_->picture(); });
}

std::vector<CheckResult> Scene::check(const std::vector<int>& frames) {
  const std::set<int> drawn(frames.begin(), frames.end());
  if (!drawn.empty() && *drawn.begin() < 0)
    api::fail(ErrorKind::usage, fmt::format("frames count from 0; there is no frame {}", *drawn.begin()));
  return state_->device->run([&] {
    scene::Scene tested = state_->input.loadForTest(sim::kinds());
    static_cast<void>(sim::frameMotion(tested));
    std::vector<CheckResult> results;
    const std::vector<int> inOrder(drawn.begin(), drawn.end());
    for (const golden::CheckResult& one : golden::runScene(tested, inOrder).checks)
      results.push_back({one.what, one.frame, one.value.value_or(std::numeric_limits<double>::quiet_NaN()),
                         one.passed, one.message});
    return results;
  });
}

RenderResult Scene::render(const std::string& output, const RenderOptions& options,
                           const RenderEvents& events) {
  if (state_->changed)
    api::fail(ErrorKind::usage,
              "the state was written, and a rendering begins at the scene's start; draw frame by frame, or "
              "restart() the scene");
  RenderResult result =
      Rendering::State::make(state_->input, output, options)->run(*state_->device, events);
  if (result.interrupted) api::fail(ErrorKind::interrupted, "interrupted");
  return result;
}

std::vector<std::string> validate(const std::string& file, const LoadOptions& options,
                                  const std::optional<std::string>& text) {
  try {
    scene::SceneInput input = api::inputOf(file, text, options);
    if (!text) input.file = scene::sceneFile(file);
    return input.load(sim::kinds()).remarks;
  } catch (...) {
    api::rethrowAsError(std::current_exception());
  }
}

std::vector<std::byte> encodePng(const Picture& picture) {
  const auto pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  const auto channels = static_cast<std::size_t>(picture.channels);
  if (picture.width < 1 || picture.height < 1 || channels < 3 || channels > 4 ||
      picture.bytes.size() != channels * pixels)
    api::fail(ErrorKind::usage, "a picture has width * height * channels bytes, and 3 or 4 channels");
  try {
    return frame::encodePng({{picture.width, picture.height}, picture.channels, 8, picture.bytes}, {});
  } catch (...) {
    api::rethrowAsError(std::current_exception());
  }
}

}  // namespace simreel
