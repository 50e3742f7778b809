#pragma once

// The public interface of libsimreel. It consists of a Device, Scenes on the Device, Renderings to files,
// and Errors, which are exceptions.
#include <simreel/device.hpp>
#include <simreel/error.hpp>
#include <simreel/load.hpp>
#include <simreel/rendering.hpp>
#include <simreel/scene.hpp>
#include <simreel/values.hpp>
