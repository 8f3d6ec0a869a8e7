// SPDX-License-Identifier: MIT
#include <frostfill/simulation.hpp>
