// Lists the methods and explains their names.
#include <fmt/format.h>

#include "bench/contenders/family.h"
#include "bench/contenders/row_facts.h"
#include "bench/setup/command.h"
#include "common/core/standard_streams.h"

namespace bench {
namespace {

using Json = nlohmann::ordered_json;

struct MethodsOptions {
    std::vector<std::string> names;
    bool json = false;
};

Json as_json(const Contender& contender) {
    Json row;
    add_facts(row, contender);
    row["store"] = contender->store_key();
    return row;
}

/// Returns those named, or one of each kind.
std::vector<Contender> contenders_of(const std::vector<std::string>& names) {
    if (!names.empty()) return parse_contenders("methods", names);
    std::vector<Contender> all;
    for (const auto& [name, family] : all_families())
        for (Contender& contender : parse_contenders("methods", family.names()))
            all.push_back(std::move(contender));
    return all;
}

Json families_as_json() {
    Json all = Json::object();
    for (const auto& [name, family] : all_families()) {
        Json fields = Json::array();
        for (const NameField& field : family.fields())
            fields.push_back({{"key", field.key}, {"form", field.form}, {"meaning", field.meaning}});
        all[name] = {{"purpose", family.purpose}, {"fields", fields}};
    }
    return all;
}

void print_text(const std::vector<Contender>& contenders, bool with_grammar) {
    for (const auto& [name, family] : all_families()) {
        if (!with_grammar) break;
        std::string parts;
        for (const NameField& field : family.fields()) parts += " / " + field.key;
        common::print_result(fmt::format("{}{}: {}\n", name, parts, family.purpose));
        for (const NameField& field : family.fields())
            common::print_result(
                fmt::format("  {:<10} {}\n{:13}{}\n", field.key, field.meaning, "", field.form));
        common::print_result("\n");
    }
    for (const Contender& contender : contenders)
        common::print_result(fmt::format("{:<36} {} {}\n", contender.name, contender->style().colour,
                                         contender->style().marker));
}

void run(const MethodsOptions& options) {
    const std::vector<Contender> contenders = contenders_of(options.names);
    if (!options.json) {
        print_text(contenders, options.names.empty());
        return;
    }
    Json all = Json::array();
    for (const Contender& contender : contenders) all.push_back(as_json(contender));
    common::print_result(Json{{"families", families_as_json()}, {"methods", all}}.dump(2) + "\n");
}

const RegisteredCommand registered(
    13, {.name = "methods",
         .purpose = "Say which methods there are, and what the parts of their names mean",
         .add_to = [](Command& command) -> std::function<void()> {
             const auto options = std::make_shared<MethodsOptions>();
             command.option("NAME", options->names, "Methods; one of each kind where none is named");
             command.flag("--json", options->json, "Print JSON");
             return [options] { run(*options); };
         }});

}  // namespace
}  // namespace bench
