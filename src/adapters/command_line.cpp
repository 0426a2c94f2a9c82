#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include <boost/program_options.hpp>

#include <mixed_palletizing/adapters/command_line.hpp>

namespace mixed_palletizing::adapters {
namespace po = boost::program_options;
namespace {

struct Choice {
  std::string option;
  const std::string* value;
  std::vector<std::string> words;
};

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// Shortest text that reads as the value, for the help.
template <typename T>
std::string defaultText(const T& value) {
  std::ostringstream stream;
  stream << value;
  return stream.str();
}

template <typename T>
std::string defaultText(const std::vector<T>& values) {
  std::string text;
  for (const T& value : values) text += (text.empty() ? "" : " ") + defaultText(value);
  return text;
}

template <typename T>
po::typed_value<T>* several(po::typed_value<T>* value, const std::vector<typename T::value_type>*) {
  return value->multitoken();
}

template <typename T>
po::typed_value<T>* several(po::typed_value<T>* value, const void*) {
  return value;
}

/// One line whatever the message holds.
std::string oneLine(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ';');
  return text;
}

/// boost would read "-1" for an unsigned value as 2^64 - 1.
void refuseNegativeUnsigned(const std::string& name, const po::parsed_options& parsed) {
  for (const auto& option : parsed.options) {
    if (option.string_key == name && !option.value.empty() && option.value.front().rfind('-', 0) == 0) {
      throw std::invalid_argument("--" + name + " must not be negative, got " + option.value.front());
    }
  }
}

}  // namespace

struct CommandLine::Impl {
  std::string name;
  std::string description;
  po::options_description options;
  po::variables_map values;
  std::vector<std::string> required;
  std::vector<Choice> choices;
  std::vector<std::string> unsigned_options;
  std::vector<std::pair<std::string, const double*>> doubles;

  /// Remembers the options whose values boost reads too generously.
  template <typename T>
  void watch(const std::string& option, const T* value) {
    if constexpr (std::is_same_v<T, std::uint64_t>) unsigned_options.push_back(option);
    if constexpr (std::is_same_v<T, double>) doubles.emplace_back(option, value);
  }
};

CommandLine::CommandLine(const std::string& name, const std::string& description)
    : impl_(new Impl{name, description, po::options_description("options", 110), {}, {}, {}, {}, {}}) {
  impl_->options.add_options()("help", "show this text");
}

CommandLine::~CommandLine() = default;

template <typename T>
void CommandLine::required(const std::string& name, T* value, const std::string& help) {
  impl_->required.push_back(name);
  impl_->watch(name, value);
  impl_->options.add_options()(name.c_str(), several(po::value<T>(value), value),
                               (help + " (required)").c_str());
}

template <typename T>
void CommandLine::option(const std::string& name, T* value, const std::string& help) {
  impl_->watch(name, value);
  const std::string text = defaultText(*value);
  impl_->options.add_options()(name.c_str(), several(po::value<T>(value), value),
                               (text.empty() ? help : help + " (default: " + text + ")").c_str());
}

void CommandLine::flag(const std::string& name, bool* value, const std::string& help) {
  impl_->options.add_options()(name.c_str(), po::bool_switch(value), help.c_str());
}

void CommandLine::choice(const std::string& name, std::string* value, const std::vector<std::string>& choices,
                         const std::string& help) {
  impl_->choices.push_back({name, value, choices});
  option(name, value, help + ": " + joined(choices, ", "));
}

bool CommandLine::given(const std::string& name) const {
  return impl_->values.count(name) > 0 && !impl_->values[name].defaulted();
}

void CommandLine::requireChoices() const {
  for (const Choice& choice : impl_->choices) {
    if (std::find(choice.words.begin(), choice.words.end(), *choice.value) == choice.words.end()) {
      throw std::invalid_argument("--" + choice.option + " must be one of " + joined(choice.words, ", ") +
                                  ", got '" + *choice.value + "'");
    }
  }
  for (const auto& [name, value] : impl_->doubles) {
    if (!std::isfinite(*value)) throw std::invalid_argument("--" + name + " must be a finite number");
  }
}

std::optional<int> CommandLine::parse(int argc, const char* const* argv) {
  using namespace po::command_line_style;
  const int style = allow_long | long_allow_next | long_allow_adjacent;
  try {
    const po::parsed_options parsed =
        po::command_line_parser(argc, argv).options(impl_->options).positional({}).style(style).run();
    for (const std::string& name : impl_->unsigned_options) refuseNegativeUnsigned(name, parsed);
    po::store(parsed, impl_->values);
    if (impl_->values.count("help") > 0) {
      std::cout << impl_->name << ": " << impl_->description << "\n\n" << impl_->options;
      return 0;
    }
    for (const std::string& name : impl_->required) {
      if (impl_->values.count(name) == 0) throw std::invalid_argument("--" + name + " is required");
    }
    po::notify(impl_->values);
    requireChoices();
  } catch (const std::exception& error) {
    std::cerr << impl_->name << ": " << oneLine(error.what()) << " (--help shows the options)\n";
    return 2;
  }
  return std::nullopt;
}

int CommandLine::run(int argc, const char* const* argv, const std::function<int()>& body) {
  if (const std::optional<int> code = parse(argc, argv)) return *code;
  try {
    return body();
  } catch (const std::exception& error) {
    std::cerr << impl_->name << ": " << oneLine(error.what()) << '\n';
    return 1;
  }
}

#define INSTANTIATE(T)                                                                          \
  template void CommandLine::required(const std::string&, T*, const std::string&);              \
  template void CommandLine::option(const std::string&, T*, const std::string&);                \
  template void CommandLine::required(const std::string&, std::vector<T>*, const std::string&); \
  template void CommandLine::option(const std::string&, std::vector<T>*, const std::string&)
INSTANTIATE(int);
INSTANTIATE(std::int64_t);
INSTANTIATE(std::uint64_t);
INSTANTIATE(double);
INSTANTIATE(std::string);
#undef INSTANTIATE

}  // namespace mixed_palletizing::adapters
