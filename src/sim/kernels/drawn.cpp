#include "sim/kernels/drawn.hpp"

#include "base/error.hpp"
#include "sim/grid/color_map.hpp"
#include "sim/grid/sheet_mesh.hpp"
#include "sim/kernels/copies.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace simreel::sim {

struct NormalKernel {
  static constexpr auto file = "kernels/run/normals.comp";
  gl::Uniform<"count", int> count;
  gl::In<"positions"> positions;
  gl::In<"ranges"> ranges;
  gl::In<"faces"> faces;
  gl::Out<"normals"> normals;
};

KernelDrawn::KernelDrawn(const std::string& name, const KernelPlan& plan, const KernelFinite& finite,
                         const scene::Material& material, double frameSeconds)
    : name_(name), plan_(plan), finite_(finite), material_(material), normal_(gl::kernelDefines(false)) {
  const PlannedDrawing& drawn = plan.drawn();
  if (drawn.points) pointColors_ = colorMapStops(drawn.points->map);
  if (drawn.volume) level_.emplace(name, plan, finite.watch(KernelFinite::Part::volume));
  if (drawn.terrain) ground_.emplace(name, plan, finite.watch(KernelFinite::Part::terrain), frameSeconds);
  if (drawn.field) fieldColors_ = drawn.field->display.colors();
}

KernelDrawn::~KernelDrawn() = default;

void KernelDrawn::makeFaces(const std::vector<unsigned>& indices, std::size_t vertices) {
  std::vector<glm::ivec2> ranges(vertices), faces(std::max<std::size_t>(1, indices.size()));
  for (const unsigned index : indices)
    if (index < vertices) ++ranges[index].y;
  int begin = 0;
  for (glm::ivec2& range : ranges) {
    range.x = begin;
    begin += range.y;
    range.y = range.x;
  }
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::size_t face = i / 3 * 3;
    if (indices[i] >= vertices) continue;
    faces[static_cast<std::size_t>(ranges[indices[i]].y++)] = {indices[face + (i + 1) % 3],
                                                               indices[face + (i + 2) % 3]};
  }
  ranges_ = gl::Buffer::of(name_ + " faces of vertices", std::span<const glm::ivec2>(ranges));
  faces_ = gl::Buffer::of(name_ + " faces", std::span<const glm::ivec2>(faces));
}

void KernelDrawn::makeSurface(const KernelStore& store) {
  const KernelSurface& surface = *plan_.drawn().surface;
  const KernelNumbers from = numbersOf(store, surface.of);
  const auto vertices = static_cast<std::size_t>(from.count);
  vertices_ = gl::Vec4Array(name_ + " vertices", from.count);
  if (!surface.mesh.empty()) {
    const Mesh mesh = loadMesh(surface.mesh, MeshNormals::shared);
    if (mesh.positions.size() > vertices)
      fail(ExitCode::usage, "kernels \"{}\": {} has {} vertices, the buffer {} only {}", name_,
           surface.mesh.filename().string(), mesh.positions.size(), surface.of, vertices);
    triangles_ = mesh.indices;
    textureCoordinates_ = mesh.uvs;
  } else if (!surface.indices.empty()) {
    const int place = plan_.bufferNamed(surface.indices);
    const PlannedBuffer& planned = plan_.buffers()[static_cast<std::size_t>(place)];
    const auto words = store.buffer(place).readAll<unsigned>();
    const std::size_t first = planned.header / 4, count = planned.count() * planned.stride / 4 / 3 * 3;
    triangles_.assign(words.begin() + static_cast<std::ptrdiff_t>(first),
                      words.begin() + static_cast<std::ptrdiff_t>(first + count));
    for (const unsigned index : triangles_)
      if (index >= vertices)
        fail(ExitCode::usage, "kernels \"{}\": the buffer {} has the index {}, but {} has {} vertices",
             name_, surface.indices, index, surface.of, vertices);
  } else {
    triangles_ = gridIndices(surface.grid);
  }
  indices_ = gl::Buffer::of(name_ + " indices", std::span<const unsigned>(triangles_));
  indexCount_ = static_cast<int>(triangles_.size());
  if (surface.mesh.empty() && surface.indices.empty()) return;
  normals_ = gl::Vec4Array(name_ + " normals", from.count);
  textureCoordinates_.resize(vertices);
  uvs_ = gl::Buffer::of(name_ + " texture coordinates", std::span<const glm::vec2>(textureCoordinates_));
  uvView_ = gl::Texture::view(name_ + " texture coordinates", GL_RG32F, uvs_, 8);
  makeFaces(triangles_, vertices);
}

