#include "sim/mesh/file/builder.hpp"
#include "sim/mesh/file/polygon_meshes.hpp"
#include "sim/polygons/distinct.hpp"
#include "sim/polygons/problem.hpp"
#include "sim/polygons/words.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

constexpr std::size_t headerBytes = 80, countBytes = 4, facetBytes = 50, normalBytes = 12;
/// Cosine of the largest angle between faces that are drawn as one smooth surface: 30 degrees.
constexpr double creaseCosine = 0.8660254037844386;
/// Vertices with more faces than this, such as the tip of a finely divided cone, are drawn with flat faces.
constexpr std::size_t maxSmoothed = 256;

/// Facets of an STL file with three corners each.
struct Facets {
  std::vector<glm::vec3> corners;
  std::size_t after = 0;  ///< bytes behind the last facet
  bool attributed = false;
};

struct PlaceHash {
  std::uint64_t operator()(const glm::vec3& place) const {
    WordHash hash;
    for (int k = 0; k < 3; ++k) hash.add(std::bit_cast<std::uint32_t>(place[k] == 0 ? 0.0F : place[k]));
    return hash.value();
  }
};

struct CornerHash {
  std::uint64_t operator()(const std::array<float, 6>& corner) const {
    WordHash hash;
    for (const float value : corner) hash.add(std::bit_cast<std::uint32_t>(value == 0 ? 0.0F : value));
    return hash.value();
  }
};

std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t k = 0; k < 4; ++k)
    word |= std::uint32_t{static_cast<unsigned char>(bytes[at + k])} << 8 * k;
  return word;
}

void checkCount(std::size_t facets) {
  if (facets > maxMeshItems)
    throw PolygonProblem(fmt::format("has more than {} triangles; simplify it", maxMeshItems));
}

/// Reads little-endian facets. Each has a normal, three corners, and two bytes of attributes.
Facets binaryFacets(std::string_view bytes) {
  const std::size_t count = wordAt(bytes, headerBytes);
  checkCount(count);
  const std::size_t begin = headerBytes + countBytes;
  if ((bytes.size() - begin) / facetBytes < count)
    throw PolygonProblem(
        fmt::format("is cut off: its header announces {} triangles, and it has the bytes of {}", count,
                    (bytes.size() - begin) / facetBytes));
  Facets facets;
  facets.corners.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t facet = begin + i * facetBytes;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      glm::vec3 place;
      for (std::size_t k = 0; k < 3; ++k)
        place[static_cast<int>(k)] =
            std::bit_cast<float>(wordAt(bytes, facet + normalBytes + 12 * corner + 4 * k));
      facets.corners.push_back(place);
    }
    facets.attributed = facets.attributed || bytes[facet + 48] != 0 || bytes[facet + 49] != 0;
  }
  facets.after = bytes.size() - begin - count * facetBytes;
  return facets;
}

