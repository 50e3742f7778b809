#include "sim/mesh/file/library_materials.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "scene/finish.hpp"
#include "sim/grid/picture_file.hpp"
#include "sim/mesh/file/builder.hpp"
#include "sim/mesh/file/library_numbers.hpp"
#include "sim/mesh/file/texture_place.hpp"
#include "sim/polygons/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr int librarySide = 16384;

/// Calls each(key, rest) for each line of a text, where `rest` is the line after the key.
template <class Each>
void eachKey(std::string_view text, const Each& each) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  TextLines lines(text);
  for (std::string_view line; lines.next(line);) {
    line = withoutComment(line, true);
    const std::string_view key = takeWord(line);
    if (!key.empty()) each(key, withoutBlanks(line));
  }
}

/// Returns the file names in an `mtllib` line: the whole line if a file of that name exists. Otherwise, the
/// line is split after each ".mtl", or into its words if it does not end in ".mtl".
std::vector<std::string> libraryNames(const std::filesystem::path& mesh, std::string_view line) {
  std::error_code error;
  if (std::filesystem::exists(resolveInMeshFolder(mesh, line), error)) return {std::string(line)};
  std::vector<std::string> byEnd, words;
  std::string name;
  for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
    words.emplace_back(word);
    name += (name.empty() ? "" : " ") + std::string(word);
    if (lowerExtension(name) != ".mtl") continue;
    byEnd.push_back(name);
    name.clear();
  }
  return name.empty() ? byEnd : words;
}

/// Removes the first word and the blanks after it from a text and returns the word.
std::string_view takeFirst(std::string_view& text) {
  const std::string_view word = takeWord(text);
  text = withoutBlanks(text);
  return word;
}

constexpr MapNames libraryMapNames = {"map_Kd", "map_d", "map_Pr", "norm", "map_Ka", "map_Ke"};

class LibraryReader {
 public:
  LibraryReader(const std::filesystem::path& file, Mesh& mesh) : file_(file), mesh_(mesh) {}

  void read(const std::string& library) {
    if (!libraries_.insert(library).second)
      return;  // Some programs repeat the line, so each library is read only once.
    const std::optional<std::string> text = beside(library, "material library");
    eachKey(text ? std::string_view(*text) : std::string_view(),
            [&](std::string_view key, std::string_view rest) {
              if (key == "newmtl") {
                begin(rest);
              } else if (!name_.empty()) {
                readStatement(all_[name_], key, rest);
              }
            });
    for (auto& [name, material] : all_) {
      name_ = name;
      if (const auto said = light_.find(name); said != light_.end()) ignoreLight(material, said->second);
      agreeOnPlace(material, libraryMapNames, [&](std::string_view key) {
        ignore(fmt::format("{} (its -o and -s are not those of the others)", key));
      });
    }
    light_.clear();
    name_.clear();
  }

  [[nodiscard]] const std::map<std::string, MeshMaterial, std::less<>>& all() const { return all_; }

 private:
  /// Returns the text of a file in the mesh's folder. If the file is not readable, reports it as ignored
  /// and returns nothing.
  std::optional<std::string> beside(const std::string& name, const char* what) {
    const std::filesystem::path path = resolveInMeshFolder(file_, name);
    const std::string why = whyUnread(file_, path);
    if (why.empty()) return readFile(path, what);
    mesh_.ignored.push_back(fmt::format("{} ({})", name, why));
    return std::nullopt;
  }

  /// Legacy lighting parameters of a material, which newer keys replace.
  struct OldLight {
    std::optional<glm::vec3> ambient, mirrored;  ///< colours given by Ka and Ks
    std::optional<float> index, model;           ///< numbers given by Ni and illum
  };

  static bool isGrey(const glm::vec3& color) {
    constexpr float slack = 0.02F;
    return std::max({color.x, color.y, color.z}) - std::min({color.x, color.y, color.z}) <= slack;
  }

