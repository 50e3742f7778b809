// Tests OBJ material libraries. Each line must be drawn or reported as not drawn.
#include "scene/value/asset_path.hpp"
#include "sim/mesh/file/mesh_file.hpp"
#include "unit/help.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

#include <doctest/doctest.h>

namespace simreel::test::polygons_materials {

namespace {

const std::string square =
    "mtllib polygons-materials.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl m\nf 1 2 3 4\n";

/// Returns the square with this material library.
sim::Mesh lookOf(const std::string& library, std::string object = square) {
  const TemporaryFile materials("polygons-materials.mtl", library);
  const std::string name = materials.path().filename().string();
  for (std::size_t at = object.find(" polygons-materials.mtl"); at != std::string::npos;
       at = object.find(" polygons-materials.mtl", at + name.size()))
    object.replace(at + 1, std::string("polygons-materials.mtl").size(), name);
  const TemporaryFile file("polygons-materials.obj", object);
  return sim::importMesh(file.path());
}

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("MTL: invalid and out-of-range numbers are reported") {
  const auto ignored = [](const std::string& line) { return lookOf("newmtl m\n" + line + "\n").ignored; };
  CHECK(ignored("Kd 0.5 0.25 1").empty());
  CHECK(ignored("Kd 0.5").empty());
  CHECK(ignored("Kd 1.00001 -0.00001 0").empty());
  CHECK(ignored("Ks 255 255 255").empty());
  for (const char* line :
       {"Kd 0,5 0 0", "Kd 0.5 0,5 0", "Kd spectral a.rfl", "Kd nan 0 0", "Kd", "d -0,5", "Ke 1 x 1"})
    CHECK(ignored(line) == Lines{"\"" + std::string(line) + "\" of material \"m\""});
  CHECK(ignored("Kd -1 0 0") == Lines{"\"Kd -1 0 0\" of material \"m\" (held to 0 to 1)"});
  CHECK(ignored("Kd 255 128 0") == Lines{"\"Kd 255 128 0\" of material \"m\" (held to 0 to 1)"});
  CHECK(ignored("d 2") == Lines{"\"d 2\" of material \"m\" (held to 0 to 1)"});
  CHECK(ignored("Ns -3") == Lines{"\"Ns -3\" of material \"m\" (held to 0 and above)"});
  CHECK(ignored("norm -bm 0,5 no-such-picture.png") ==
        Lines{"-bm \"0,5\" of norm of material \"m\"",
              "no-such-picture.png (it does not exist or is not a regular file)"});
  const sim::Mesh shown = lookOf("newmtl m\nKd 0.5 0,5 0\nKe 2 -1 0\n");
  CHECK(shown.materials.at(0).color == glm::vec3(1));
  CHECK(shown.materials.at(0).emission == glm::vec3(2, 0, 0));
}

TEST_CASE("MTL: a repeated material name is reported, and the last definition counts") {
  const sim::Mesh twice = lookOf("newmtl m\nKd 1 0 0\nPr 0.2\nnewmtl m\nKd 0 1 0\nNs 998\n");
  CHECK(twice.ignored == Lines{"all definitions of newmtl \"m\" but the last"});
  CHECK(twice.materials.at(0).color == glm::vec3(0, 1, 0));
  CHECK(twice.materials.at(0).roughness == doctest::Approx(std::sqrt(std::sqrt(0.002))));
  // A library that every object names is read only once.
  CHECK(lookOf("newmtl m\nKd 0 1 0\n", "mtllib polygons-materials.mtl\n" + square).ignored.empty());
}

TEST_CASE("materials may reference pictures in every readable folder, and in no other folder") {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("simreel-materials-" + std::to_string(::getpid()));
  const std::string png("\x89PNG\r\n\x1a\n", 8);
  for (const char* name : {"inside/models", "inside/tex", "outside"}) fs::create_directories(folder / name);
  for (const char* name : {"inside/tex/a.png", "outside/b.png"}) std::ofstream(folder / name) << png;
  std::ofstream(folder / "inside/models/m.obj") << "mtllib m.mtl\n" + square.substr(square.find("v "));
  std::ofstream(folder / "inside/models/m.mtl")
      << "newmtl m\nmap_Kd ../tex/a.png\nmap_Ke ../../outside/b.png\n";
  const std::vector<fs::path> none;
  const scene::AssetFolders folders(folder / "inside/scene.json", none, {});
  std::string problem;
  const fs::path mesh = fs::weakly_canonical(folder / "inside/models/m.obj");
  // Without a scene, only the mesh's own folder is allowed.
  CHECK(sim::loadMesh(mesh).ignored == Lines{"../tex/a.png (it lies outside the mesh's folder)",
                                             "../../outside/b.png (it lies outside the mesh's folder)"});
  REQUIRE(folders.find("models/m.obj", problem) == mesh);
  const sim::Mesh read = sim::loadMesh(mesh);
  for (const std::string& line : read.ignored) CAPTURE(line);
  CHECK(read.ignored == Lines{"../../outside/b.png (it lies outside the folders that the scene may read; "
                              "--assets DIR adds one)"});
  CHECK(read.images.size() == 1);
  CHECK(read.materials.at(0).colorMap.image == 0);
  fs::remove_all(folder);
}

}  // namespace simreel::test::polygons_materials
