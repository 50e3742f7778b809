#include "sim/ports/shown_picture.hpp"

namespace simreel::sim {

const PortInfo ShownPicture::port = {
    .name = "picture", .lacks = ", which is no picture", .none = "the scene has no picture"};

}  // namespace simreel::sim
