#include "output/video.hpp"

#include <frostfill/fill.hpp>
#include <frostfill/simulation.hpp>
