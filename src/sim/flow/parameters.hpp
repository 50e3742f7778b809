#pragma once
#include "scene/papered.hpp"
#include "scene/value/fields.hpp"
#include "sim/core/kind.hpp"
#include "sim/flow/file.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/ports/color_scale.hpp"

#include <filesystem>
#include <optional>
#include <string>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Parameters of the object kind "flow": velocities that are constant in time.
struct FlowParameters : ObjectParameters, ShowsQuantity, scene::HasFieldSkin {
  enum class Rows { down, up };
  enum class Show { speed, none };
  std::filesystem::path file;  ///< npy or CSV file of velocities; if empty, `u` and `v` are used
  std::string u = "-y";        ///< expressions for the velocity in m/s as functions of x and y (metres from
                               ///< the centre, y up)
  std::string v = "x";
  glm::ivec2 size{64, 36};  ///< size of the grid for the expressions, in cells
  Rows rows = Rows::down;   ///< order of the rows of an npy file, which is also the direction of positive v
                            ///< in the file
  float scale = 1;          ///< velocity in m/s that the value 1 in the file stands for
  FluidPlane plane;
  bool ownCell = false;  ///< true if the scene gives the cell width
  Show show = Show::speed;
  std::string map = "grey";  ///< name of a colour map
  double low = 0, high = 0;  ///< speeds of the first and the last colour in m/s
  bool ownHigh = false;      ///< true if the scene gives `high`

  void describe(scene::Fields& fields) override;
  void ports(Ports& ports) const override;
  [[nodiscard]] std::string fieldShown(const std::string& object) const override {
    return show == Show::none ? "" : object;
  }
  [[nodiscard]] ShownQuantity shownQuantity() const override { return {"speed", "m/s"}; }
  [[nodiscard]] std::optional<scene::Box> framed() const override;
  [[nodiscard]] std::optional<scene::Box> framedAlone() const override;
  /// Returns the velocities. Throws UserError (inputOutput or usage) for files that cannot be used.
  [[nodiscard]] FlowGrid grid() const;

 private:
  [[nodiscard]] FlowGrid gridOfFile() const;
  [[nodiscard]] FlowGrid gridOfExpressions() const;
};

}  // namespace simreel::sim
