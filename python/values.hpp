// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/options.hpp>

#include <pybind11/pybind11.h>

#include <cstdint>
#include <optional>
#include <string>

namespace frostfill::python
{

/// What was given, for a message that stays a sentence.
[[nodiscard]] std::string shown(pybind11::handle value);

/// What Python gives for an option: its own types and NumPy's, tuples where the command line has
/// commas, and the words of the command line. Empty if it is of a wrong type.
[[nodiscard]] std::optional<OptionValue> valueOf(const Option& option, pybind11::handle value);

/// And back: numbers, texts, tuples, None.
[[nodiscard]] pybind11::object pythonValue(const OptionValue& value);

/// A path: a str or what has __fspath__. Throws Error usage.
[[nodiscard]] std::string pathOf(pybind11::handle value, const char* name);

/// A whole number of Python or NumPy. Throws Error usage.
[[nodiscard]] std::int64_t wholeNumberOf(pybind11::handle value, const char* name);
/// The same from 0 on.
[[nodiscard]] std::size_t countOf(pybind11::handle value, const char* name);
/// Any number. Throws Error usage.
[[nodiscard]] double numberOf(pybind11::handle value, const char* name);

} // namespace frostfill::python
