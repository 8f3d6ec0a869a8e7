// SPDX-License-Identifier: MIT
// VRML 97 has the nodes of X3D in another notation. What shows or places polygons is written as
// X3D; what else shows a surface is refused by its name.
#include "mesh/files/readers.hpp"
#include "mesh/files/text_scanner.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace frostfill
{
namespace
{

constexpr std::array<std::string_view, 11> kShownNodes = {
    "Transform", "Group", "Anchor", "Billboard",      "Collision", "LOD",
    "Switch",    "Shape", "Box",    "IndexedFaceSet", "Coordinate"};
constexpr std::array<std::string_view, 8> kUnreadNodes = {
    "Sphere", "Cylinder", "Cone", "Extrusion", "ElevationGrid", "Inline", "PROTO", "EXTERNPROTO"};
/// What is in a node is copied into its parent.
constexpr std::size_t kDeepestNode = 500;

bool isOneOf(std::span<const std::string_view> words, std::string_view word)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

struct VrmlNode
{
    std::string_view type = {}; ///< empty: it is left out
    std::string_view name = {};
    std::map<std::string_view, std::string> fields = {};
    std::string children = {};
};

class VrmlText
{
public:
    explicit VrmlText(std::string_view text)
        : scanner_(text, {.comment = '#', .blank = ',', .marks = "[]{}\""})
    {
        open_.push_back({.type = "Scene"});
    }

    std::string asX3d()
    {
        std::string_view before; // a brace is the type of its node
        for (std::string_view word = next(); !word.empty(); word = next())
        {
            readWord(word, before);
            before = word;
        }
        if (open_.size() > 1)
        {
            refuse("the file ends within a node; it is cut off");
        }
        return "<X3D version='3.0'><Scene>" + open_[0].children + "</Scene></X3D>";
    }

private:
    [[noreturn]] void refuse(std::string_view why) const
    {
        refuseAt(scanner_.place(), fmt::format("{}: export the mesh again", why));
    }

    std::string_view next()
    {
        const std::string_view word = scanner_.wordAnywhere();
        if (word == "\"")
        {
            scanner_.skipQuoted();
        }
        return word;
    }

    void readWord(std::string_view word, std::string_view before)
    {
        VrmlNode& here = open_.back();
        if (word == "{")
        {
            const bool isShown = !here.type.empty() && isOneOf(kShownNodes, before) &&
                                 (here.type != "LOD" || here.children.empty()); // the finest
            open_.push_back({.type = isShown ? before : "", .name = std::exchange(name_, "")});
            if (open_.size() > kDeepestNode)
            {
                refuse("its nodes are nested too deep");
            }
        }
        else if (word == "}")
        {
            close();
        }
        else if (word == "DEF")
        {
            name_ = next();
        }
        else if (word == "USE")
        {
            use(next());
        }
        else if (isOneOf(kUnreadNodes, word))
        {
            refuseAt(scanner_.place(),
                     fmt::format("it has {}, and of VRML only IndexedFaceSet and "
                                 "Box are read; convert the mesh to OBJ, STL, PLY "
                                 "or VTP",
                                 word));
        }
        else if (!here.type.empty())
        {
            readField(here, word);
        }
    }

    void readField(VrmlNode& node, std::string_view word)
    {
        const auto isLetter = [](char c)
        { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
        if (word == "TRUE" || word == "FALSE")
        {
            node.fields[field_] = word == "TRUE" ? "true" : "false";
        }
        else if (isLetter(word[0]))
        {
            field_ = std::all_of(word.begin(), word.end(), isLetter) ? word : "";
        }
        else if (word != "[" && word != "]" && word != "\"")
        {
            std::ignore = scanner_.toNumber(word, "the node");
            node.fields[field_].append(word) += ' ';
        }
    }

    void use(std::string_view name)
    {
        const auto used = named_.find(name);
        if (used == named_.end())
        {
            refuse("USE names a node that is not there");
        }
        const auto& [type, number] = used->second;
        if (!type.empty() && !open_.back().type.empty())
        {
            open_.back().children += fmt::format("<{} USE='n{}'/>", type, number);
        }
    }

    void close()
    {
        if (open_.size() == 1)
        {
            refuse("a '}' closes nothing");
        }
        VrmlNode node = std::move(open_.back());
        open_.pop_back();
        field_ = "";
        const bool isEmpty =
            node.children.empty() && node.type != "Box" && node.type != "Coordinate";
        const bool isGroup = isOneOf(std::span(kShownNodes).subspan(2, 4), node.type);
        node.type = isEmpty ? "" : isGroup ? "Group" : node.type;
        if (!node.type.empty())
        {
            std::string& text = open_.back().children;
            text += fmt::format("<{} DEF='n{}'", node.type, ++count_);
            for (const auto& [field, value] : node.fields)
            {
                text += field.empty() ? "" : fmt::format(" {}='{}'", field, value);
            }
            text += fmt::format(">{}</{}>", node.children, node.type);
        }
        if (!node.name.empty())
        {
            named_[node.name] = {node.type, count_};
        }
    }

    TextScanner scanner_;
    std::vector<VrmlNode> open_;
    std::string_view name_;  ///< of the node that follows
    std::string_view field_; ///< of the numbers that follow
    std::map<std::string_view, std::pair<std::string_view, std::size_t>> named_;
    std::size_t count_ = 0; ///< of nodes that are written
};

} // namespace

std::string x3dOfVrml(std::string_view text)
{
    return VrmlText(text).asX3d();
}

} // namespace frostfill
