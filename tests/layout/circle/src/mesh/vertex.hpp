#include "mesh/face.hpp"
