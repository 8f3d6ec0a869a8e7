// SPDX-License-Identifier: MIT
#include "values.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace py = pybind11;

namespace frostfill::python
{
namespace
{

bool isBoolean(py::handle value)
{
    return PyBool_Check(value.ptr()) ||
           std::string_view(Py_TYPE(value.ptr())->tp_name) == "numpy.bool_";
}

bool isSequence(py::handle value)
{
    return py::isinstance<py::sequence>(value) && !py::isinstance<py::str>(value) &&
           !py::isinstance<py::bytes>(value);
}

/// Takes a result of the C interface, or forgets the error.
std::optional<py::object> owned(PyObject* result)
{
    if (result == nullptr)
    {
        PyErr_Clear();
        return std::nullopt;
    }
    return py::reinterpret_steal<py::object>(result);
}

/// Whole numbers of Python and NumPy, and nothing that would have to be rounded.
std::optional<std::int64_t> wholeNumber(py::handle value)
{
    if (isBoolean(value) || PyIndex_Check(value.ptr()) == 0)
    {
        return std::nullopt;
    }
    const auto index = owned(PyNumber_Index(value.ptr()));
    const std::int64_t number = index ? PyLong_AsLongLong(index->ptr()) : -1;
    if (!index || (number == -1 && PyErr_Occurred() != nullptr))
    {
        PyErr_Clear();
        return std::nullopt;
    }
    return number;
}

std::optional<double> realNumber(py::handle value)
{
    if (isBoolean(value) || py::isinstance<py::str>(value) || isSequence(value))
    {
        return std::nullopt;
    }
    const auto real = owned(PyNumber_Float(value.ptr()));
    return real ? std::optional(PyFloat_AsDouble(real->ptr())) : std::nullopt;
}

std::optional<Eigen::Vector3d> vectorOf(py::handle value)
{
    if (!isSequence(value) || py::len(value) != 3)
    {
        return std::nullopt;
    }
    Eigen::Vector3d vector;
    for (int axis = 0; axis < 3; ++axis)
    {
        const auto number = realNumber(value[py::int_(axis)]);
        if (!number)
        {
            return std::nullopt;
        }
        vector[axis] = *number;
    }
    return vector;
}

/// A text, a path, a number, or a sequence of them as the command line has it: 800x600, 5,7,90.
std::optional<std::string> textOf(const Option& option, py::handle value)
{
    if (py::isinstance<py::str>(value))
    {
        return value.cast<std::string>();
    }
    if (isBoolean(value))
    {
        const auto& texts = option.choices;
        const bool switches = std::find(texts.begin(), texts.end(), "on") != texts.end();
        return switches ? std::optional<std::string>(value.cast<bool>() ? "on" : "off")
                        : std::nullopt;
    }
    if (const auto number = wholeNumber(value))
    {
        return fmt::format("{}", *number);
    }
    if (py::hasattr(value, "__fspath__"))
    {
        const auto path = owned(PyOS_FSPath(value.ptr()));
        return path && py::isinstance<py::str>(*path) ? std::optional(path->cast<std::string>())
                                                      : std::nullopt;
    }
    constexpr std::size_t kMaxParts = 100000;
    if (!isSequence(value) || !option.choices.empty() || py::len(value) == 0 ||
        py::len(value) > kMaxParts)
    {
        return std::nullopt;
    }
    std::string text;
    const char* separator = option.placeholder == "WxH" ? "x" : ",";
    for (const py::handle part : value)
    {
        const auto word = isSequence(part) ? std::nullopt : textOf(option, part);
        if (!word)
        {
            return std::nullopt;
        }
        text += (text.empty() ? "" : separator) + *word;
    }
    return text;
}

/// A number, a pair as a range, or the name of a file.
std::optional<OptionValue> radiiOf(const Option& option, py::handle value)
{
    if (isSequence(value) && py::len(value) == 2)
    {
        const auto low = realNumber(value[py::int_(0)]);
        const auto high = realNumber(value[py::int_(1)]);
        return low && high ? std::optional<OptionValue>(fmt::format("{}..{}", *low, *high))
                           : std::nullopt;
    }
    if (const auto number = realNumber(value))
    {
        return *number;
    }
    const auto text = isSequence(value) ? std::nullopt : textOf(option, value);
    return text ? readOptionText(option, *text) : std::nullopt;
}

template <class T>
std::optional<OptionValue> asValue(const std::optional<T>& value)
{
    return value ? std::optional<OptionValue>(*value) : std::nullopt;
}

} // namespace

std::string shown(py::handle value)
{
    constexpr std::size_t kMax = 60;
    std::string text;
    try
    {
        text = py::str(value);
    }
    catch (const py::error_already_set&)
    {
        text = py::str(py::type::handle_of(value).attr("__name__"));
    }
    std::replace_if(
        text.begin(), text.end(), [](unsigned char letter) { return letter < ' '; }, ' ');
    return text.size() > kMax ? text.substr(0, kMax) + "..." : text;
}

std::optional<OptionValue> valueOf(const Option& option, py::handle value)
{
    if (value.is_none())
    {
        return OptionValue{};
    }
    // A text may be a word for a value: "auto", "mm", "none".
    const bool isText = py::isinstance<py::str>(value);
    switch (option.type)
    {
    case OptionType::boolean:
        return isText             ? readOptionText(option, value.cast<std::string>())
               : isBoolean(value) ? std::optional<OptionValue>(value.cast<bool>())
                                  : std::nullopt;
    case OptionType::integer:
        return isText ? readOptionText(option, value.cast<std::string>())
                      : asValue(wholeNumber(value));
    case OptionType::number:
        return isText ? readOptionText(option, value.cast<std::string>())
                      : asValue(realNumber(value));
    case OptionType::vector:
        return isText ? readOptionText(option, value.cast<std::string>())
                      : asValue(vectorOf(value));
    case OptionType::radii:
        return radiiOf(option, value);
    case OptionType::text:
        break;
    }
    const auto text = textOf(option, value);
    return text ? readOptionText(option, *text) : std::nullopt;
}

py::object pythonValue(const OptionValue& value)
{
    if (const auto* vector = std::get_if<Eigen::Vector3d>(&value))
    {
        return py::make_tuple(vector->x(), vector->y(), vector->z());
    }
    if (const auto* yes = std::get_if<bool>(&value))
    {
        return py::bool_(*yes);
    }
    if (const auto* whole = std::get_if<std::int64_t>(&value))
    {
        return py::int_(*whole);
    }
    if (const auto* number = std::get_if<double>(&value))
    {
        return py::float_(*number);
    }
    if (const auto* text = std::get_if<std::string>(&value))
    {
        return py::str(*text);
    }
    return py::none();
}

std::string pathOf(py::handle value, const char* name)
{
    PyObject* bytes = nullptr;
    if (PyUnicode_FSConverter(value.ptr(), &bytes) == 0)
    {
        PyErr_Clear();
        throw Error(ErrorCode::usage,
                    fmt::format("{} is {}, but it must be a str or a path", name, shown(value)));
    }
    const auto text = py::reinterpret_steal<py::bytes>(bytes).cast<std::string>();
    constexpr std::size_t kLongestPath = 4096; // of Linux
    if (text.empty() || text.size() > kLongestPath)
    {
        throw Error(ErrorCode::usage, fmt::format("{} is {}: give a path", name,
                                                  text.empty() ? "an empty text" : "too long"));
    }
    return text;
}

std::int64_t wholeNumberOf(py::handle value, const char* name)
{
    const auto number = wholeNumber(value);
    if (!number)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("{} is {}, but it must be a whole number", name, shown(value)));
    }
    return *number;
}

double numberOf(py::handle value, const char* name)
{
    const double number = PyFloat_AsDouble(value.ptr());
    if (PyErr_Occurred() != nullptr)
    {
        PyErr_Clear();
        throw Error(ErrorCode::usage,
                    fmt::format("{} is {}, but it must be a number", name, shown(value)));
    }
    return number;
}

std::size_t countOf(py::handle value, const char* name)
{
    const std::int64_t number = wholeNumberOf(value, name);
    if (number < 0 || number > 0xffffffff)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("{} is {}, but it must be a whole number from 0 to 4294967295",
                                name, number));
    }
    return static_cast<std::size_t>(number);
}

} // namespace frostfill::python
