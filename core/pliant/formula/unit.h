// Units of quantities: what a formula gives follows from the units of what is put in.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pliant {

// A product of powers of SI base units. Radians and counts ("cells", "steps") are numbers; degrees are a unit of their own, which
// sine and its like take.
class Unit {
public:
    enum Base { metre, kilogram, second, kelvin, degree };
    static constexpr std::size_t bases = 5;

    Unit() = default;  // of a number
    // "N/m", "kg m²/s²", "1/(m s)", "°", "cells"; "" for a number. Throws Refused for a name that is none.
    explicit Unit(std::string_view text);

    bool is_number() const { return *this == Unit(); }
    friend bool operator==(const Unit&, const Unit&) = default;
    friend Unit operator*(const Unit& a, const Unit& b);
    friend Unit operator/(const Unit& a, const Unit& b);
    // Raised to numerator/denominator. Empty where a power of a base would be no multiple of 1/12.
    std::optional<Unit> power(int numerator, int denominator = 1) const;

    // "kg m²/s²", in base units; "1" for a number.
    std::string text() const;
    // As people write it, "N/m" for kg/s²; "" for a number.
    std::string usual_text() const;

private:
    static constexpr int whole = 12;            // a power of 1
    std::array<std::int16_t, bases> powers_{};  // in parts of 1/12

    Unit& multiply(const Unit& other, int times);  // by its power
    friend class UnitReader;
};

// Whether Unit can read it.
bool is_unit(std::string_view text);
// The same with a prefix before it, "mm/s", "kPa", as quantities are written.
bool is_prefixed_unit(std::string_view text);

}  // namespace pliant
