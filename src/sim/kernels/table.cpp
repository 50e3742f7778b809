#include "sim/kernels/table.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/srgb.hpp"
#include "scene/json/words.hpp"
#include "sim/grid/picture_file.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <set>
#include <string_view>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr std::size_t byteLimit = std::size_t{1} << 30;
constexpr int maxTableSide = 16384;

[[noreturn]] void broken(const std::string& name, const std::string& why) {
  fail(ExitCode::inputOutput, "{}: {}", name, why);
}

std::string_view trimmed(std::string_view text) {
  const char* spaces = " \t\r\"";
  const std::size_t begin = text.find_first_not_of(spaces);
  return begin == std::string_view::npos ? std::string_view()
                                         : text.substr(begin, text.find_last_not_of(spaces) - begin + 1);
}

std::vector<std::string_view> cells(std::string_view line) {
  const char separator = line.find(';') != std::string_view::npos    ? ';'
                         : line.find('\t') != std::string_view::npos ? '\t'
                                                                     : ',';
  std::vector<std::string_view> found;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(separator, begin), line.size());
    found.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return found;
}

KernelTable tableOfCsv(std::string_view text, const std::string& name) {
  KernelTable table;
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string_view> parts = cells(line);
    if (table.columns.empty()) {
      std::set<std::string> seen;
      for (const std::string_view part : parts) {
        std::string column(part);
        for (char& c : column)
          if (!(std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_')) c = '_';
        if (!seen.insert(column).second)
          broken(name, fmt::format("line {}: two columns are called {}", number, scene::inQuotes(column)));
        table.columns.push_back(column);
      }
      continue;
    }
    if (parts.size() != table.columns.size())
      broken(name, fmt::format("line {}: expected {} values, found {}", number, table.columns.size(),
                               parts.size()));
    for (const std::string_view part : parts) {
      double value = 0;
      const auto [at, error] = std::from_chars(part.data(), part.data() + part.size(), value);
      if (error != std::errc() || at != part.data() + part.size() || !std::isfinite(value))
        broken(name, fmt::format("line {}: expected a number, found {}", number,
                                 scene::inQuotes(std::string(part))));
      table.values.push_back(value);
    }
  }
  if (table.values.empty()) broken(name, "the file contains no rows of numbers");
  table.size = {static_cast<int>(table.rows()), 1};
  return table;
}

/// Returns the text of the header. The array's numbers begin where the header ends.
std::string_view npyHeader(std::string_view bytes, const std::string& name) {
  if (bytes.size() < 12 || !bytes.starts_with("\x93NUMPY"))
    broken(name, "the file is not a valid npy file");
  const bool old = bytes[6] == 1;
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 8, old ? 2 : 4);
  if (std::size_t{length} + (old ? 10 : 12) > bytes.size())
    broken(name, "the header of the npy file is truncated");
  return bytes.substr(old ? 10 : 12, length);
}

std::vector<std::size_t> npyShape(std::string_view header, const std::string& name) {
  std::vector<std::size_t> shape;
  const std::size_t at = header.find("'shape'");
  for (std::size_t i = header.find('(', at) + 1;
       at != std::string::npos && i < header.size() && header[i] != ')';) {
    if (std::isdigit(static_cast<unsigned char>(header[i])) == 0) {
      ++i;
      continue;
    }
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(header.data() + i, header.data() + header.size(), value);
    if (error != std::errc() || value > byteLimit) broken(name, "the shape of this array is too large");
    shape.push_back(value);
    i = static_cast<std::size_t>(end - header.data());
  }
  if (shape.empty() || shape.size() > 3)
    broken(name, fmt::format("expected an array of one to three axes, found {}", shape.size()));
  return shape;
}