std::string lowerCase(std::string_view word) {
  std::string lower(word);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

/// Reads facets from a text word by word. Ignores the names of solids.
class TextFacets {
 public:
  explicit TextFacets(std::string_view text) : lines_(text) {}

  Facets read() {
    while (lines_.next(line_)) {
      const std::string_view whole = line_;
      while (!line_.empty()) {
        const std::string word = lowerCase(takeWord(line_));
        if (word == "solid" || word == "endsolid") {  // the keyword is followed by a name and, in one-line
                                                      // files, by a facet
          const std::size_t facet = lowerCase(line_).find("facet normal");
          if (word == "endsolid" || facet == std::string::npos) break;
          line_.remove_prefix(facet);
          continue;
        }
        if (!word.empty()) readWord(word, whole);
      }
    }
    if (facets_.corners.size() % 3 != 0 || corners_ != 0)
      throw PolygonProblem("ends in the middle of a facet");
    return std::move(facets_);
  }

 private:
  void readWord(const std::string& word, std::string_view whole) {
    if (word == "vertex") {
      glm::vec3 place;
      for (int k = 0; k < 3; ++k) {
        const auto number = floatIn(takeWord(line_));
        if (!number) refuse(whole, "expected three numbers");
        place[k] = *number;
      }
      if (++corners_ > 3) refuse(whole, "a facet has three corners");
      facets_.corners.push_back(place);
      checkCount(facets_.corners.size() / 3);
    } else if (word == "endloop") {
      if (corners_ != 3) refuse(whole, fmt::format("a facet has three corners, not {}", corners_));
      corners_ = 0;
    } else if (word == "normal") {
      for (int k = 0; k < 3; ++k)
        static_cast<void>(takeWord(line_));  // skips the stored normal, because
                                             // the corners determine it
    } else if (word != "facet" && word != "outer" && word != "loop" && word != "endfacet") {
      refuse(whole, "expected \"facet\", \"vertex\" or another word of STL");
    }
  }

  [[noreturn]] void refuse(std::string_view whole, const std::string& why) const {
    throw PolygonProblem(
        fmt::format("has an invalid line {} ({}): {}", lines_.number(), why, inQuotes(whole)));
  }

  TextLines lines_;
  std::string_view line_;
  std::size_t corners_ = 0;
  Facets facets_;
};

/// Returns the facets. Binary files are recognized by their size, because their header may also start with
/// "solid".
Facets facetsOf(std::string_view bytes) {
  const bool hasCount = bytes.size() >= headerBytes + countBytes;
  const bool exact = hasCount && (bytes.size() - headerBytes - countBytes) ==
                                     facetBytes * std::size_t{wordAt(bytes, headerBytes)};
  std::string_view start = bytes.substr(0, 256);
  const bool solid = lowerCase(takeWord(start)) == "solid";
  if (!exact && solid) return TextFacets(bytes).read();
  if (!exact && bytes.starts_with("\xEF\xBB\xBF")) return facetsOf(bytes.substr(3));
  const std::string_view head = bytes.substr(0, headerBytes + countBytes);
  if (!exact && std::none_of(head.begin(), head.end(), [](char c) { return c >= 0 && c < '\t'; }))
    throw PolygonProblem("is no STL: it is a text that does not start with \"solid\"");
  if (!hasCount)
    throw PolygonProblem("is no STL: it is shorter than a header and does not start with \"solid\"");
  return binaryFacets(bytes);
}

/// Computes the normal of each corner as the sum of face normals around the vertex, weighted by area. Only
/// faces whose angle to the corner's face is at most the crease angle contribute.
class Creases {
 public:
  Creases(const std::vector<glm::vec3>& corners, const std::vector<unsigned>& vertices, std::size_t count)
      : vertices_(vertices), first_(count + 1, 0) {
    for (const unsigned vertex : vertices) ++first_[vertex + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    around_.resize(vertices.size());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      around_[next[vertices[i]]++] = static_cast<unsigned>(i / 3);
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      const glm::dvec3 from(corners[i]);
      const glm::dvec3 normal =
          glm::cross(glm::dvec3(corners[i + 1]) - from, glm::dvec3(corners[i + 2]) - from);
      const double length = glm::length(normal);
      normals_.push_back(normal);
      units_.push_back(length > 0 && std::isfinite(length) ? normal / length : glm::dvec3(0));
    }
  }

  /// Returns the unit normal of a corner; 0 if the corner's face has no area.
  [[nodiscard]] glm::vec3 at(std::size_t corner) const {
    const unsigned vertex = vertices_[corner];
    const glm::dvec3 own = units_[corner / 3];
    if (first_[vertex + 1] - first_[vertex] > maxSmoothed) return glm::vec3(own);
    glm::dvec3 sum(0);
    for (std::size_t i = first_[vertex]; i < first_[vertex + 1]; ++i)
      if (glm::dot(units_[around_[i]], own) >= creaseCosine) sum += normals_[around_[i]];
    const double length = glm::length(sum);
    return length > 0 && std::isfinite(length) ? glm::vec3(sum / length) : glm::vec3(0);
  }

 private:
  const std::vector<unsigned>& vertices_;
  std::vector<std::size_t> first_;  ///< for each vertex: index in around_ of its first face
  std::vector<unsigned> around_;    ///< faces around each vertex, stored one vertex after another
  std::vector<glm::dvec3> normals_, units_;
};

}  // namespace

Mesh readStl(const std::filesystem::path& file, std::string_view bytes, MeshNormals normals) {
  try {
    const Facets facets = facetsOf(bytes);
    Distinct<glm::vec3, PlaceHash> places;
    std::vector<unsigned> vertices;
    vertices.reserve(facets.corners.size());
    for (const glm::vec3& corner : facets.corners) vertices.push_back(places.number(corner).first);
    const Creases creases(facets.corners, vertices, places.keys().size());
    Distinct<std::array<float, 6>, CornerHash> distinct;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const glm::vec3& place = facets.corners[i];
      const glm::vec3 normal = normals == MeshNormals::shown ? creases.at(i) : glm::vec3(0);
      vertices[i] = distinct.number({place.x, place.y, place.z, normal.x, normal.y, normal.z}).first;
    }
    MeshBuilder builder(file);
    builder.begin(distinct.keys().size(), vertices.size() / 3, glm::mat4(1), false);
    for (const auto& v : distinct.keys()) builder.vertex({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {0, 0});
    for (std::size_t i = 0; i < vertices.size(); i += 3)
      builder.triangle({vertices[i], vertices[i + 1], vertices[i + 2]});
    Mesh mesh = builder.finish();
    if (facets.after > 0)
      mesh.undrawn.push_back(fmt::format("{} bytes after its last triangle", facets.after));
    if (facets.attributed)
      mesh.ignored.emplace_back("the attributes of its triangles, which may be colours");
    return mesh;
  } catch (const PolygonProblem& problem) {
    refuseMesh(file, problem.what());
  }
}

}  // namespace simreel::sim
