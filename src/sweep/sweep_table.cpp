// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"
#include "output/column_text.hpp"

#include <frostfill/sweep.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

using Json = nlohmann::ordered_json;

/// Numbers, words and truth values under their whole names, "error.packing_fraction".
void flatten(const Json& json, const std::string& prefix, Json& row)
{
    for (const auto& [key, value] : json.items())
    {
        const std::string name = prefix + key;
        if (prefix.empty() && (key == "scene" || key == "machine"))
        {
            continue;
        }
        if (value.is_object())
        {
            flatten(value, name + ".", row);
        }
        else if (!value.is_array())
        {
            row[name] = value;
        }
    }
}

Json rowOf(const SweepRun& run, const RunReport& report, const std::filesystem::path& folder)
{
    Json row = {{"run", run.name},
                {"status", statusName(report.status)},
                {"exit_code", report.exitCode},
                {"message", report.message}};
    for (const auto& [key, value] : run.swept)
    {
        row["scene." + key] = value; // a summary has other things under the same keys
    }
    // A summary of a run that is not done is of another run, or of half of this one.
    if (report.status == RunStatus::done)
    {
        std::ifstream in(folder / "summary.json");
        if (const Json summary = Json::parse(in, nullptr, false); summary.is_object())
        {
            flatten(summary, "", row);
        }
    }
    return row;
}

std::string cellOf(const Json& value)
{
    if (value.is_null())
    {
        return "";
    }
    return csvCell(value.is_string() ? value.get<std::string>()
                                     : value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// Runs that ended differently have different columns: all of them, as they first appear.
std::vector<std::string> columnsOf(const Json& rows)
{
    std::vector<std::string> columns;
    for (const Json& row : rows)
    {
        for (const auto& [key, value] : row.items())
        {
            if (std::find(columns.begin(), columns.end(), key) == columns.end())
            {
                columns.push_back(key);
            }
        }
    }
    return columns;
}

std::string csvText(const Json& rows)
{
    const std::vector<std::string> columns = columnsOf(rows);
    std::string text;
    for (const std::string& column : columns)
    {
        text += text.empty() ? "" : ",";
        text += csvCell(column);
    }
    for (const Json& row : rows)
    {
        text += "\n";
        for (std::size_t i = 0; i < columns.size(); ++i)
        {
            text += i == 0 ? "" : ",";
            text += cellOf(row.contains(columns[i]) ? row[columns[i]] : Json());
        }
    }
    return text + "\n";
}

void save(const std::filesystem::path& file, const std::string& text)
{
    AtomicFile out(file);
    out.write(text);
    out.commit();
}

} // namespace

void writeSweepTable(const SweepRequest& request, const std::vector<RunReport>& reports)
{
    Json rows = Json::array();
    for (std::size_t k = 0; k < request.runs.size(); ++k)
    {
        rows.push_back(
            rowOf(request.runs[k], reports.at(k), request.directory / request.runs[k].name));
    }
    createDirectory(request.directory);
    save(request.directory / "table.csv", csvText(rows));
    save(request.directory / "table.json",
         rows.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

} // namespace frostfill
