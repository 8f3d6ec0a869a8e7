// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/options.hpp>

#include <array>
#include <concepts>
#include <type_traits>

namespace frostfill
{

/// The names of the values of an enumeration, in order.
template <typename Enum>
struct EnumNames;
template <>
struct EnumNames<Axis>
{
    static constexpr std::array<const char*, 3> kNames = {"x", "y", "z"};
};
template <>
struct EnumNames<Integrator>
{
    static constexpr std::array<const char*, 2> kNames = {"explicit", "semi-implicit"};
};
template <>
struct EnumNames<SphereSearch>
{
    static constexpr std::array<const char*, 2> kNames = {"all-pairs", "grid"};
};
template <>
struct EnumNames<PolygonSearch>
{
    static constexpr std::array<const char*, 4> kNames = {"loop", "list", "quadtree", "grid"};
};
template <>
struct EnumNames<DiscardRule>
{
    static constexpr std::array<const char*, 3> kNames = {"none", "paper", "exact"};
};
template <>
struct EnumNames<FreezingRule>
{
    static constexpr std::array<const char*, 2> kNames = {"one-by-one", "by-set"};
};
template <>
struct EnumNames<Preset>
{
    static constexpr std::array<const char*, 2> kNames = {"fast", "paper"};
};
template <>
struct EnumNames<Motion>
{
    static constexpr std::array<const char*, 4> kNames = {"fall", "skip", "descend", "granular"};
};

template <>
struct EnumNames<Rest>
{
    static constexpr std::array<const char*, 2> kNames = {"each", "joint"};
};
template <>
struct EnumNames<SharesOf>
{
    static constexpr std::array<const char*, 3> kNames = {"number", "mass", "volume"};
};
template <>
struct EnumNames<Backend>
{
    static constexpr std::array<const char*, 4> kNames = {"auto", "osmesa", "egl", "builtin"};
};
template <>
struct EnumNames<ColourMap>
{
    static constexpr std::array<const char*, 5> kNames = {"viridis", "cividis", "plasma", "inferno",
                                                          "magma"};
};
template <>
struct EnumNames<EdgeLines>
{
    static constexpr std::array<const char*, 3> kNames = {"auto", "on", "off"};
};
template <>
struct EnumNames<Look>
{
    static constexpr std::array<const char*, 4> kNames = {"clean", "paper", "dark", "studio"};
};

/// Lengths in mesh units outside of these do not occur: squares and cubes of them overflow.
inline constexpr double kSmallestLength = 1e-12;
inline constexpr double kLargestLength = 1e12;

[[nodiscard]] std::string colourText(const Colour& colour);
[[nodiscard]] bool readColour(std::string_view text, Colour& colour);
[[nodiscard]] bool readPictureSize(std::string_view text, PictureSize& size);
/// "0.02..0.05", or a file name, which has a dot or a slash and does not begin like a number.
[[nodiscard]] std::string radiiText(const Radii& radii);
[[nodiscard]] bool readRadii(std::string_view text, Radii& radii);

/// "none", "plane:X,Y,Z,OFFSET" or "wedge:FROM,TO".
[[nodiscard]] std::string cutawayText(const Cutaway& cutaway);
[[nodiscard]] bool readCutaway(std::string_view text, Cutaway& cutaway);
/// "none", or "X,Y,Z,RADIUS", several separated by semicolons.
[[nodiscard]] std::string inletsText(const std::vector<Inlet>& inlets);
[[nodiscard]] bool readInlets(std::string_view text, std::vector<Inlet>& inlets);
/// "none", or names separated by commas.
[[nodiscard]] std::string passesText(const Passes& passes);
[[nodiscard]] bool readPasses(std::string_view text, Passes& passes);

/// Converts a field to an OptionValue. One overload for each type.
inline OptionValue toValue(bool field)
{
    return field;
}
inline OptionValue toValue(double field)
{
    return field;
}
inline OptionValue toValue(const std::string& field)
{
    return field;
}
inline OptionValue toValue(const Eigen::Vector3d& field)
{
    return field;
}
inline OptionValue toValue(const Colour& field)
{
    return colourText(field);
}
inline OptionValue toValue(const PictureSize& field)
{
    return std::to_string(field.width) + "x" + std::to_string(field.height);
}
inline OptionValue toValue(const Radii& field)
{
    return field.equal() ? OptionValue(field.largest) : OptionValue(radiiText(field));
}
inline OptionValue toValue(const Cutaway& field)
{
    return cutawayText(field);
}
inline OptionValue toValue(const std::vector<Inlet>& field)
{
    return inletsText(field);
}
inline OptionValue toValue(const Passes& field)
{
    return passesText(field);
}
template <std::integral Field>
OptionValue toValue(Field field)
{
    return static_cast<std::int64_t>(field);
}
template <typename Enum>
requires std::is_enum_v<Enum> OptionValue toValue(Enum field)
{
    return std::string(EnumNames<Enum>::kNames.at(static_cast<std::size_t>(field)));
}
template <typename Field>
OptionValue toValue(const std::optional<Field>& field)
{
    return field ? toValue(*field) : OptionValue{};
}

template <typename Field>
bool fromValue(Field& field, const OptionValue& value)
{
    if constexpr (std::is_enum_v<Field>)
    {
        const auto& names = EnumNames<Field>::kNames;
        for (std::size_t i = 0; i < names.size(); ++i)
        {
            if (std::get<std::string>(value) == names[i])
            {
                field = static_cast<Field>(i);
                return true;
            }
        }
        return false;
    }
    else if constexpr (std::is_same_v<Field, Colour>)
    {
        return readColour(std::get<std::string>(value), field);
    }
    else if constexpr (std::is_same_v<Field, PictureSize>)
    {
        return readPictureSize(std::get<std::string>(value), field);
    }
    else if constexpr (std::is_same_v<Field, Radii>)
    {
        if (const auto* text = std::get_if<std::string>(&value))
        {
            return readRadii(*text, field);
        }
        field = Radii(std::get<double>(value));
    }
    else if constexpr (std::is_same_v<Field, Cutaway>)
    {
        return readCutaway(std::get<std::string>(value), field);
    }
    else if constexpr (std::is_same_v<Field, std::vector<Inlet>>)
    {
        return readInlets(std::get<std::string>(value), field);
    }
    else if constexpr (std::is_same_v<Field, Passes>)
    {
        return readPasses(std::get<std::string>(value), field);
    }
    else if constexpr (std::integral<Field> && !std::is_same_v<Field, bool>)
    {
        field = static_cast<Field>(std::get<std::int64_t>(value));
    }
    else
    {
        field = std::get<Field>(value);
    }
    return true;
}
template <typename Field>
bool fromValue(std::optional<Field>& field, const OptionValue& value)
{
    if (std::holds_alternative<std::monostate>(value))
    {
        field.reset();
        return true;
    }
    Field some{};
    if (!fromValue(some, value))
    {
        return false;
    }
    field = std::move(some);
    return true;
}

template <typename Field>
struct OptionTypeOf
{
    using Inner = Field;
    static constexpr OptionType kType = std::is_same_v<Field, bool>  ? OptionType::boolean
                                        : std::integral<Field>       ? OptionType::integer
                                        : std::floating_point<Field> ? OptionType::number
                                        : std::is_same_v<Field, Eigen::Vector3d>
                                            ? OptionType::vector
                                        : std::is_same_v<Field, Radii> ? OptionType::radii
                                                                       : OptionType::text;
};
template <typename Field>
struct OptionTypeOf<std::optional<Field>> : OptionTypeOf<Field>
{
};

/// Completes an option for a field. `access` returns a reference to the field of a scene, const or
/// not.
template <typename Access>
Option fieldOption(Option option, Access access)
{
    using Field = std::remove_cvref_t<decltype(access(std::declval<Scene&>()))>;
    option.type = OptionTypeOf<Field>::kType;
    using Inner = typename OptionTypeOf<Field>::Inner;
    if constexpr (std::is_enum_v<Inner>)
    {
        option.choices.assign(EnumNames<Inner>::kNames.begin(), EnumNames<Inner>::kNames.end());
    }
    if constexpr (std::is_same_v<Field, Colour>)
    {
        option.placeholder = "none|#RRGGBB";
    }
    if constexpr (std::is_same_v<Field, PictureSize>)
    {
        option.placeholder = "WxH";
    }
    if constexpr (std::is_same_v<Field, Colour>)
    {
        option.form = "a colour such as #ffcc00, #ffcc0080 with alpha, or none";
    }
    if constexpr (std::is_same_v<Field, PictureSize>)
    {
        option.form = "a size such as 1280x720, from 1x1 to 16384x16384";
    }
    if constexpr (std::is_same_v<Field, Cutaway>)
    {
        option.placeholder = "plane:X,Y,Z|wedge:A,B";
        option.form =
            "none, plane:X,Y,Z or plane:X,Y,Z,OFFSET with a normal, or wedge:FROM,TO in degrees, "
            "at most 180 apart";
    }
    if constexpr (std::is_same_v<Field, Passes>)
    {
        option.placeholder = "none|all|depth,normal,identity";
        option.form = "none, all, or a list of depth, normal and identity";
    }
    if constexpr (std::is_same_v<Field, std::vector<Inlet>>)
    {
        option.placeholder = "X,Y,Z,RADIUS;...";
        option.form =
            "none, or X,Y,Z,RADIUS with a radius above 0, several separated by semicolons";
    }
    option.get = [access](const Scene& scene) { return toValue(access(scene)); };
    option.set = [access](Scene& scene, const OptionValue& value)
    { return fromValue(access(scene), value); };
    return option;
}

} // namespace frostfill
