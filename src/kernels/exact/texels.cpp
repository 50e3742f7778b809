#include "kernels/exact/texels.hpp"

#include "kernels/spirv/resource.hpp"
#include "kernels/spirv/writing.hpp"

#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace simreel::kernels {

namespace {

class Texels {
 public:
  Texels(Module& module, Report* report)
      : module_(module), writing_(module, module.body), report_(report) {}

  void run() {
    std::vector<Instruction> body = std::move(module_.body);
    module_.body.clear();
    for (const Instruction& one : body)
      if (one.op == SpvOpLoad || one.op == SpvOpImage || one.op == SpvOpSampledImage)
        from_[one.result] = one.operands[0];
    for (Instruction& one : body) {
      if (report_ != nullptr) {
        at_.follow(module_, report_->files(), one);
        report_->excuse(one.result);
      }
      place(one);
    }
    if (queries_)
      module_.head.insert(module_.head.begin(), {SpvOpCapability, 0, 0, {SpvCapabilityImageQuery}});
    module_.index();
  }

 private:
  void place(Instruction& one) {
    const Id image = one.operands.empty() ? 0 : one.operands[0];
    if (one.op == SpvOpImageFetch) {
      const bool hasLod = one.operands.size() > 3 && (one.operands[2] & SpvImageOperandsLodMask) != 0;
      if (sized(module_.typeOf(image), hasLod)) return read(one, hasLod ? one.operands[3] : 0);
    }
    if (one.op == SpvOpImageRead && sized(module_.typeOf(image), false)) return read(one, 0);
    if (report_ != nullptr && at_.line != 0) {
      if (one.op == SpvOpImageWrite && sized(module_.typeOf(image), false))
        inside(image, one.operands[1], 0, "write", image);
      if (one.op == SpvOpImageTexelPointer) {
        const Id type = module_.global(module_.typeOf(image))->operands[1];
        if (sized(type, false)) inside(writing_.load(type, image), one.operands[1], 0, "write", image);
      }
    }
    module_.body.push_back(std::move(one));
  }

  void read(Instruction& one, Id lod) {
    const Id at = one.operands[1], type = module_.typeOf(at);
    const Id among = inside(one.operands[0], at, lod, "read", one.operands[0]);
    one.operands[1] = writing_.select(among, type, at, module_.globalOf(SpvOpConstantNull, type, {}));
    const Id texel = writing_.emit(one.op, one.type, one.operands);
    writing_.select(among, one.type, texel, module_.globalOf(SpvOpConstantNull, one.type, {}), one.result);
  }

  /// Returns true for images whose size can be queried for each coordinate. Excludes cube maps and
  /// multisampled images.
  bool sized(Id type, bool hasLod) const {
    const Instruction& image = *module_.global(type);
    return image.op == SpvOpTypeImage && image.operands[4] == 0 && image.operands[1] != SpvDimCube &&
           (image.operands[5] == 2 || image.operands[1] == SpvDimBuffer || hasLod);
  }

  std::string nameOf(Id image) const {
    for (auto found = from_.find(image); found != from_.end(); found = from_.find(image))
      image = found->second;
    const std::string name = plainName(module_.name(image));
    return name.empty() ? "a texture" : name;
  }

  /// Emits the test whether a texel is inside the image. Returns the id of the bool.
  Id inside(Id image, Id at, Id lod, const char* kind, Id variable) {
    static constexpr const char* axes[] = {"x", "y", "z"};
    const Instruction shape = *module_.global(module_.typeOf(at));
    const std::uint32_t length = shape.op == SpvOpTypeVector ? shape.operands[1] : 1;
    const Id number = module_.uintType(), flag = module_.boolType();
    const Id sizes = module_.vectorType(module_.intType(), length),
             places = module_.vectorType(number, length), flags = module_.vectorType(flag, length);
    const Id size = lod != 0 ? writing_.emit(SpvOpImageQuerySizeLod, sizes, {image, lod})
                             : writing_.emit(SpvOpImageQuerySize, sizes, {image});
    const Id place = module_.typeOf(at) == places ? at : writing_.emit(SpvOpBitcast, places, {at});
    const Id limits = writing_.emit(SpvOpBitcast, places, {size});
    const Id below = writing_.emit(SpvOpULessThan, flags, {place, limits});
    queries_ = true;
    for (std::uint32_t i = 0; i < length && report_ != nullptr && at_.line != 0; ++i) {
      const bool one = length == 1;
      const Id index = one ? place : writing_.emit(SpvOpCompositeExtract, number, {place, i});
      const Id fine = one ? below : writing_.emit(SpvOpCompositeExtract, flag, {below, i});
      report_->note(module_, module_.body, fine, report_->place(kind, nameOf(variable), at_, axes[i]),
                    index, index);
    }
    return length == 1 ? below : writing_.emit(SpvOpAll, flag, {below});
  }

  Module& module_;
  Writing writing_;
  Report* report_;
  Position at_;
  bool queries_ = false;
  std::unordered_map<Id, Id> from_;  ///< variables from which images were loaded, by the image's id
};

}  // namespace

void keepTexelsInside(Module& module, Report* report) {
  Texels(module, report).run();
}

}  // namespace simreel::kernels