void KernelDrawn::update(const KernelStore& store, double time) {
  using Part = KernelFinite::Part;
  const PlannedDrawing& drawn = plan_.drawn();
  if (drawn.surface) {
    if (!made_) makeSurface(store);
    const KernelNumbers from = numbersOf(store, drawn.surface->of);
    gather_.run(from,
                {.member = drawn.surface->position,
                 .fill = glm::vec4(0, 0, 0, 1),
                 .watch = finite_.watch(Part::surface)},
                vertices_);
    if (normals_.buffer().bytes() > 0 && !drawn.surface->normal.empty())
      gather_.run(from,
                  {.member = drawn.surface->normal,
                   .fill = glm::vec4(0, 1, 0, 0),
                   .watch = finite_.watch(Part::normals)},
                  normals_);
    else if (normals_.buffer().bytes() > 0)
      normal_.dispatch(from.count, {.count = from.count,
                                    .positions = vertices_,
                                    .ranges = ranges_,
                                    .faces = faces_,
                                    .normals = normals_});
  }
  if (drawn.points) {
    const KernelPoints& points = *drawn.points;
    const KernelNumbers from = numbersOf(store, points.of);
    if (!made_) {
      places_ = gl::Vec4Array(name_ + " places", from.count);
      speeds_ = gl::Vec4Array(name_ + " velocities", from.count);
      if (!points.rotation.empty()) turns_ = gl::Vec4Array(name_ + " rotations", from.count);
    }
    if (!points.rotation.empty()) {
      const KernelNumbers turning = numbersOf(store, points.of, points.rotation, 4);
      quaternions_ = turning.slots[0].offsets.size() == 4;
      gather_.run(turning, {.member = KernelNumbers::chosen, .components = 4}, turns_);
    }
    gather_.run(from,
                {.member = points.position,
                 .fourth = points.mass,
                 .alive = points.alive,
                 .fill = glm::vec4(0, 0, 0, 1),
                 .watch = finite_.watch(Part::points),
                 .marked = false},
                places_);
    gather_.run(from,
                {.member = points.velocity,
                 .alive = points.alive,
                 .components = points.velocity.empty() ? 0 : 3,
                 .watch = finite_.watch(Part::velocities)},
                speeds_);
  }
  if (ground_) ground_->update(store);
  if (level_) level_->update(store, time);
  if (drawn.field) updateField(store);
  made_ = true;
  gl::barrier();
}

void KernelDrawn::updateField(const KernelStore& store) {
  const KernelField& field = *plan_.drawn().field;
  const KernelNumbers from = numbersOf(store, field.of);
  const int place = plan_.bufferNamed(field.of);
  if (!made_) {
    cells_ = gl::Vec4Array(name_ + " cells", from.count);
    words_ = gl::Texture::view(name_ + " cells", GL_RGBA32UI, cells_.buffer());
  }
  const bool texture = place < 0;
  const KernelSlot* slot = field.show.empty() ? nullptr : slotNamed(from.slots, field.show);
  const bool red =
      texture && plan_.textures()[static_cast<std::size_t>(plan_.textureNamed(field.of))].singleChannel();
  KernelNumbers shown = from;
  if (texture && slot == nullptr && !red) {
    KernelSlot color = from.slots[0];
    color.path = "color";
    color.offsets = {0, 4, 8};
    shown.slots = {color};
    slot = shown.slots.data();
  }
  if (slot == nullptr) slot = from.slots.data();
  const bool colors = slot->offsets.size() >= 3;
  // The fourth number repeats the first component, because skins use it as a scalar.
  KernelSlot one = *slot;
  one.path = "first";
  one.offsets.resize(1);
  shown.slots = {*slot, one};
  gather_.run(shown,
              {.member = slot->path,
               .fourth = "first",
               .encoded = field.encoded,
               .watch = finite_.watch(KernelFinite::Part::field)},
              cells_);
  field_ = {};
  field_.name = &name_;
  field_.words = &words_;
  field_.cells = colors ? Field::Cells::colors : Field::Cells::floats;
  field_.ownColors = colors;
  field_.size = {from.size.x, from.size.y};
  field_.rowWords = 4 * from.size.x;
  field_.cellWords = 4;
  field_.range = {static_cast<float>(field.display.low), static_cast<float>(field.display.high)};
  field_.colors = &fieldColors_;
  field_.display = &field.display;
}

