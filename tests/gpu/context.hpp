#pragma once
#include "gl/context.hpp"

/// The one context of the test process, with debug output; high-severity messages fail at check().
simreel::gl::Context& testContext();
