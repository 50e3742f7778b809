#include "sim/kernels/level.hpp"

#include "sim/grid/color_map.hpp"

namespace simreel::sim {

struct PackKernel {
  static constexpr auto file = "kernels/run/volume.comp";
  gl::Uniform<"width", int> width;
  gl::Uniform<"columns", int> columns;
  gl::Uniform<"rows", int> rows;
  gl::In<"cells"> cells;
  gl::Out<"volumeWords"> packed;
};

namespace {

IsosurfaceShape shapeOf(const KernelVolume& given, glm::ivec3 size) {
  return {size, given.width / static_cast<float>(size.x), given.position, given.closed,
          given.draw == KernelVolume::Draw::cubes};
}

int cellsOf(glm::ivec3 size) {
  return size.x * size.y * size.z;
}

}  // namespace

KernelLevel::KernelLevel(const std::string& name, const KernelPlan& plan, const KernelWatch& watch)
    : given_(*plan.drawn().volume),
      size_(plan.sizeOf(given_.of)),
      columns_((size_.x + 3) / 4),
      watch_(watch),
      pack_(gl::kernelDefines(false)),
      cells_(name + " values of the volume", cellsOf(size_)),
      packed_(name + " volume", 2 * columns_ * size_.y * size_.z),
      surface_(name, shapeOf(given_, size_),
               given_.color.empty() ? std::vector<glm::vec3>() : colorMapStops(given_.map)) {}

KernelLevel::~KernelLevel() = default;

void KernelLevel::update(const KernelStore& store, double time) {
  KernelNumbers from = numbersOf(store, given_.of, given_.show, 1);
  if (!given_.color.empty()) from.slots.push_back(numbersOf(store, given_.of, given_.color, 1).slots[0]);
  from.slots.back().path = given_.color.empty() ? KernelNumbers::chosen : "color";
  gather_.run(
      from,
      {.member = KernelNumbers::chosen, .fourth = given_.color.empty() ? "" : "color", .watch = watch_},
      cells_);
  gl::barrier();
  const int rows = size_.y * size_.z;
  pack_.dispatch(2 * columns_ * rows,
                 {.width = size_.x, .columns = columns_, .rows = rows, .cells = cells_, .packed = packed_});
  gl::barrier();
  const VolumeValues values{&packed_.view(), 4 * columns_, 0};
  IsosurfaceTint tint;
  if (!given_.color.empty())
    tint = {{&packed_.view(), 4 * columns_, 4 * columns_ * rows}, given_.colorRange};
  surface_.make(values, given_.level.at(time), tint);
}

}  // namespace simreel::sim
