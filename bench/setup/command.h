// Commands of the program, and their options. CLI11 is compiled with one file, not with each command.
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

/// One command while its options are named. Names that begin with a letter stand for arguments by their
/// place. What a value is at that time is its default, which the help shows; values outlive the command.
class Command {
  public:
    explicit Command(CLI::App& app) : app_(&app) {}

    void option(const std::string& name, std::string& value, const std::string& help,
                Need need = Need::optional);
    /// Of any number of texts.
    void option(const std::string& name, std::vector<std::string>& values, const std::string& help,
                Need need = Need::optional);
    void flag(const std::string& name, bool& value, const std::string& help);

    // Numbers are read as they are written (numbers.h). Bounds are the command's own to check.
    void whole_number(const std::string& name, std::uint64_t& value, const std::string& help);
    void whole_number(const std::string& name, int& value, const std::string& help);
    void number(const std::string& name, double& value, const std::string& help);
    void number(const std::string& name, std::optional<double>& value, const std::string& help);

  private:
    CLI::App* app_;
};

struct CommandEntry {
    std::string name, purpose;
    /// Names the options, and gives what is to be done once they are read.
    std::function<std::function<void()>(Command&)> add_to;
};

/// Adds a command for as long as the program runs: each has one of these in its file.
class RegisteredCommand {
  public:
    /// `place`: where it stands in the help, each its own.
    RegisteredCommand(int place, CommandEntry entry);
};

/// Reads the command line and does what it says. Exit code: 0; 2 where the line means nothing, after saying
/// so. Throws what the command throws.
[[nodiscard]] int run_command(int argc, char** argv, const std::function<void(const std::string&)>& complain);

}  // namespace bench
