// Command lines of the tools: long options, --help, and one clear line for everything that is wrong.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mixed_palletizing::adapters {

/// Declares a tool's options, then runs it:
///
///   CommandLine line("pack", "Packs the orders of a file.");
///   line.required("instances", &path, "orders, one JSON object a line");
///   line.option("seed", &seed, "of every random choice");           // the value now is the default shown
///   return line.run(argc, argv, [&] { ...; return 0; });
///
/// T is int, std::int64_t, std::uint64_t, double, std::string, or std::vector of one of them (several words).
/// Abbreviated names are not accepted. Boost.Program_options does the parsing: it is on every distribution
/// that has ROS Noetic.
class CommandLine {
 public:
  CommandLine(const std::string& name, const std::string& description);
  ~CommandLine();

  template <typename T>
  void required(const std::string& name, T* value, const std::string& help);
  template <typename T>
  void option(const std::string& name, T* value, const std::string& help);
  void flag(const std::string& name, bool* value, const std::string& help);

  /// An option whose word must be one of `choices`; the help lists them.
  void choice(const std::string& name, std::string* value, const std::vector<std::string>& choices,
              const std::string& help);

  /// Whether the user gave the option; after parsing.
  bool given(const std::string& name) const;

  /// Parses, then runs `body` and answers its exit code. 0 after --help; 2 for a wrong command line; 1 when
  /// the body throws, with "name: message" as one line on stderr.
  int run(int argc, const char* const* argv, const std::function<int()>& body);

 private:
  std::optional<int> parse(int argc, const char* const* argv);
  void requireChoices() const;

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mixed_palletizing::adapters
