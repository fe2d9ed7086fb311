// Units as powers of metre, second and kilogram.
#pragma once
#include <array>
#include <map>
#include <regex>
#include <stdexcept>
#include <string>

namespace pliant::test {

// The power of a base unit, 'm', 's' or 'k' (kg), in a unit such as "N s/m" or "m²/s²". What is behind a slash divides.
inline int power_of(char base, const std::string& unit) {
    struct Powers {
        int m, s, k;
    };
    static const std::map<std::string, Powers> known{
        {"m", {1, 0, 0}},  {"s", {0, 1, 0}},   {"kg", {0, 0, 1}},  {"N", {1, -2, 1}}, {"Pa", {-1, -2, 1}}, {"J", {2, -2, 1}},
        {"W", {2, -3, 1}}, {"Hz", {0, -1, 0}}, {"rad", {0, 0, 0}}, {"°", {0, 0, 0}},  {"1", {0, 0, 0}}};
    static const std::regex factor(R"(([A-Za-z]+|°|1)(²|³)?)");
    const auto slash = unit.find('/');
    int power = 0;
    for (std::sregex_iterator f(unit.begin(), unit.end(), factor), end; f != end; ++f) {
        const auto found = known.find(f->str(1));
        if (found == known.end()) throw std::runtime_error("no unit is called " + f->str(1));
        const Powers& p = found->second;
        const int once = base == 'm' ? p.m : base == 's' ? p.s : p.k, times = f->str(2) == "²" ? 2 : f->str(2) == "³" ? 3 : 1;
        const bool below = slash != std::string::npos && static_cast<std::size_t>(f->position()) > slash;
        power += (below ? -1 : 1) * once * times;
    }
    return power;
}

}  // namespace pliant::test
