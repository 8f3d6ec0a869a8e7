// SPDX-License-Identifier: MIT
#include "scene/read_sizes.hpp"

#include "base/read_number.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

constexpr double kSmallestSize = 1e-12; ///< [mesh unit]
constexpr double kLargestSize = 1e12;   ///< [mesh unit]
/// What rounding in a table may make of a whole. [1] Larger: a share that was forgotten passes.
constexpr double kOfTheWhole = 0.002;
constexpr double kPercent = 100;
constexpr std::size_t kFewestSieves = 20; ///< at which a curve is looked at

constexpr const char* kHeaderForm =
    "a header names the columns, such as 'diameter,cumulative mass' or 'radius,share'";

/// What the first line says of the columns.
struct Header
{
    bool isDiameter = false;
    bool isCumulative = false;
    std::optional<SharesOf> by;
    char separator = ',';
};

/// Without spaces and quotation marks around it.
std::string_view trimmed(std::string_view text)
{
    constexpr const char* kSpaces = " \t\r\"";
    const std::size_t first = text.find_first_not_of(kSpaces);
    return first == std::string_view::npos
               ? std::string_view{}
               : text.substr(first, text.find_last_not_of(kSpaces) + 1 - first);
}

/// As a message has it: a file may hold anything.
std::string shown(std::string_view text)
{
    constexpr std::size_t kMost = 60;
    std::string some(text.substr(0, kMost));
    std::replace_if(
        some.begin(), some.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return some;
}

/// The words of a heading, in small letters.
std::vector<std::string> wordsOf(std::string_view heading)
{
    std::string text(trimmed(heading));
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return c == '_' ? ' ' : std::tolower(c); });
    std::istringstream in(text);
    return {std::istream_iterator<std::string>(in), {}};
}

struct Row
{
    std::size_t line;
    double radius;
    double share; ///< as written
};

/// Reads one file, and says of what is wrong where it is.
class SizeFile
{
public:
    SizeFile(const std::string& file, std::optional<SharesOf> by) : file_(file), by_(by) {}
    [[nodiscard]] SizeCurve read();

private:
    [[noreturn]] void refuse(std::size_t line, const std::string& what) const
    {
        throw Error(ErrorCode::badData, fmt::format("{}, line {}: {}", file_, line, what));
    }
    void readHeader(std::string_view text);
    void readRow(std::string_view text);
    [[nodiscard]] double number(std::string_view text, const char* what) const;
    [[nodiscard]] int power() const;
    void order();
    [[nodiscard]] double whole(double sum, const char* what) const;
    [[nodiscard]] std::vector<SizeCurve::Piece> ofShares() const;
    [[nodiscard]] std::vector<SizeCurve::Piece> ofCurve() const;
    [[nodiscard]] std::vector<double> sieves() const;

    const std::string& file_;
    std::optional<SharesOf> by_;
    Header header_;
    std::size_t line_ = 0;
    std::size_t headerLine_ = 0;
    std::vector<Row> rows_;
};

void SizeFile::readHeader(std::string_view text)
{
    headerLine_ = line_;
    header_.separator = text.find(';') != std::string_view::npos ? ';' : ',';
    const auto columns = partsOf(text, header_.separator);
    if (columns.size() != 2)
    {
        refuse(line_, fmt::format("'{}' does not name two columns; {}", shown(text), kHeaderForm));
    }
    const std::vector<std::string> sizes = wordsOf(columns[0]);
    for (const std::string& word : sizes)
    {
        header_.isDiameter = header_.isDiameter || word == "diameter";
        if (word != "radius" && word != "diameter")
        {
            refuse(line_, fmt::format("'{}' is not radius or diameter, in the unit of the mesh; {}",
                                      shown(word), kHeaderForm));
        }
    }
    bool hasShares = false;
    for (const std::string& word : wordsOf(columns[1]))
    {
        const bool isCumulative = word == "cumulative" || word == "passing";
        header_.isCumulative = header_.isCumulative || isCumulative;
        hasShares = hasShares || isCumulative || word == "share";
        header_.by = word == "number"   ? SharesOf::number
                     : word == "mass"   ? SharesOf::mass
                     : word == "volume" ? SharesOf::volume
                                        : header_.by;
        static constexpr std::string_view kWords[] = {"share", "cumulative", "passing", "number",
                                                      "mass",  "volume",     "%",       "by"};
        if (std::find(std::begin(kWords), std::end(kWords), word) == std::end(kWords))
        {
            refuse(line_, fmt::format("'{}' is not share, cumulative, passing, number, mass, "
                                      "volume or %; {}",
                                      shown(word), kHeaderForm));
        }
    }
    if (sizes.empty() || !hasShares)
    {
        refuse(line_, fmt::format("column {}; {}",
                                  sizes.empty() ? "1 must be radius or diameter"
                                                : "2 must be share, cumulative or passing",
                                  kHeaderForm));
    }
    if (header_.by && by_ && (*header_.by == SharesOf::number) != (*by_ == SharesOf::number))
    {
        refuse(line_, "the header and --by do not agree on what the shares are shares of");
    }
}