Instances KernelDrawn::instances() const {
  const KernelPoints& points = *plan_.drawn().points;
  Instances instances;
  instances.positions = &places_.view();
  instances.velocities = &speeds_.view();
  instances.capacity = static_cast<int>(places_.buffer().bytes() / 16);
  instances.shape = points.shape;
  instances.mesh = points.mesh;
  if (points.alongVelocity) instances.turning = Instances::Turning::velocity;
  if (!points.rotation.empty()) {
    instances.turning = quaternions_ ? Instances::Turning::quaternion : Instances::Turning::direction;
    instances.turns = &turns_.view();
  }
  instances.size = points.size;
  instances.massExponent = points.massExponent;
  instances.colorBy = points.colorBy;
  instances.colorRange = points.colorRange;
  instances.colors = &pointColors_;
  instances.additive = points.additive;
  instances.brightness = points.brightness;
  instances.material = &material_;
  return instances;
}

void KernelDrawn::publish(Drawables& drawables) const {
  const PlannedDrawing& drawn = plan_.drawn();
  if (drawn.surface) {
    Surface surface;
    surface.positions = &vertices_.view();
    if (normals_.buffer().bytes() > 0) {
      surface.normals = &normals_.view();
      surface.uvs = &uvView_;
    } else {
      surface.grid = drawn.surface->grid;
    }
    surface.vertexCount = static_cast<int>(vertices_.buffer().bytes() / 16);
    if (surface.grid.x > 0) surface.vertexCount = surface.grid.x * surface.grid.y;
    surface.indices = &indices_;
    surface.indexCount = indexCount_;
    surface.doubleSided = drawn.surface->doubleSided;
    surface.material = &material_;
    drawables.surfaces.push_back(surface);
  }
  if (ground_) {
    drawables.surfaces.push_back(ground_->surface());
    drawables.surfaces.back().material = &material_;
  }
  if (level_) {
    drawables.surfaces.push_back(level_->surface());
    drawables.surfaces.back().material = &material_;
  }
  if (drawn.points) drawables.instances.push_back(instances());
  if (drawn.field) drawables.fields.push_back(field_);
}

PointTable KernelDrawn::points() const {
  PointTable table;
  const PlannedDrawing& drawn = plan_.drawn();
  const gl::Vec4Array* meshed = drawn.surface ? &vertices_ : ground_ ? &ground_->vertices() : nullptr;
  if (meshed == nullptr && !drawn.points) return table;
  table.columns = {"x", "y", "z"};
  if (meshed != nullptr) {
    for (const glm::vec4& at : meshed->buffer().readAll<glm::vec4>())
      table.values.insert(table.values.end(), {at.x, at.y, at.z});
    return table;
  }
  const auto at = places_.buffer().readAll<glm::vec4>(), speeds = speeds_.buffer().readAll<glm::vec4>();
  table.columns.insert(table.columns.end(), {"vx", "vy", "vz", "mass"});
  for (std::size_t i = 0; i < at.size(); ++i)
    if (!(speeds[i].w < 0))
      table.values.insert(table.values.end(),
                          {at[i].x, at[i].y, at[i].z, speeds[i].x, speeds[i].y, speeds[i].z, at[i].w});
  return table;
}

MeshTable KernelDrawn::surfaceMesh() const {
  const auto at = vertices_.buffer().readAll<glm::vec4>();
  if (normals_.buffer().bytes() == 0) {
    const glm::ivec2 grid = plan_.drawn().surface->grid;
    return sheetMesh(
        grid, std::span(at).first(static_cast<std::size_t>(grid.x) * static_cast<std::size_t>(grid.y)));
  }
  MeshTable table;
  for (const glm::vec4& vertex : at) table.positions.emplace_back(vertex);
  for (const glm::vec4& normal : normals_.buffer().readAll<glm::vec4>()) table.normals.emplace_back(normal);
  table.uvs = textureCoordinates_;
  table.indices = triangles_;
  table.doubleSided = plan_.drawn().surface->doubleSided;
  return table;
}

std::optional<MeshTable> KernelDrawn::mesh() const {
  const PlannedDrawing& drawn = plan_.drawn();
  std::optional<MeshTable> all;
  const auto add = [&](MeshTable part) {
    if (all)
      append(*all, part);
    else
      all = std::move(part);
  };
  if (drawn.surface) add(surfaceMesh());
  if (ground_) add(sheetMesh(ground_->size(), ground_->vertices().buffer().readAll<glm::vec4>()));
  if (level_) add(level_->mesh());
  if (drawn.points && drawn.points->shape == Instances::Shape::mesh)
    add(copiesOf(
        instances(), places_.buffer().readAll<glm::vec4>(), speeds_.buffer().readAll<glm::vec4>(),
        drawn.points->rotation.empty() ? std::vector<glm::vec4>() : turns_.buffer().readAll<glm::vec4>()));
  return all;
}

}  // namespace simreel::sim
