#pragma once

// The public interface of libsimreel: a Device, Scenes on it, and Errors as exceptions.
#include <simreel/device.hpp>
#include <simreel/error.hpp>
#include <simreel/scene.hpp>
#include <simreel/values.hpp>
