// Tests field textures: values, block averages, mip maps and category colours.
#include "draw/overlay/field_textures.hpp"

#include "gpu/draw/field_stage.hpp"

#include <algorithm>

#include <doctest/doctest.h>

using namespace simreel;
using Cells = sim::Field::Cells;

namespace {

scene::Scene withSkin(const std::string& field, int side = 1280) {
  scene::Scene scene;
  scene.objects.emplace_back();
  scene.objects[0].material.skin.emplace();
  scene.objects[0].material.skin->field = field;
  scene.render.size = {side, side};
  return scene;
}

std::vector<glm::vec4> texels(const gl::Texture& texture, int level = 0) {
  const int width = std::max(1, texture.width() >> level);
  const int height = std::max(1, texture.height() >> level);
  std::vector<glm::vec4> all(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  glGetTextureImage(texture.name(), level, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(all.size() * 16),
                    all.data());
  return all;
}

}  // namespace

TEST_CASE("field textures hold the values of every cell type, only for fields used by skins") {
  testContext();
  for (const Cells cells : {Cells::bits, Cells::bytes, Cells::floats}) {
    const auto value = [&](int x, int y) {
      return cells == Cells::bits    ? double((x * y + x) % 3 == 1)
             : cells == Cells::bytes ? double((x * 31 + y * 7) % 256)
                                     : 0.37 * x - 1.5 * y;
    };
    const glm::ivec2 size{67, 35};
    FieldStage stage(cells, size, value);
    draw::FieldTextures textures(withSkin("grid"));
    textures.update({.fields = {stage.field}});
    const auto* entry = textures.find("grid");
    REQUIRE(entry != nullptr);
    CHECK(entry->reduction == 1);
    CHECK(entry->cells == size);
    CHECK(entry->stopCount == 2);
    CHECK_FALSE(entry->colored);
    const auto all = texels(entry->texture);
    REQUIRE(all.size() == 67U * 35U);
    int wrong = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        wrong += all[static_cast<std::size_t>(y * size.x + x)].r != static_cast<float>(value(x, y));
    CHECK(wrong == 0);
    draw::FieldTextures others(withSkin("another"));
    others.update({.fields = {stage.field}});
    CHECK(others.find("grid") == nullptr);
    testContext().check();
  }
}

TEST_CASE("field textures average blocks of cells, and the coarsest mip level averages the whole field") {
  testContext();
  const auto value = [](int x, int y) { return double((x * 5 + y * 3) % 7 == 0); };
  for (const Cells cells : {Cells::bits, Cells::floats}) {
    const glm::ivec2 size{200, 131};
    FieldStage stage(cells, size, value);
    // The longer side of the texture is at most 64 texels.
    draw::FieldTextures textures(withSkin("grid", 16));
    textures.update({.fields = {stage.field}});
    const auto* entry = textures.find("grid");
    REQUIRE(entry != nullptr);
    CHECK(entry->reduction == 4);
    const glm::ivec2 side(entry->texture.width(), entry->texture.height());
    CHECK(side == glm::ivec2(50, 33));
    const auto all = texels(entry->texture);
    for (int ty = 0; ty < side.y; ++ty)
      for (int tx = 0; tx < side.x; ++tx) {
        double sum = 0;
        int count = 0;
        for (int y = ty * size.y / side.y; y < (ty + 1) * size.y / side.y; ++y)
          for (int x = tx * size.x / side.x; x < (tx + 1) * size.x / side.x; ++x, ++count)
            sum += value(x, y);
        CHECK(all[static_cast<std::size_t>(ty * side.x + tx)].r ==
              doctest::Approx(sum / count).epsilon(1e-5));
      }
    // The coarsest mip level is the mean over the field, because every cell is in exactly one block.
    CHECK(texels(entry->texture, 5).at(0).r == doctest::Approx(1.0 / 7).epsilon(0.1).scale(0));
  }
}

TEST_CASE("field textures of categories hold colours and follow palette changes") {
  testContext();
  FieldStage stage(Cells::bytes, {64, 64}, [](int x, int) { return x % 2; }, {3, 5, 1},
                   {{1, 0, 0}, {0, 0.5F, 2}});
  stage.field.categories = true;
  draw::FieldTextures textures(withSkin("grid", 8));  // The texture has 32 texels per side. Each texel
                                                      // covers two cells per side.
  textures.update({.fields = {stage.field}});
  const auto* entry = textures.find("grid");
  REQUIRE(entry != nullptr);
  CHECK(entry->colored);
  CHECK(entry->reduction == 2);
  for (const glm::vec4& texel : texels(entry->texture))
    CHECK(glm::vec3(texel) == glm::vec3(0.5F, 0.25F, 1));
  CHECK(glm::vec3(texels(entry->texture, 5).at(0)) == glm::vec3(0.5F, 0.25F, 1));
  stage.colors = {{0, 0, 0}, {0, 0, 1}};
  textures.update({.fields = {stage.field}});
  CHECK(glm::vec3(texels(entry->texture).at(7)) == glm::vec3(0, 0, 0.5F));
}

TEST_CASE("field textures for the exact rasterizer hold the same bits, without mip levels") {
  testContext();
  for (const bool categories : {false, true}) {
    FieldStage stage(Cells::floats, {201, 131}, [](int x, int y) { return (x * 31 + y * 7) % 97 / 24.0; },
                     {3, 5, 2}, {{1, 0, 0}, {0, 0.5F, 2}, {0.3F, 0.2F, 0.1F}});
    stage.field.categories = categories;
    draw::FieldTextures driver(withSkin("grid", 16));
    draw::FieldTextures exact(withSkin("grid", 16), draw::Rasterizer::exact);
    driver.update({.fields = {stage.field}});
    exact.update({.fields = {stage.field}});
    const auto* entry = exact.find("grid");
    REQUIRE(entry != nullptr);
    CHECK(texels(entry->texture) == texels(driver.find("grid")->texture));
    GLint levels = 0;
    glGetTextureParameteriv(entry->texture.name(), GL_TEXTURE_IMMUTABLE_LEVELS, &levels);
    CHECK(levels == 1);
  }
}
