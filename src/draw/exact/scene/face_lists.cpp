#include "draw/exact/scene/face_lists.hpp"

#include "draw/exact/reserve.hpp"
#include "gl/element_array.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace simreel::draw {

struct FaceListKernel {
  static constexpr auto file = "draw/exact/shadows/face_lists.comp";
  using Variant = ListVariant;
  gl::Ambient<"LampBlock"> lampBlock = {};
  gl::Ambient<"lampMembers"> lamps = {};
  gl::In<"places"> places;
  gl::In<"indices"> indices;
  gl::In<"drawArguments"> arguments;
  gl::Uniform<"room", int> room;
  gl::Uniform<"firstFace", int> firstFace;
  gl::Uniform<"faces", int> faces;
  gl::Out<"lists"> lists;
  gl::InOut<"counters"> counters;
};

FaceLists::FaceLists(const gl::Defines& lampDefines) {
  if (lampDefines.empty()) return;
  kernel_ = gl::Kernel<FaceListKernel>(lampDefines, listVariant());
}

int FaceLists::facesAtOnce(int triangles) {
  constexpr std::int64_t maximum = std::int64_t{1} << 26;  // max bytes of the lists; the list of large
                                                           // triangles needs the same number of bytes again
  const std::int64_t room = std::min<std::int64_t>(maximum, gl::limits().storageBlockBytes);
  const auto each = static_cast<std::int64_t>(std::max(triangles, 1)) * std::int64_t{sizeof(GLuint)};
  return static_cast<int>(std::clamp<std::int64_t>(room / each, 1, 96));
}

void FaceLists::makeRoom(const MergedMesh& mesh, int faces) {
  const int triangles = mesh.maxTriangles();
  const auto count = static_cast<std::size_t>(triangles) * static_cast<std::size_t>(faces);
  reserve(numbers_, numberView_, "triangles of lamps' maps", count * sizeof(GLuint), GL_R32UI,
          sizeof(GLuint));
  reserve(counts_, "counts of them", static_cast<std::size_t>(faces) * sizeof(GLuint));
  lists_ = {&mesh.places(), &mesh.indexView(), &numberView_, &counts_, triangles};
}

const TriangleLists& FaceLists::find(const MergedMesh& mesh, int first, int faces) {
  constexpr GLuint zero = 0;
  makeRoom(mesh, faces);
  glClearNamedBufferData(counts_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
  kernel_.dispatch(inRows(mesh.maxTriangles()), {.places = mesh.places(),
                                                 .indices = mesh.indexView(),
                                                 .arguments = mesh.count(),
                                                 .room = mesh.maxTriangles(),
                                                 .firstFace = first,
                                                 .faces = faces,
                                                 .lists = numbers_,
                                                 .counters = counts_});
  return lists_;
}

const TriangleLists& FaceLists::all(const MergedMesh& mesh, int triangles, int faces) {
  makeRoom(mesh, faces);
  std::vector<GLuint> numbers(static_cast<std::size_t>(triangles));
  std::iota(numbers.begin(), numbers.end(), 0U);
  const std::vector<GLuint> counts(static_cast<std::size_t>(faces), static_cast<GLuint>(triangles));
  for (std::size_t face = 0; face < counts.size(); ++face)
    numbers_.write(face * static_cast<std::size_t>(lists_.room) * sizeof(GLuint),
                   std::as_bytes(std::span(numbers)));
  counts_.write(0, std::as_bytes(std::span(counts)));
  gl::barrier();
  return lists_;
}

}  // namespace simreel::draw
