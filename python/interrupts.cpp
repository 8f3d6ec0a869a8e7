// SPDX-License-Identifier: MIT
#include "interrupts.hpp"

namespace frostfill::python
{
namespace
{

/// Taking the interpreter for each question would cost more than a step does.
constexpr std::chrono::milliseconds kBetweenQuestions{20};

} // namespace

bool Interrupts::happened()
{
    if (raised_ || std::this_thread::get_id() != caller_)
    {
        return raised_ != nullptr;
    }
    const Clock::time_point now = Clock::now();
    if (now - last_ < kBetweenQuestions)
    {
        return false;
    }
    last_ = now;
    const pybind11::gil_scoped_acquire hold;
    if (PyErr_CheckSignals() != 0)
    {
        raised_ = std::make_unique<pybind11::error_already_set>();
    }
    return raised_ != nullptr;
}

void Interrupts::throwIfHappened()
{
    if (raised_)
    {
        throw pybind11::error_already_set(*raised_);
    }
}

} // namespace frostfill::python