  /// Reports legacy lighting parameters that would change the image. Most programs write defaults into
  /// every file, which are not reported: a grey or black Ks, a Ka that is grey or equal to the colour, an
  /// Ni between the values of air and plastics, and an illum for opaque materials or, if d is below 1, for
  /// transparent ones.
  void ignoreLight(const MeshMaterial& material, const OldLight& said) {
    constexpr float plastic = 1.6F;
    if (said.ambient && !isGrey(*said.ambient) && *said.ambient != material.color) ignore("Ka");
    if (said.mirrored && !isGrey(*said.mirrored)) ignore("Ks");
    const bool clear = said.model && (said.model == 4.0F || said.model == 6.0F || said.model == 7.0F ||
                                      said.model == 9.0F);
    if (said.index > plastic || (clear && material.opacity >= 1 && said.index > 1.0F)) ignore("Ni");
    if (said.model == 0.0F || said.model == 10.0F || (clear && material.opacity >= 1))
      ignore(fmt::format("illum {}", *said.model));
  }

  void ignore(std::string_view key) {
    mesh_.ignored.push_back(fmt::format("{} of material \"{}\"", key, name_));
  }

  /// Begins a material. A repeated name replaces the earlier material, as in other programs.
  void begin(std::string_view name) {
    name_ = name;
    MeshMaterial fresh;
    fresh.metallic = 0;
    if (!all_.insert_or_assign(name_, fresh).second)
      mesh_.ignored.push_back(fmt::format("all definitions of newmtl {} but the last", inQuotes(name)));
    hasRoughness_.erase(name_);
    light_.erase(name_);
  }

  /// Returns true if the numbers of a key can be used. Reports as ignored: words that are not numbers
  /// (spectra, CIE coordinates) and numbers that are clamped to the key's range.
  bool hasNumbers(const NumberKey& known, std::string_view key, std::string_view rest) {
    constexpr double hair = 1e-4;  // tolerance for rounding errors of computed colours
    std::string_view words = rest;
    bool held = false;
    for (int i = 0; i < known.numbers; ++i) {
      const std::string_view word = takeWord(words);
      if (word.empty() && i > 0) break;
      const std::optional<double> value = doubleIn(word);
      if (!value || !std::isfinite(*value)) {
        ignore(inQuotes(fmt::format("{} {}", key, rest)));
        return false;
      }
      const bool signless = known.max < unboundedKey || key == "Ns";
      held = held || *value > known.max + hair || (signless && *value < -hair);
    }
    if (held)
      mesh_.ignored.push_back(fmt::format(
          "{} of material {} (held to {})", inQuotes(fmt::format("{} {}", key, rest)), inQuotes(name_),
          known.max < unboundedKey ? fmt::format("0 to {}", known.max) : std::string("0 and above")));
    return true;
  }

