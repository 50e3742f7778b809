#include "sim/body/figure.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/packed.hpp"
#include "scene/json/words.hpp"
#include "sim/mesh/file/builder.hpp"

namespace simreel::sim {

namespace {

template <class Item>
std::size_t placeOf(const std::vector<Item>& items, const std::string& name, const std::string& what,
                    const char* kind) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].name == name) return i;
    names.push_back(items[i].name);
  }
  fail(ExitCode::usage, "{}: its file has no {} {}; {}", what, kind, scene::inQuotes(name),
       names.empty() ? std::string("it has none") : scene::suggestion(name, names));
}

}  // namespace

int Figure::nodeNamed(const std::string& name, const std::string& what) const {
  return static_cast<int>(placeOf(nodes, name, what, "bone"));
}

const FigureAnimation& Figure::animationNamed(const std::string& name, const std::string& what) const {
  return animations[placeOf(animations, name, what, "animation")];
}

Figure loadFigure(const std::filesystem::path& file) {
  if (!isGltf(file))
    fail(ExitCode::usage,
         "the mesh {} is neither .gltf nor .glb; bones and motions need one of these formats",
         file.string());
  const std::string text = readFile(file, "mesh");
  return unpacked<Figure>(readInSeparateProcess(file, [&] { return packed(readFigure(file, text)); }));
}

}  // namespace simreel::sim
