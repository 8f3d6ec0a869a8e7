// SPDX-License-Identifier: MIT
// Writes torus.obj, sphere.obj, cube.obj and human.obj into a directory. The same bytes each time:
// no clock, no random numbers, no container whose order depends on addresses.
#include "surface.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>

namespace
{

Surface makeHuman()
{
    constexpr double kHeight = 1.8;
    constexpr std::size_t kVertices = 1111;
    const Eigen::AlignedBox3d box(Eigen::Vector3d(-0.8, -0.08, -0.35),
                                  Eigen::Vector3d(0.8, 1.95, 0.40));
    // By halves, with fat triangles in between: an edge between needles cannot be collapsed well.
    Triangles mesh = polygonise(humanField, box, 0.012);
    evenOut(mesh, humanField, 4);
    for (const std::size_t vertices : {4 * kVertices, 2 * kVertices, kVertices})
    {
        mesh = decimate(mesh, humanField, vertices);
        evenOut(mesh, humanField, 8);
    }

    // Feet on the ground, exactly 1.8 m tall.
    Eigen::AlignedBox3d bounds;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        bounds.extend(vertex);
    }
    const double scale = kHeight / bounds.sizes().y();
    Surface surface;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        surface.vertices.emplace_back(scale * (vertex.x() - bounds.center().x()),
                                      scale * (vertex.y() - bounds.min().y()),
                                      scale * (vertex.z() - bounds.center().z()));
    }
    for (const std::array<int, 3>& face : mesh.faces)
    {
        surface.faces.push_back({face[0], face[1], face[2]});
    }
    return surface;
}

/// Nine digits, and no "-0": what vanishes to rounding is written as 0.
std::string number(double value)
{
    if (std::abs(value) < 1e-12)
    {
        return "0";
    }
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

void write(const Surface& surface, const std::string& title, const std::string& file)
{
    std::string text = "# Frostfill: " + title + "\n";
    for (const Eigen::Vector3d& vertex : surface.vertices)
    {
        text +=
            "v " + number(vertex.x()) + " " + number(vertex.y()) + " " + number(vertex.z()) + "\n";
    }
    for (const std::vector<int>& face : surface.faces)
    {
        text += "f";
        for (const int corner : face)
        {
            text += " " + std::to_string(corner + 1);
        }
        text += "\n";
    }
    std::FILE* output = std::fopen(file.c_str(), "wb");
    if (output == nullptr)
    {
        throw std::runtime_error("cannot create " + file);
    }
    const bool written = std::fwrite(text.data(), 1, text.size(), output) == text.size();
    if (std::fclose(output) != 0 || !written)
    {
        throw std::runtime_error("cannot write " + file);
    }
}

} // namespace

int main(int argc, char** argv)
try
{
    if (argc != 2)
    {
        std::fputs("usage: make_meshes DIRECTORY\n", stderr);
        return 64;
    }
    const std::string directory = argv[1];
    write(makeTorus(1.0, 0.4, 48, 12), "torus, ring radius 1, tube 0.4", directory + "/torus.obj");
    write(makeSphere(1.0, 32, 16), "sphere of radius 1", directory + "/sphere.obj");
    write(makeCube(2.0, 8), "cube of edge 2", directory + "/cube.obj");
    write(makeHuman(), "standing human of height 1.8", directory + "/human.obj");
    return 0;
}
catch (const std::exception& error)
{
    std::fprintf(stderr, "make_meshes: %s\n", error.what());
    return 1;
}
