// SPDX-License-Identifier: MIT
#include "errors.hpp"

#include <cctype>
#include <string>
#include <string_view>

namespace py = pybind11;

namespace frostfill::python
{
namespace
{

/// A kind of error, and the class of Python that it is as well, so that either may be caught.
struct Kind
{
    ErrorCode code;
    const char* name;
    PyObject* also; ///< nullptr: none
    const char* help;
};

constexpr std::size_t kKinds = 10;

const std::array<Kind, kKinds>& kinds()
{
    static const std::array<Kind, kKinds> kAll = {{
        {ErrorCode::thresholdFailed, "ThresholdFailed", nullptr, "A comparison failed."},
        {ErrorCode::usage, "Usage", PyExc_ValueError, "A call or a value that makes no sense."},
        {ErrorCode::badData, "BadData", PyExc_ValueError,
         "A mesh, packing or scene that cannot be used."},
        {ErrorCode::inputMissing, "InputMissing", PyExc_OSError,
         "An input file does not exist or cannot be read."},
        {ErrorCode::missingProgram, "Unavailable", nullptr,
         "OpenGL or a program that is needed is missing."},
        {ErrorCode::postcondition, "Postcondition", nullptr,
         "The result is wrong: a sphere outside the mesh, an overlap, a blank picture."},
        {ErrorCode::outOfMemory, "OutOfMemory", PyExc_MemoryError, "There is too little memory."},
        {ErrorCode::cannotCreate, "CannotCreate", PyExc_OSError,
         "A file or directory cannot be created."},
        {ErrorCode::writeFailed, "WriteFailed", PyExc_OSError,
         "Writing failed, for instance on a full disk."},
        {ErrorCode::stoppedEarly, "StoppedEarly", nullptr, "Stopped before the end."},
    }};
    return kAll;
}

/// The classes live as long as the interpreter.
PyObject* baseClass = nullptr;
std::array<PyObject*, kKinds> classes{};

/// Sentences name options as the command line does. Here they are keywords: "--color-by" becomes
/// "color_by", but not in a command to type.
std::string withKeywords(std::string_view text)
{
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        const bool begins = text.substr(i, 2) == "--" && i + 2 < text.size() &&
                            std::islower(static_cast<unsigned char>(text[i + 2])) != 0 &&
                            (i == 0 || text[i - 1] == ' ' || text[i - 1] == '\'');
        const std::size_t command = text.substr(0, i).rfind("frostfill ");
        const bool inCommand =
            command != std::string_view::npos &&
            text.substr(command, i - command).find_first_of(",;:.") == std::string_view::npos;
        if (!begins || inCommand)
        {
            result += text[i];
            continue;
        }
        for (i += 2; i < text.size() && (text[i] == '-' || std::islower(text[i]) != 0); ++i)
        {
            result += text[i] == '-' ? '_' : text[i];
        }
        --i;
    }
    return result;
}

} // namespace

py::object errorClass(ErrorCode code)
{
    for (std::size_t i = 0; i < kKinds; ++i)
    {
        if (kinds()[i].code == code)
        {
            return py::reinterpret_borrow<py::object>(classes[i]);
        }
    }
    return py::reinterpret_borrow<py::object>(baseClass);
}

void addErrors(py::module_& module)
{
    baseClass = PyErr_NewExceptionWithDoc(
        "frostfill.Error",
        "An error of the library: one sentence says what is wrong, where, and what to do.", nullptr,
        nullptr);
    module.add_object("Error", py::reinterpret_borrow<py::object>(baseClass));
    for (std::size_t i = 0; i < kKinds; ++i)
    {
        const Kind& kind = kinds()[i];
        const py::object also = py::reinterpret_borrow<py::object>(kind.also);
        const py::object base = py::reinterpret_borrow<py::object>(baseClass);
        const py::tuple bases = kind.also ? py::make_tuple(base, also) : py::make_tuple(base);
        py::dict members;
        members["code"] = static_cast<int>(kind.code);
        const std::string name = std::string("frostfill.") + kind.name;
        classes[i] = PyErr_NewExceptionWithDoc(name.c_str(), kind.help, bases.ptr(), members.ptr());
        module.add_object(kind.name, py::reinterpret_borrow<py::object>(classes[i]));
    }
    py::register_exception_translator(
        [](std::exception_ptr thrown)
        {
            try
            {
                std::rethrow_exception(thrown);
            }
            catch (const Error& error)
            {
                const std::string sentence = withKeywords(error.what());
                PyErr_SetString(errorClass(error.code()).ptr(), sentence.c_str());
            }
        });
}

} // namespace frostfill::python
