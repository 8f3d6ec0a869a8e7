#include "mesh/vertex.hpp"
