// SPDX-License-Identifier: MIT
#include "simulation/world/world.hpp"
