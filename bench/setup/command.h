// Commands of the program and their options. Only one file includes CLI11, to save compile time.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace bench {

enum class Need { optional, required };

/// A command whose options are being declared. A name that begins with a letter is a positional argument. A
/// variable's present value is its default, which the help shows; variables must outlive the command.
class Command {
  public:
    explicit Command(CLI::App& app) : app_(&app) {}

    void option(const std::string& name, std::string& value, const std::string& help,
                Need need = Need::optional);
    /// Accepts any number of texts.
    void option(const std::string& name, std::vector<std::string>& values, const std::string& help,
                Need need = Need::optional);
    void flag(const std::string& name, bool& value, const std::string& help);

    // Numbers are parsed as in numbers.h. The command itself checks their bounds.
    void whole_number(const std::string& name, std::uint64_t& value, const std::string& help);
    void whole_number(const std::string& name, int& value, const std::string& help);
    void number(const std::string& name, double& value, const std::string& help);
    void number(const std::string& name, std::optional<double>& value, const std::string& help);

  private:
    CLI::App* app_;
};

struct CommandEntry {
    std::string name, purpose;
    /// Declares the options, and returns the function to call once they are parsed.
    std::function<std::function<void()>(Command&)> add_to;
};

/// Registers a command until the program ends. The file of each command has one of these.
class RegisteredCommand {
  public:
    /// `place`: its unique position in the help.
    RegisteredCommand(int place, CommandEntry entry);
};

/// Parses the command line and runs the command. Returns 0, or 2 after a message if the line is invalid.
/// Passes on what the command throws.
[[nodiscard]] int run_command(int argc, char** argv, const std::function<void(const std::string&)>& complain);

}  // namespace bench