  void readStatement(MeshMaterial& material, std::string_view key, std::string_view rest) {
    if (key == "d" && rest.starts_with("-halo")) {
      takeFirst(rest);
      ignore("-halo of d");
    }
    const NumberKey* const known = findNumberKey(key);
    if (known && !hasNumbers(*known, key, rest)) return;
    if (key == "Kd") {
      material.color = colorIn(rest, 1);
    } else if (key == "Ke") {
      material.emission = colorIn(rest, 1e6F);
    } else if (key == "Pr") {
      material.roughness = numbersIn(rest, 1)[0];
      hasRoughness_.insert_or_assign(name_, true);
    } else if (key == "Pm") {
      material.metallic = numbersIn(rest, 1)[0];
    } else if (key == "Ns") {
      // The lobe of a Blinn-Phong exponent n is about as wide as the lobe of alpha^2 = 2 / (n + 2), where
      // alpha is the squared roughness.
      if (hasRoughness_.count(name_) == 0)
        material.roughness = std::sqrt(std::sqrt(2.0F / (numbersIn(rest, 1e6F)[0] + 2)));
    } else if (key == "Ka") {
      light_[name_].ambient = colorIn(rest, 1);
    } else if (key == "Ks") {
      light_[name_].mirrored = colorIn(rest, 1);
    } else if (key == "Ni") {
      light_[name_].index = numberIn(rest);
    } else if (key == "illum") {
      light_[name_].model = numberIn(rest);
    } else if (key == "Pc") {
      material.coat = numbersIn(rest, 1)[0];
    } else if (key == "Pcr") {
      material.coatRoughness = numbersIn(rest, 1)[0];
    } else if (key == "d" || key == "Tr") {
      const float number = numbersIn(rest, 1)[0];
      material.opacity = key == "d" ? number : 1 - number;
      if (material.opacity < 1) material.alpha = static_cast<int>(scene::Alpha::blend);
    } else if (key == "map_Kd") {
      material.colorMap = map(key, rest).map;
    } else if (key == "map_Ke") {
      material.emissionMap = map(key, rest).map;
      if (material.emissionMap.image >= 0 && material.emission == glm::vec3(0))
        material.emission = glm::vec3(1);
    } else if (key == "map_d") {
      material.opacityMap = map(key, rest).map;
      if (material.opacityMap.image >= 0) material.alpha = static_cast<int>(scene::Alpha::cut);
    } else if (key == "norm" || key == "map_Bump" || key == "map_bump" || key == "bump") {
      const Named found = map(key, rest);
      if (found.map.image < 0) return;
      if (key != "norm" && !holdsNormals(found.map)) return ignore(fmt::format("{} (heights)", key));
      material.normals = found.map;
      material.normalStrength = std::clamp(found.strength, -10.0F, 10.0F);
    } else if (key.starts_with("map_") || key == "disp" || key == "refl" ||
               (key == "Tf" && colorIn(rest, 1) != glm::vec3(1)) ||
               ((key == "Ps" || key == "aniso") && numberIn(rest) != 0.0F)) {
      ignore(key);
    }
  }

  /// Texture that a line names, with the options of the line.
  struct Named {
    MeshMap map;
    float strength = 1;  ///< value of the option -bm
  };

  /// Reads up to three numbers before a file name, which may itself look like a number. Missing numbers
  /// keep the values of `numbers`.
  static glm::vec3 takeNumbers(std::string_view& rest, glm::vec3 numbers) {
    for (int i = 0; i < 3; ++i) {
      std::string_view after = rest;
      const std::string word(takeFirst(after));
      char* end = nullptr;
      const double number = std::strtod(word.c_str(), &end);
      if (word.empty() || *end != '\0' || !std::isfinite(number) || after.empty()) break;
      numbers[i] = static_cast<float>(std::clamp(number, -1e6, 1e6));
      rest = after;
    }
    return numbers;
  }

  /// Removes an option from the start of `rest` and applies it. Returns false if `key` is not a known
  /// option.
  bool takeOption(std::string_view key, std::string_view& rest, Named& named, glm::vec2& scale,
                  glm::vec2& offset) {
    std::string_view after = rest;
    const std::string_view option = takeFirst(after);
    if (option == "-s") {
      scale = glm::vec2(takeNumbers(after, glm::vec3(1)));
    } else if (option == "-o") {
      offset = glm::vec2(takeNumbers(after, glm::vec3(0)));
    } else if (option == "-t") {
      if (takeNumbers(after, glm::vec3(0)) != glm::vec3(0)) ignore(fmt::format("-t of {}", key));
    } else if (option == "-mm") {
      const std::optional<float> base = numberIn(takeFirst(after)), gain = numberIn(takeFirst(after));
      if (base != 0.0F || gain != 1.0F) ignore(fmt::format("-mm of {}", key));
    } else if (option == "-bm") {
      const std::string_view word = takeFirst(after);
      const std::optional<float> strength = numberIn(word);
      if (!strength) ignore(fmt::format("-bm {} of {}", inQuotes(word), key));
      named.strength = strength.value_or(1);
    } else if (option == "-clamp") {
      if (takeFirst(after) == "on") named.map.wrapU = named.map.wrapV = scene::Wrap::clamp;
    } else if (option == "-imfchan" || option == "-cc" || option == "-colorspace") {
      const std::string_view word = takeFirst(after);
      if (word != "off") ignore(fmt::format("{} {} of {}", option, word, key));
    } else if (option == "-blendu" || option == "-blendv" || option == "-boost" || option == "-texres" ||
               option == "-type") {
      takeFirst(after);  // skips the value of a filter option, which has no effect
    } else {
      return false;
    }
    rest = after;
    return true;
  }