double SizeFile::number(std::string_view text, const char* what) const
{
    text = trimmed(text);
    const auto value = readNumber<double>(text);
    if (!value || !std::isfinite(*value))
    {
        refuse(line_, fmt::format("'{}' must be a {}, a number", shown(text), what));
    }
    return *value;
}

void SizeFile::readRow(std::string_view text)
{
    const std::size_t middle = text.find(header_.separator);
    if (middle == std::string_view::npos ||
        text.find(header_.separator, middle + 1) != std::string_view::npos)
    {
        refuse(line_, fmt::format("'{}' must be two numbers, a size and a share, separated by '{}'",
                                  shown(text), header_.separator));
    }
    const char* what = header_.isDiameter ? "diameter" : "radius";
    const double size = number(text.substr(0, middle), what);
    if (!(size >= kSmallestSize && size <= kLargestSize))
    {
        refuse(line_, fmt::format("the {} is {:g}, but it must be from {} to {}", what, size,
                                  kSmallestSize, kLargestSize));
    }
    const double share = number(text.substr(middle + 1), "share");
    if (share < 0 || share > kPercent * (1 + kOfTheWhole))
    {
        refuse(line_, fmt::format("the share is {:g}, but it must be from 0 to 1, or to 100 in per "
                                  "cent",
                                  share));
    }
    rows_.push_back({line_, header_.isDiameter ? size / 2 : size, share});
}

int SizeFile::power() const
{
    const std::optional<SharesOf> by = by_ ? by_ : header_.by;
    if (!by)
    {
        refuse(headerLine_, "the header does not say whether shares are of number, mass or volume; "
                            "give --by, or write it there, as in 'radius,mass share'");
    }
    return *by == SharesOf::number ? SizeCurve::kNumber : SizeCurve::kMass;
}

// Tables of sieves often begin with the coarsest.
void SizeFile::order()
{
    if (rows_.size() > 1 && rows_.front().radius > rows_.back().radius)
    {
        std::reverse(rows_.begin(), rows_.end());
    }
    for (std::size_t k = 1; k < rows_.size(); ++k)
    {
        const Row& below = rows_[k - 1];
        const Row& row = rows_[k];
        if (row.radius < below.radius)
        {
            refuse(std::max(row.line, below.line), "sizes must all ascend, or all descend");
        }
        if (row.radius == below.radius && !header_.isCumulative)
        {
            refuse(std::max(row.line, below.line),
                   fmt::format("this size is there already, in line {}",
                               std::min(row.line, below.line)));
        }
        if (row.share < below.share && header_.isCumulative)
        {
            refuse(row.line, fmt::format("the curve falls: up to this size there is a share of "
                                         "{:g}, but up to the smaller one in line {} of {:g}",
                                         row.share, below.line, below.share));
        }
    }
    const double ratio = rows_.back().radius / rows_.front().radius;
    if (!(ratio <= kLargestSizeRatio))
    {
        refuse(rows_.back().line, fmt::format("the largest size is {:.4g} times the smallest one; "
                                              "at most {} can be",
                                              ratio, kLargestSizeRatio));
    }
}

