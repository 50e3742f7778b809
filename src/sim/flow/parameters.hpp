#pragma once
#include "scene/papered.hpp"
#include "scene/value/fields.hpp"
#include "sim/core/kind.hpp"
#include "sim/flow/file.hpp"
#include "sim/fluid/wind.hpp"

#include <filesystem>
#include <optional>
#include <string>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Parameters of the object kind "flow": velocities that do not change.
struct FlowParameters : ObjectParameters, scene::Papered {
  enum class Rows { down, up };
  enum class Show { speed, none };
  std::filesystem::path file;  ///< npy or CSV file of velocities; empty: `u` and `v`
  std::string u = "-y";        ///< expressions in x and y (metres from the centre, y up), m/s
  std::string v = "x";
  glm::ivec2 size{64, 36};  ///< grid of the expressions in cells
  Rows rows = Rows::down;   ///< direction of the rows of an npy file, and of positive v in it
  float scale = 1;          ///< m/s of a velocity of 1 in the file
  FluidPlane plane;
  bool ownCell = false;  ///< true if the scene gives the width of a cell
  Show show = Show::speed;
  std::string map = "grey";  ///< name of a colour map
  double low = 0, high = 0;  ///< speeds of the first and the last colour in m/s
  bool ownHigh = false;      ///< true if the scene gives `high`

  void describe(scene::Fields& fields) override;
  void ports(Ports& ports) const override;
  [[nodiscard]] std::string fieldShown(const std::string& object) const override {
    return show == Show::none ? "" : object;
  }
  [[nodiscard]] std::optional<scene::Box> framed() const override;
  [[nodiscard]] std::optional<scene::Box> framedAlone() const override;
  /// Returns the velocities. Throws UserError (inputOutput or usage) for files that cannot be used.
  [[nodiscard]] FlowGrid grid() const;

 private:
  [[nodiscard]] FlowGrid gridOfFile() const;
  [[nodiscard]] FlowGrid gridOfExpressions() const;
};

}  // namespace simreel::sim