/// Parses an npy file with a little-endian array of one to three axes in C order. The last axis counts the
/// columns. With three axes, the first two are the rows and columns of a grid.
KernelTable tableOfNpy(const std::string& bytes, const std::string& name) {
  const std::string_view header = npyHeader(bytes, name);
  const std::size_t begin = static_cast<std::size_t>(header.data() - bytes.data()) + header.size();
  const auto has = [&](const char* text) { return header.find(text) != std::string::npos; };
  if (has("'fortran_order': True"))
    broken(name, "the array is in Fortran's order; save numpy.ascontiguousarray(a)");
  const char kind = has("'<f4'")   ? 'f'
                    : has("'<f8'") ? 'd'
                    : has("'<i4'") ? 'i'
                    : has("'<u4'") ? 'u'
                    : has("'<i8'") ? 'l'
                    : has("'|u1'") ? 'b'
                                   : '?';
  if (kind == '?') broken(name, "expected float32, float64, int32, int64, uint32 or uint8, little-endian");
  const std::vector<std::size_t> shape = npyShape(header, name);
  const bool grid = shape.size() == 3;
  const std::size_t line = grid ? shape[1] : 1, columns = shape.size() == 1 ? 1 : shape.back();
  if (grid && (line == 0 || line > maxTableSide || shape[0] > maxTableSide))
    broken(name, fmt::format("expected a grid of at most {} x {}", maxTableSide, maxTableSide));
  const std::size_t rows = shape[0] * line;
  const std::size_t width = kind == 'd' || kind == 'l' ? 8 : kind == 'b' ? 1 : 4;
  if (rows == 0 || columns == 0 || rows > byteLimit / columns / width ||
      bytes.size() - begin < rows * columns * width)
    broken(name, "the array is empty or truncated");
  if (bytes.size() - begin != rows * columns * width) broken(name, "there are bytes behind the array");
  KernelTable table;
  for (std::size_t c = 0; c < columns; ++c) table.columns.push_back(fmt::format("c{}", c));
  table.size = grid ? glm::ivec2(line, shape[0]) : glm::ivec2(rows, 1);
  table.values.reserve(rows * columns);
  const auto add = [&]<class T>(T value, std::size_t i) {
    std::memcpy(&value, bytes.data() + begin + i * sizeof(T), sizeof(T));
    table.values.push_back(static_cast<double>(value));
  };
  for (std::size_t i = 0; i < rows * columns; ++i) {
    if (kind == 'f') add(0.0F, i);
    if (kind == 'd') add(0.0, i);
    if (kind == 'i') add(std::int32_t{0}, i);
    if (kind == 'l') add(std::int64_t{0}, i);
    if (kind == 'u') add(std::uint32_t{0}, i);
    if (kind == 'b') add(std::uint8_t{0}, i);
  }
  return table;
}

KernelTable tableOfMesh(const std::filesystem::path& file) {
  const Mesh mesh = loadMesh(file, MeshNormals::shared);
  KernelTable table{
      {"x", "y", "z", "nx", "ny", "nz", "u", "v"}, {}, {static_cast<int>(mesh.positions.size()), 1}};
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec2 uv = mesh.uvs.empty() ? glm::vec2(0) : mesh.uvs[i];
    for (int c = 0; c < 3; ++c) table.values.push_back(static_cast<double>(mesh.positions[i][c]));
    for (int c = 0; c < 3; ++c) table.values.push_back(static_cast<double>(mesh.normals[i][c]));
    for (int c = 0; c < 2; ++c) table.values.push_back(static_cast<double>(uv[c]));
  }
  return table;
}

KernelTable tableOfPicture(const std::string& bytes, const std::string& name) {
  const Picture picture = decodePicture(bytes, name, "picture", maxTableSide);
  double linear[256];
  for (int i = 0; i < 256; ++i) linear[i] = linearOfSrgb(i / 255.0);
  KernelTable table{{"r", "g", "b", "a"}, {}, picture.size};
  table.values.reserve(picture.rgba.size());
  for (std::size_t i = 0; i < picture.rgba.size(); ++i)
    table.values.push_back(i % 4 == 3 ? picture.rgba[i] / 255.0 : linear[picture.rgba[i]]);
  return table;
}

}  // namespace

KernelTable readKernelTable(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (isMeshFile(file)) return tableOfMesh(file);
  const std::string bytes = readFile(file, "table", byteLimit);
  const std::string name = file.filename().string();
  if (ending == ".csv" || ending == ".txt" || ending == ".tsv") return tableOfCsv(bytes, name);
  if (ending == ".npy") return tableOfNpy(bytes, name);
  if (beginsAsPicture(bytes)) return tableOfPicture(bytes, name);
  fail(
      ExitCode::usage,
      "{}: expected a table (.csv, .npy), a mesh (.obj, .ply, .stl, .gltf, .glb) or a picture (.png, .jpg)",
      name);
}

const KernelTable& KernelTables::of(const std::filesystem::path& file) {
  std::shared_ptr<const KernelTable>& table = tables_[file];
  if (table == nullptr) table = std::make_shared<KernelTable>(readKernelTable(file));
  return *table;
}

const KernelTable* KernelTables::read(const std::filesystem::path& file) const {
  const auto found = tables_.find(file);
  return found == tables_.end() ? nullptr : found->second.get();
}

}  // namespace simreel::sim