/// 1 or 100, which the sum is near to.
double SizeFile::whole(double sum, const char* what) const
{
    for (const double all : {1.0, kPercent})
    {
        if (std::abs(sum - all) <= kOfTheWhole * all)
        {
            return sum;
        }
    }
    refuse(rows_.back().line, fmt::format("{} {:.6g}, but must {} 1, or 100 in per cent", what, sum,
                                          header_.isCumulative ? "end with" : "add up to"));
}

std::vector<SizeCurve::Piece> SizeFile::ofShares() const
{
    double sum = 0;
    for (const Row& row : rows_)
    {
        sum += row.share;
    }
    const double all = whole(sum, "the shares add up to");
    std::vector<SizeCurve::Piece> pieces;
    for (const Row& row : rows_)
    {
        if (row.share > 0)
        {
            pieces.push_back({row.radius, row.radius, row.share / all});
        }
    }
    return pieces;
}

std::vector<SizeCurve::Piece> SizeFile::ofCurve() const
{
    if (rows_.front().share != 0)
    {
        refuse(rows_.front().line,
               fmt::format("the curve begins with {:g}, but must begin with 0: add a row for the "
                           "smallest size, or this size with 0",
                           rows_.front().share));
    }
    const double all = whole(rows_.back().share, "the curve ends with");
    std::vector<SizeCurve::Piece> pieces;
    for (std::size_t k = 1; k < rows_.size(); ++k)
    {
        if (rows_[k].share > rows_[k - 1].share)
        {
            pieces.push_back({rows_[k - 1].radius, rows_[k].radius,
                              (rows_[k].share - rows_[k - 1].share) / all});
        }
    }
    return pieces;
}

// Those of the file. A curve of few rows is also looked at between them, where it is a line.
std::vector<double> SizeFile::sieves() const
{
    const std::size_t steps = std::max<std::size_t>(1, rows_.size() - 1);
    const std::size_t parts = header_.isCumulative ? (kFewestSieves + steps - 1) / steps : 1;
    std::vector<double> radii = {rows_.front().radius};
    for (const Row& row : rows_)
    {
        const double from = radii.back();
        for (std::size_t k = 1; k <= parts && row.radius > from; ++k)
        {
            const double share = static_cast<double>(k) / static_cast<double>(parts);
            radii.push_back(k == parts ? row.radius : from + share * (row.radius - from));
        }
    }
    return radii;
}

SizeCurve SizeFile::read()
{
    std::ifstream in(file_);
    if (!std::filesystem::is_regular_file(file_) || !in)
    {
        throw Error(ErrorCode::inputMissing,
                    fmt::format("cannot read the sizes {}: the file does not exist or is not "
                                "readable",
                                file_));
    }
    std::string text;
    while (std::getline(in, text))
    {
        constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
        std::string_view line = text;
        if (++line_ == 1 && line.starts_with(kByteOrderMark))
        {
            line.remove_prefix(kByteOrderMark.size());
        }
        line = trimmed(line.substr(0, line.find('#')));
        if (!line.empty())
        {
            headerLine_ == 0 ? readHeader(line) : readRow(line);
        }
    }
    if (headerLine_ == 0)
    {
        throw Error(ErrorCode::badData, fmt::format("{} is empty: {}", file_, kHeaderForm));
    }
    if (rows_.empty())
    {
        refuse(line_, "there is no row below the header: write a size and a share in each");
    }
    const int power = this->power();
    order();
    auto pieces = header_.isCumulative ? ofCurve() : ofShares();
    return {std::move(pieces), power, sieves()};
}

} // namespace

SizeCurve readSizeCurve(const SizeSettings& sizes)
{
    if (!isNamedSizes(*sizes.curve))
    {
        return SizeFile(*sizes.curve, sizes.by).read();
    }
    if (!sizes.by)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("spheres.sizes (--sizes) is '{}': say with spheres.by (--by) "
                                "whether that is its distribution by number, mass or volume",
                                *sizes.curve));
    }
    return namedSizes(*sizes.curve,
                      *sizes.by == SharesOf::number ? SizeCurve::kNumber : SizeCurve::kMass);
}

} // namespace frostfill
