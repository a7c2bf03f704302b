#include "bench/experiments/compare/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bench/contenders/direct_light.h"
#include "bench/contenders/row_facts.h"
#include "bench/setup/median.h"

namespace bench::compare {
namespace {

using Json = nlohmann::ordered_json;

/// Adds the median as NAME and [smallest, largest] as NAME_range.
void add_timing(Json& row, const std::string& name, const std::vector<double>& values) {
    row[name] = median(values);
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    row[name + "_range"] = {*low, *high};
}

template <class Item, class Value>
std::vector<double> each(const std::vector<Item>& items, Value value) {
    std::vector<double> values;
    for (const Item& item : items) values.push_back(value(item));
    return values;
}

double wall_seconds(const common::TraceReport& trace) {
    return trace.trace_seconds + trace.sink_seconds;
}

/// Computes the insertion time as the difference between runs with and without the store. This includes the
/// tracer's additional cache misses, which a clock around the store alone would not see.
void add_times(Json& row, const RowInput& in) {
    const auto& m = in.measurements;
    const auto queries = static_cast<double>(in.queries);
    add_timing(row, "trace_seconds", each(in.null_sink, wall_seconds));
    row["prepare_seconds"] = m.front().preparation.seconds;
    add_timing(row, "making_room_seconds", each(m, [](const auto& x) { return x.making_room_seconds; }));
    add_timing(row, "trace_and_insert_seconds", each(m, [](const auto& x) { return wall_seconds(x.trace); }));
    std::vector<double> ratios, insertions;
    for (std::size_t i = 0; i < m.size(); ++i) {
        const double with = wall_seconds(m[i].trace), without = wall_seconds(in.null_sink[i]);
        ratios.push_back(with / without);
        insertions.push_back(1e9 * (with - without) * in.threads / static_cast<double>(m[i].trace.hits));
    }
    add_timing(row, "ratio_to_null_sink", ratios);
    add_timing(row, "insert_ns_per_hit", insertions);
    add_timing(row, "build_seconds", each(m, [](const auto& x) { return x.build_seconds; }));
    add_timing(row, "gather_us_per_query",
               each(m, [&](const auto& x) { return 1e6 * x.gather_seconds / queries; }));
    add_timing(row, "gather_us_per_query_shuffled",
               each(m, [&](const auto& x) { return 1e6 * x.gather_shuffled_seconds / queries; }));
}

/// Adds the peak of the process and the part that this method added.
void add_peak(Json& row, const RowInput& in) {
    const auto bytes = [&](auto value) {
        return static_cast<std::size_t>(median(
            each(in.measurements, [&](const Measurement& m) { return static_cast<double>(value(m)); })));
    };
    row["peak_rss_bytes"] = bytes([](const Measurement& m) { return m.peak_resident_bytes; });
    if (in.measurements.front().peak_is_of_this_run)
        row["peak_growth_bytes"] = bytes([](const Measurement& m) {
            return m.peak_resident_bytes - std::min(m.resident_before_bytes, m.peak_resident_bytes);
        });
    else
        row["peak_rss_note"] = "since the process began: the system does not let it be reset";
}

std::string csv_cell(const Json& value) {
    return value.is_string() ? fmt::format("\"{}\"", value.get<std::string>()) : value.dump();
}

}  // namespace

Json make_row(const RowInput& in) {
    Json row = {{"scene", in.scene}};
    add_facts(row, in.method);
    row["hits_asked"] = in.hits_asked;
    row["seed"] = in.seed;
    row["threads"] = in.threads;
    add_run_facts(row, in.settings);
    row["fingerprint"] = in.fingerprint;
    row["needed_bytes"] = in.needed_bytes;
    row["max_memory_bytes"] = in.max_bytes;
    if (!in.skipped.empty()) {
        row["skipped"] = in.skipped;
        return row;
    }
    const Measurement& first = in.measurements.front();
    row["hits"] = first.trace.hits;
    row["photons_emitted"] = first.trace.fates.emitted;
    row["photons_missed"] = first.trace.fates.missed;
    row["photons_escaped"] = first.trace.fates.escaped;
    row["photons_given_up"] = first.trace.fates.given_up;
    row["hits_rejected"] = first.rejected.total();
    row["repetitions"] = in.measurements.size();
    row["queries"] = in.queries;
    if (in.texels > 0) {
        row["texels"] = in.texels;
        row["hits_per_texel"] = static_cast<double>(first.trace.hits) / static_cast<double>(in.texels);
    }
    add_times(row, in);
    row["prepare_bytes"] = first.preparation.bytes;
    row["bytes"] = first.bytes;
    row["insert_bytes"] = first.insert_bytes;
    add_peak(row, in);
    row["mean_irradiance"] = first.mean_irradiance;
    return row;
}

std::string rows_as_csv(const Json& rows) {
    std::vector<std::string> columns;
    for (const Json& row : rows)
        for (const auto& [key, value] : row.items())
            if (!value.is_structured() && std::find(columns.begin(), columns.end(), key) == columns.end())
                columns.push_back(key);
    std::string text;
    for (std::size_t c = 0; c < columns.size(); ++c) text += (c > 0 ? "," : "") + columns[c];
    text += "\n";
    for (const Json& row : rows) {
        for (std::size_t c = 0; c < columns.size(); ++c) {
            if (c > 0) text += ",";
            if (row.contains(columns[c])) text += csv_cell(row[columns[c]]);
        }
        text += "\n";
    }
    return text;
}

std::string rows_as_text(const Json& rows) {
    std::string text =
        fmt::format("{:<10} {:<36} {:>9} {:>9} {:>9} {:>8} {:>9} {:>9} {:>10}\n", "scene", "method", "hits",
                    "trace s", "insert ns", "build s", "gather us", "shuffled", "MiB");
    for (const Json& row : rows) {
        const std::string name =
            fmt::format("{:<10} {:<36} ", row["scene"].get<std::string>(), row["method"].get<std::string>());
        if (row.contains("skipped"))
            text += name + fmt::format("{:>9.3g} skipped: {}\n", row["hits_asked"].get<double>(),
                                       row["skipped"].get<std::string>());
        else
            text +=
                name + fmt::format("{:>9.3g} {:>9.3g} {:>9.1f} {:>8.3g} {:>9.2f} {:>9.2f} {:>10.1f}\n",
                                   row["hits"].get<double>(), row["trace_seconds"].get<double>(),
                                   row["insert_ns_per_hit"].get<double>(), row["build_seconds"].get<double>(),
                                   row["gather_us_per_query"].get<double>(),
                                   row["gather_us_per_query_shuffled"].get<double>(),
                                   row["bytes"].get<double>() * 0x1p-20);
    }
    return text;
}

}  // namespace bench::compare