  /// Returns the texture that a line names after its options. If the options -s and -o have the values s
  /// and o, the texture's u coordinate is s u + o, as programs that write such files define it. The v
  /// coordinate is computed in the same way, counted from the bottom.
  Named map(std::string_view key, std::string_view rest) {
    Named named;
    glm::vec2 scale(1), offset(0);
    while (rest.starts_with('-') && takeOption(key, rest, named, scale, offset)) {
    }
    named.map.place = {glm::mat2(scale.x, 0, 0, scale.y), {offset.x, 1 - scale.y - offset.y}};
    const std::string name(rest);
    const auto known = numbers_.find(name);
    if (known != numbers_.end()) {
      named.map.image = known->second;
      return named;
    }
    std::optional<std::string> bytes = beside(name, "texture");
    if (bytes && !beginsAsPicture(*bytes)) {
      mesh_.ignored.push_back(fmt::format("{} (only PNG, JPEG, PNM and BMP are read)", name));
      bytes.reset();
    }
    named.map.image = bytes ? static_cast<int>(mesh_.images.size()) : -1;
    if (bytes) mesh_.images.push_back({name, std::move(*bytes)});
    numbers_.emplace(name, named.map.image);
    return named;
  }

  /// Returns true if an image looks like a normal map. Normals point outwards, so its average colour is
  /// blue.
  [[nodiscard]] bool holdsNormals(const MeshMap& map) const {
    const MeshImage& image = mesh_.images.at(static_cast<std::size_t>(map.image));
    Picture picture;
    try {
      picture = decodePicture(image.bytes, image.name, "texture", librarySide);
    } catch (const UserError&) {
      return false;
    }
    std::array<double, 3> mean{};
    for (std::size_t at = 0; at < picture.rgba.size(); at += 4)
      for (std::size_t k = 0; k < 3; ++k) mean[k] += picture.rgba[at + k];
    const double texels = static_cast<double>(picture.rgba.size()) / 4;
    return mean[2] > 160 * texels && std::abs(mean[0] - 128 * texels) < 40 * texels &&
           std::abs(mean[1] - 128 * texels) < 40 * texels;
  }

  const std::filesystem::path& file_;
  Mesh& mesh_;
  std::string name_;  ///< name of the material whose lines are being read
  std::map<std::string, MeshMaterial, std::less<>> all_;
  std::map<std::string, bool> hasRoughness_;
  std::map<std::string, OldLight> light_;  ///< legacy lighting of each material in the current library
  std::map<std::string, int> numbers_;
  std::set<std::string> libraries_;  ///< libraries read so far
};

}  // namespace

void checkLibrary(const std::filesystem::path& file, const std::string& line) {
  for (const std::string& name : libraryNames(file, line))
    if (!liesBeside(file, resolveInMeshFolder(file, name)))
      refuseMesh(file, fmt::format("names {}, which lies outside its folder", name));
}

void addLibraryMaterials(const std::filesystem::path& file, const std::vector<std::string>& libraries,
                         const std::vector<std::string>& names, Mesh& mesh) {
  LibraryReader reader(file, mesh);
  for (const std::string& line : libraries)
    for (const std::string& library : libraryNames(file, line)) reader.read(library);
  std::vector<int> numbers;  // for each material of the library: its index in the mesh
  for (const std::string& name : names) {
    const auto found = reader.all().find(name);
    numbers.push_back(found == reader.all().end() ? -1 : static_cast<int>(mesh.materials.size()));
    if (found != reader.all().end())
      mesh.materials.push_back(found->second);
    else
      mesh.ignored.push_back(fmt::format("usemtl {} (no material library has that name)", inQuotes(name)));
  }
  for (int& material : mesh.materialOf) {
    const auto at = static_cast<std::size_t>(material);
    material = material >= 0 && at < numbers.size() ? numbers[at] : -1;
  }
  if (mesh.materials.empty()) mesh.materialOf.clear();
}

}  // namespace simreel::sim
