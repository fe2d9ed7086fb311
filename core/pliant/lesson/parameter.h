// A parameter is declared once, as a member of its lesson, and joins that lesson by itself. Sliders, command-line flags, scene
// files, documentation and tests all follow from the declaration.
#pragma once
#include <pliant/math/error.h>
#include <pliant/math/types.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pliant {

class Lesson;

enum class Kind { number, whole, choice, toggle, file };
enum class Scale { linear, log };  // of the slider
// live: from the next step on; rebuild: the lesson starts again; look: it chooses what is shown, at once, and the run is the
// same.
enum class Effect { live, rebuild, look };

std::string_view name_of(Effect effect);  // "live", "rebuild", "look"

// What of a scene a parameter belongs to. The lab shows each group under a heading of its own, in this order.
enum class Group {
    scene,     // what happens
    method,    // how it is computed, and in which steps
    material,  // what it consists of
    forces,    // what acts on it: loads, contact, drives
    start,     // its state at the start
    shape,     // its sizes, and the cells or nodes that it is divided into
    solver,    // iterations and tolerances of what solves equations
    view       // what is drawn or pulled, of no effect on the rest
};
inline constexpr std::array all_groups{Group::scene, Group::method, Group::material, Group::forces,
                                       Group::start, Group::shape,  Group::solver,   Group::view};
std::string_view key_of(Group group);   // "forces", in files
std::string_view name_of(Group group);  // "Forces and contact", on the screen

struct Interval {
    Real min = 0, max = 1;
    bool open_min = false, open_max = false;  // open: the end itself is not accepted
    bool contains(Real value) const;
    std::string text() const;  // "(-1, 0.5)", "[0, 10]"
    bool operator==(const Interval&) const = default;
};

// One of the values of a choice: its key in scene files and its name on the screen.
struct Option {
    std::string_view key, label;
};

struct ParameterInfo {
    std::string_view key, symbol = "", unit = "", help = "";
    Real initial = 0;
    Interval useful{};                   // what the slider spans
    std::optional<Interval> accepted{};  // what the solver accepts; `useful` when not given
    Scale scale = Scale::linear;
    Effect effect = Effect::live;
    std::function<bool()> used{};  // does the present scene use it? always, when empty
    Kind kind = Kind::number;
    std::vector<Option> options{};
    Group group = Group::scene;
    std::string_view formerly = "";           // the key that it had in older scenes, which still open
    std::vector<std::string_view> endings{};  // of a file: ".msh"
    // Keys and values that a person sets with it by choosing it in the lab: a file that is chosen, or dropped, is to be used.
    std::vector<std::pair<std::string_view, std::string_view>> companions{};

    bool is_number() const { return kind == Kind::number || kind == Kind::whole; }
    bool has_options() const { return kind == Kind::choice || kind == Kind::toggle; }

    // For declarations of a line or two: quantity(…).log().accepts({1e-6, 1e6}).rebuilds().when([this] { return hangs(); })
    ParameterInfo log() const;
    ParameterInfo in(Group belongs_to) const;
    ParameterInfo once(std::string_view key_before) const;
    bool is_called(std::string_view name) const { return name == key || (!formerly.empty() && name == formerly); }
    ParameterInfo accepts(Interval interval) const;
    ParameterInfo rebuilds() const;
    ParameterInfo looks() const;
    ParameterInfo when(std::function<bool()> uses) const;
    ParameterInfo with(std::string_view companion, std::string_view value) const;
};

// A number with its unit: where it starts, what its slider spans, what it means.
ParameterInfo quantity(std::string_view key, std::string_view symbol, std::string_view unit, Real initial, Interval useful,
                       std::string_view help);
// The same with what the solver accepts; its slider linear, or logarithmic.
ParameterInfo quantity(std::string_view key, std::string_view symbol, std::string_view unit, Real initial, Interval useful,
                       Interval accepted, std::string_view help);
ParameterInfo log_quantity(std::string_view key, std::string_view symbol, std::string_view unit, Real initial, Interval useful,
                           Interval accepted, std::string_view help);
// A choice or a switch; initial: the option that it starts with, 0 or 1.
template <class Initial = int>
ParameterInfo setting_of(std::string_view key, std::string_view help, Initial initial = {}) {
    return {.key = key, .help = help, .initial = static_cast<Real>(static_cast<int>(initial))};
}

// A file that the lesson reads, of one of these endings (".msh", in small letters); none at first. Another one begins the run
// anew.
ParameterInfo file_of(std::string_view key, std::string_view help, std::vector<std::string_view> endings);

class Parameter {
public:
    Parameter(Lesson& owner, ParameterInfo info, std::function<bool()> used = {});
    Parameter(const Parameter&) = delete;
    Parameter& operator=(const Parameter&) = delete;

    const ParameterInfo info;

    bool looks() const { return info.effect == Effect::look; }

    // A choice counts its options from 0; a switch is 0 or 1; a file is its number (stored_file.h), 0 for none.
    Real value() const { return value_; }
    bool used() const { return !info.used || info.used(); }
    const Interval& accepted() const { return info.accepted ? *info.accepted : info.useful; }

    // Throws Refused, naming key, value, unit and accepted range, unless the value is finite, in range and, for a whole number,
    // a choice or a switch, whole. The value is then unchanged.
    void set(Real value);
    void check(Real value) const;

    // From text as a person writes it: a number, "true/false/on/off", the key of an option, or the path or name of a file. A
    // number without a unit of its own is in `unit_if_none`, the parameter's own unit or one that differs from it by a prefix; by
    // default its own. Throws Refused.
    Real parse(std::string_view text, std::string_view unit_if_none = "") const;
    // As parse reads it back, to the bit.
    std::string text() const { return text(value_); }
    std::string text(Real value) const;

    std::string_view option_key() const { return info.options[static_cast<std::size_t>(value_)].key; }

private:
    Real value_;
};

// A real number. used: does the present scene use it? As its declaration says, when empty; the same of all others.
class Number : public Parameter {
public:
    Number(Lesson& owner, ParameterInfo declared, std::function<bool()> used = {});
    operator Real() const { return value(); }
};

// A whole number.
class Whole : public Parameter {
public:
    Whole(Lesson& owner, ParameterInfo declared, std::function<bool()> used = {});
    operator Index() const { return static_cast<Index>(value()); }
};

// On or off.
class Switch : public Parameter {
public:
    Switch(Lesson& owner, ParameterInfo declared, std::function<bool()> used = {});
    operator bool() const { return value() != 0; }
};

// A file, whose bytes were read when it was set.
class File : public Parameter {
public:
    File(Lesson& owner, ParameterInfo declared, std::function<bool()> used = {});
    bool given() const { return value() != 0; }
    // From the root on, or the name of a body that comes with Pliant ("hook_coarse"); "" for none.
    const std::string& path() const;
    // For readers and messages, with its ending: "hook_coarse.msh".
    const std::string& name() const;
    std::string_view bytes() const;
};

// One of several named options, read as an enumeration whose values count from 0 in the same order.
template <class Enum>
class Choice : public Parameter {
public:
    Choice(Lesson& owner, ParameterInfo declared, std::vector<Option> options, std::function<bool()> used = {})
        : Parameter(owner, with_options(std::move(declared), std::move(options)), std::move(used)) {}
    operator Enum() const { return static_cast<Enum>(static_cast<int>(value())); }

private:
    static ParameterInfo with_options(ParameterInfo declared, std::vector<Option> options) {
        declared.kind = Kind::choice;
        declared.useful = {0, static_cast<Real>(options.size()) - 1};
        declared.options = std::move(options);
        return declared;
    }
};

}  // namespace pliant
