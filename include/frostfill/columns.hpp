// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace frostfill
{

// The quantities of a sphere, each declared once: name, type, unit, when it changes, where it goes.
// Capture, run file, page, tables, exports, Python, import and colours take theirs from here.

struct SphereRecord;
struct SphereRow;

enum class ColumnType : std::uint8_t
{
    uint8,
    uint32,
    float32,
    float64,
};

/// When the value of a sphere may change. A run file and a page store it then, and at no other
/// time.
enum class ColumnChanges : std::uint8_t
{
    never,   ///< it is known when the sphere appears
    atRest,  ///< when the sphere, or another one beside it, comes to rest or wakes
    running, ///< with every step of a running sphere
};

/// Which spheres a column says something of. It is 0 for the others, and where it gives spheres
/// their colours the others keep those of their states.
enum class ColumnOf : std::uint8_t
{
    all,
    running,
    resting,
};

/// Sources of the ends of a column's scale of colours.
enum class ColumnScale : std::uint8_t
{
    own,    ///< `low` and `high`
    groups, ///< the groups of the run
    sets,   ///< the sets of the run
    fall,   ///< the speeds of a fall through the object
    height, ///< the heights of the object
    depth,  ///< 0 and half of the object's smallest side
    radii,  ///< the radii of the run
};

/// A quantity of a sphere.
struct Column
{
    std::string name = {};   ///< a word in lower case: head of the column, choice of --color-by
    std::string plural = {}; ///< its array in NumPy's files and in Python
    std::string title = {};  ///< beside a scale of colours
    std::string unit = {};   ///< "mesh unit", "mesh unit/s"; empty for a plain number
    std::string frame = {};  ///< of a coordinate: "mesh", in tables of a moved object the world
    std::string help = {};   ///< what it is, in a sentence without a full stop
    ColumnType type = ColumnType::float32;
    ColumnChanges changes = ColumnChanges::atRest;
    ColumnOf of = ColumnOf::all;
    int digits = 0;   ///< binary ones of a float that are kept behind the first; 0: all
    double low = 0;   ///< both ends of its scale of colours
    double high = 1;  ///< likewise
    bool file = true; ///< in spheres.csv
    bool exported = true;
    bool python = true;      ///< an array of a state in Python
    bool colour = true;      ///< a choice of --color-by
    bool onRequest = false;  ///< it takes long: carried only where it is asked for
    std::string partOf = {}; ///< name of what several columns are together, to ask for all of them
    /// Found of all spheres at rest together, as `analyse` does, for each picture and each exported
    /// frame that asks for it: no run keeps it, see analysis/measured_columns.hpp. Not a number
    /// where a sphere has none.
    bool measured = false;
    ColumnScale scale = ColumnScale::own;

    /// Its value, of a column that each state has in a field of its own: of all built-in ones but
    /// `contacts`, `unbalance` and measured ones. Null for a column that a snapshot carries, see
    /// ColumnValues.
    double (*fixed)(const SphereRow& row) = nullptr;
    /// Computes a carried value from what the sphere has. Null for a column that only the
    /// simulation knows, see simulation/columns.
    std::function<double(std::uint32_t id, const SphereRecord& sphere)> compute = nullptr;

    [[nodiscard]] bool isCarried() const { return fixed == nullptr; }
    [[nodiscard]] bool isWhole() const
    {
        return type == ColumnType::uint8 || type == ColumnType::uint32;
    }
};

/// What the columns qx, qy, qz and qw are part of.
inline constexpr const char* kOrientation = "orientation";

/// All columns in the order of tables: those built in, then those added. A column stays where it is
/// in memory.
[[nodiscard]] const std::deque<Column>& columns();

/// Null if there is none.
[[nodiscard]] const Column* findColumn(std::string_view name);

/// The names of those that may give spheres their colours.
[[nodiscard]] std::vector<std::string> colourColumns();

/// The names of those that are measured.
[[nodiscard]] std::vector<std::string> measuredNames();

/// Adds a carried column, of type uint32 or float32, before the first simulation and from one
/// thread. Throws Error usage for a name that is taken or no word, or for another type.
const Column& addColumn(Column column);

/// The values of a carried column, in the 32 bits that files have them in.
class ColumnValues
{
public:
    explicit ColumnValues(const Column& column) : column_(&column) {}

    [[nodiscard]] const Column& column() const { return *column_; }
    /// 0 beyond the end.
    [[nodiscard]] double at(std::size_t sphere) const;
    /// Whether the value was another one before. The sphere is there.
    bool set(std::size_t sphere, double value);

    std::vector<std::uint32_t> bits; ///< [#S] of uint32 or float32

private:
    const Column* column_;
};

/// One of each carried column, without values; of those on request only those that are asked for,
/// by their names or by what they are part of; none that is measured.
[[nodiscard]] std::vector<ColumnValues> carriedColumns(std::span<const std::string> asked = {});

/// Null if the column is not among them.
[[nodiscard]] const ColumnValues* findValues(std::span<const ColumnValues> values,
                                             const Column& column);

} // namespace frostfill
#pragma GCC visibility pop
