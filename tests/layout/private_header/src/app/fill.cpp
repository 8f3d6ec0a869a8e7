#include "output/atomic_file.hpp"

#include <frostfill/fill.hpp>
#include <frostfill/simulation.hpp>
