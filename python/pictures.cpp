// SPDX-License-Identifier: MIT
#include "pictures.hpp"

#include "values.hpp"

#include <frostfill/error.hpp>
#include <frostfill/image.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace py = pybind11;

namespace frostfill::python
{
namespace
{

constexpr py::ssize_t kLongestSide = 65535;

Image imageOf(const py::object& picture)
{
    const py::array array = py::array::ensure(picture);
    const bool shaped = array && array.ndim() == 3 && array.shape(0) > 0 && array.shape(1) > 0 &&
                        std::max(array.shape(0), array.shape(1)) <= kLongestSide &&
                        (array.shape(2) == 3 || array.shape(2) == 4);
    if (!shaped || array.dtype().kind() != 'u' || array.itemsize() != 1)
    {
        PyErr_Clear();
        throw Error(ErrorCode::usage,
                    "the picture must be an array of uint8 of shape (height, width, 3 or 4)");
    }
    const auto bytes = py::array_t<std::uint8_t, py::array::c_style>::ensure(array);
    Image image;
    image.height = static_cast<int>(array.shape(0));
    image.width = static_cast<int>(array.shape(1));
    image.channels = static_cast<int>(array.shape(2));
    image.pixels.assign(bytes.data(), bytes.data() + bytes.size());
    return image;
}

} // namespace

py::array drawPicture(const TriangleMesh& mesh, const RenderSettings& settings,
                      const Snapshot& snapshot)
{
    auto image = std::make_unique<Image>();
    {
        const py::gil_scoped_release release;
        Renderer renderer(mesh, settings);
        renderer.render(snapshot, *image);
    }
    const std::vector<py::ssize_t> shape = {image->height, image->width, image->channels};
    const std::uint8_t* pixels = image->pixels.data();
    const py::capsule base(image.get(), [](void* pointer) { delete static_cast<Image*>(pointer); });
    image.release(); // the capsule's now
    return py::array_t<std::uint8_t>(shape, pixels, base);
}

void addPictures(py::module_& module)
{
    module.def(
        "encode_png",
        [](const py::object& picture)
        {
            const Image image = imageOf(picture);
            std::vector<std::uint8_t> bytes;
            {
                const py::gil_scoped_release release;
                bytes = encodePng(image);
            }
            return py::bytes(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        },
        py::arg("picture"));
    module.def(
        "save_png",
        [](const py::object& picture, const py::object& file)
        {
            const Image image = imageOf(picture);
            const std::string path = pathOf(file, "file");
            const py::gil_scoped_release release;
            savePng(image, path);
        },
        py::arg("picture"), py::arg("file"));
}

} // namespace frostfill::python
