// SPDX-License-Identifier: MIT
// Any text as the value of an option. The first byte chooses the option, and a 0 ends a value, so
// that several options come together. A value that is taken is written, and read again as the same.
#include <frostfill/error.hpp>
#include <frostfill/options.hpp>

#include <cstdint>
#include <cstdlib>

namespace
{

using namespace frostfill;

void setFromText(Scene& scene, const Option& option, const std::string& text)
{
    const std::optional<OptionValue> value = readOptionText(option, text);
    if (!value || !setOption(option, scene, *value))
    {
        (void)describeAllowed(option);
        if (value)
        {
            (void)nearestAllowed(option, *value);
        }
        return;
    }
    const std::string written = optionText(option, option.get(scene));
    const std::optional<OptionValue> again = readOptionText(option, written);
    if (!again || optionText(option, *again) != written)
    {
        std::abort();
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto options = frostfill::sceneOptions();
    frostfill::Scene scene = frostfill::presetScene(
        size % 2 == 0 ? frostfill::Preset::fast : frostfill::Preset::paper, "torus");
    for (std::size_t at = 0; at < size;)
    {
        const frostfill::Option& option = options[data[at] % options.size()];
        std::string text;
        for (++at; at < size && data[at] != 0; ++at)
        {
            text += static_cast<char>(data[at]);
        }
        ++at;
        setFromText(scene, option, text);
    }
    try
    {
        validateScene(scene);
    }
    catch (const frostfill::Error&)
    {
    }
    return 0;
}
