#include "bench/setup/command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <limits>
#include <map>

#include "bench/setup/numbers.h"
#include "bench/setup/register_once.h"

namespace bench {
namespace {

constexpr int bad_input = 2;

std::map<int, CommandEntry>& entries() {
    static std::map<int, CommandEntry> all;
    return all;
}

template <class Value>
void add_text(CLI::App& app, const std::string& name, Value& value, const std::string& help, Need need) {
    CLI::Option* option = app.add_option(name, value, help);
    if (!value.empty()) option->capture_default_str();
    if (need == Need::required) option->required();
}

CLI::Option* add_read(CLI::App& app, const std::string& name, const std::string& help,
                      const std::function<void(const std::string&)>& read) {
    return app.add_option_function<std::string>(name, read, help);
}

template <class Whole>
void add_whole(CLI::App& app, const std::string& name, Whole& value, const std::string& help) {
    add_read(app, name, help,
             [name, &value](const std::string& text) {
                 value =
                     static_cast<Whole>(parse_whole_number(name, text, std::numeric_limits<Whole>::max()));
             })
        ->type_name("UINT")
        ->default_str(std::to_string(value));
}

/// An empty value is probably an unset variable of a script. To ask for nothing, one leaves the option out.
void refuse_empty_values(CLI::App& command) {
    const auto is_empty = [](const std::string& text) { return text.empty() ? "has no value" : ""; };
    for (CLI::Option* option : command.get_options())
        if (option->get_items_expected_max() > 0) option->check(is_empty);
}

}  // namespace

void Command::option(const std::string& name, std::string& value, const std::string& help, Need need) {
    add_text(*app_, name, value, help, need);
}

void Command::option(const std::string& name, std::vector<std::string>& values, const std::string& help,
                     Need need) {
    add_text(*app_, name, values, help, need);
}

void Command::flag(const std::string& name, bool& value, const std::string& help) {
    app_->add_flag(name, value, help);
}

void Command::whole_number(const std::string& name, std::uint64_t& value, const std::string& help) {
    add_whole(*app_, name, value, help);
}

void Command::whole_number(const std::string& name, int& value, const std::string& help) {
    add_whole(*app_, name, value, help);
}

void Command::number(const std::string& name, double& value, const std::string& help) {
    add_read(*app_, name, help, [name, &value](const std::string& text) { value = parse_number(name, text); })
        ->type_name("FLOAT")
        ->default_str(fmt::format("{}", value));
}

void Command::number(const std::string& name, std::optional<double>& value, const std::string& help) {
    add_read(*app_, name, help, [name, &value](const std::string& text) {
        value = parse_number(name, text);
    })->type_name("FLOAT");
}

RegisteredCommand::RegisteredCommand(int place, CommandEntry entry) {
    register_once(entries(), place, std::move(entry));
}

int run_command(int argc, char** argv, const std::function<void(const std::string&)>& complain) {
    CLI::App app(
        "Photon maps against spherical harmonic light maps: memory, speed and error, measured side by side");
    app.require_subcommand(1);
    for (const auto& [place, entry] : entries()) {
        CLI::App* const command = app.add_subcommand(entry.name, entry.purpose);
        Command options(*command);
        command->callback(entry.add_to(options));
        refuse_empty_values(*command);
    }
    try {
        app.parse(argc, argv);
        return 0;
    } catch (const CLI::Success& e) {
        return app.exit(e);
    } catch (const CLI::ParseError& e) {
        complain(e.what());
        return bad_input;
    }
}

}  // namespace bench
