#include "sim/ports/markers.hpp"

namespace simreel::sim {

const PortInfo Touchable::port = {
    .name = "surface",
    .lacks = ", which nothing touches",
    .none = "the scene has nothing to touch",
    .missing =
        "there is nothing to touch; add a ground or a shape, or give a mesh, a body or water "
        "\"collides\": true, or a cloth \"contact\": true",
};

const PortInfo PathPort::port = {
    .name = "path",
    .lacks = ", which has no path",
    .none = "the scene has no path: add a cave",
    .when = When::afterFrame,
};

const PortInfo CentrePort::port = {
    .name = "place",
    .lacks = "",
    .none = "the scene has none",
    .when = When::afterFrame,
    .implied = [](const scene::Object& /*object*/, std::vector<std::string>& /*parts*/) { return true; },
};

}  // namespace simreel::sim
