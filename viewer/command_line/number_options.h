// Options that take a number, read as the lab and scene files read theirs.
#pragma once
#include <pliant/math/error.h>
#include <pliant/text/number_text.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace pliant::viewer {
namespace number_options {

template <class T>
struct Held {
    using type = T;
};
template <class T>
struct Held<std::optional<T>> {
    using type = T;
};

template <class T>
T whole_from(const std::string& name, const std::string& text) {
    const auto value = whole_number(text);
    if (!value) throw Refused(fmt::format("{} {} is not a whole number: give one such as 100", name, text));
    if (!std::in_range<T>(*value))
        throw Refused(
            fmt::format("{} {} is too large: give a whole number of at most {}", name, text, std::numeric_limits<T>::max()));
    return static_cast<T>(*value);
}

template <class T>
T real_from(const std::string& name, const std::string& text) {
    const NumberText read = read_number(text);
    if (!read.good()) throw Refused(fmt::format("{} {} is not a number: give one such as 0.5", name, text));
    return static_cast<T>(read.value);
}

}  // namespace number_options

// Into a number, or an optional one: whole where the type is.
template <class T>
CLI::Option* add_number(CLI::App& command, const std::string& name, T& target, const std::string& help) {
    using Type = typename number_options::Held<T>::type;
    const auto read = [&target, name](const std::string& text) {
        if constexpr (std::is_integral_v<Type>)
            target = number_options::whole_from<Type>(name, text);
        else
            target = number_options::real_from<Type>(name, text);
    };
    CLI::Option* option = command.add_option_function<std::string>(name, read, help);
    option->type_name(std::is_integral_v<Type> ? "INT" : "FLOAT");
    return option;
}

}  // namespace pliant::viewer
