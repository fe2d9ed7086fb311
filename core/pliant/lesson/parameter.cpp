#include <pliant/lesson/lesson.h>
#include <pliant/lesson/parameter.h>
#include <pliant/text/format.h>
#include <pliant/text/number_text.h>
#include <pliant/text/quantity_text.h>
#include <pliant/text/stored_file.h>
#include <pliant/text/suggest.h>

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

namespace pliant {
namespace {

ParameterInfo of_kind(ParameterInfo info, Kind kind) {
    info.kind = kind;
    if (kind == Kind::toggle) info.useful = {0, 1};
    return info;
}

std::string with_unit(std::string_view number, std::string_view unit) {
    return unit.empty() ? fmt::format("{} (dimensionless)", number) : fmt::format("{} {}", number, unit);
}

std::string with_comma_as(std::string_view text, std::string_view sign) {
    std::string other(text);
    return other.replace(other.find(','), 1, sign);
}

std::string option_keys(const std::vector<Option>& options) {
    std::string keys;
    for (const Option& o : options) keys += (keys.empty() ? "" : ", ") + std::string(o.key);
    return keys;
}

[[noreturn]] void refuse_text(const Parameter& p, std::string_view text, const QuantityText& read) {
    const std::string range = p.accepted().text();
    const std::string_view unit = p.info.unit;
    switch (read.problem) {
        case QuantityText::Problem::out_of_range:
            throw Refused(
                fmt::format("{} = {} is too large or too small for a number: give a value in {}", p.info.key, text, range));
        case QuantityText::Problem::ambiguous:
            throw Refused(fmt::format("{} = {} can be read in two ways: give {} or {}, whichever is meant", p.info.key, text,
                                      with_comma_as(text, "."), with_comma_as(text, "")));
        case QuantityText::Problem::other_unit:
            if (unit.empty())
                throw Refused(
                    fmt::format("{} = '{}' has a unit, {}, and this number has none: give a number in {}, dimensionless",
                                p.info.key, text, read.unit, range));
            throw Refused(fmt::format("{} = '{}' is in another unit, {}: give a number in {} {}; {} may stand behind it",
                                      p.info.key, text, read.unit, range, unit, units_accepted(unit)));
        default:
            throw Refused(fmt::format("{} = '{}' is not a number: give a number in {}, {}", p.info.key, text, range,
                                      unit_or_dimensionless(unit)));
    }
}

}  // namespace

namespace {
struct GroupName {
    std::string_view key, name;
};
constexpr std::array<GroupName, all_groups.size()> group_names{{{"scene", "Scene"},
                                                                {"method", "Method"},
                                                                {"material", "Material"},
                                                                {"forces", "Forces and contact"},
                                                                {"start", "Start"},
                                                                {"shape", "Size and cells"},
                                                                {"solver", "Solver"},
                                                                {"view", "Picture and hand"}}};
}  // namespace

std::string_view key_of(Group group) { return group_names[static_cast<std::size_t>(group)].key; }
std::string_view name_of(Group group) { return group_names[static_cast<std::size_t>(group)].name; }

bool Interval::contains(Real v) const { return (open_min ? v > min : v >= min) && (open_max ? v < max : v <= max); }

namespace {
// All digits in as few letters as that takes: "1e15", where fifteen noughts would be counted by nobody.
std::string short_number(Real value) {
    std::array<char, 40> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    std::string text(digits.data(), end);
    const auto e = text.find('e');
    if (e == text.npos) return text;
    // "1e+15" as "1e15", "1e-06" as "1e-6".
    std::size_t power = e + 1;
    if (text[power] == '+') text.erase(power, 1);
    if (text[power] == '-') ++power;
    while (power + 1 < text.size() && text[power] == '0') text.erase(power, 1);
    return text;
}
}  // namespace

std::string Interval::text() const {
    return fmt::format("{}{}, {}{}", open_min ? '(' : '[', short_number(min), short_number(max), open_max ? ')' : ']');
}

ParameterInfo quantity(std::string_view key, std::string_view symbol, std::string_view unit, Real initial, Interval useful,
                       std::string_view help) {
    return {.key = key, .symbol = symbol, .unit = unit, .help = help, .initial = initial, .useful = useful};
}

ParameterInfo quantity(std::string_view key, std::string_view symbol, std::string_view unit, Real initial, Interval useful,
                       Interval accepted, std::string_view help) {
    return quantity(key, symbol, unit, initial, useful, help).accepts(accepted);
}

ParameterInfo log_quantity(std::string_view key, std::string_view symbol, std::string_view unit, Real initial, Interval useful,
                           Interval accepted, std::string_view help) {
    return quantity(key, symbol, unit, initial, useful, accepted, help).log();
}

ParameterInfo file_of(std::string_view key, std::string_view help, std::vector<std::string_view> endings) {
    return {
        .key = key, .help = help, .useful = {0, 0}, .effect = Effect::rebuild, .kind = Kind::file, .endings = std::move(endings)};
}

std::string_view name_of(Effect effect) {
    return effect == Effect::live ? "live" : effect == Effect::rebuild ? "rebuild" : "look";
}

ParameterInfo ParameterInfo::log() const {
    ParameterInfo info = *this;
    info.scale = Scale::log;
    return info;
}
ParameterInfo ParameterInfo::in(Group belongs_to) const {
    ParameterInfo info = *this;
    info.group = belongs_to;
    return info;
}
ParameterInfo ParameterInfo::once(std::string_view key_before) const {
    ParameterInfo info = *this;
    info.formerly = key_before;
    return info;
}
ParameterInfo ParameterInfo::accepts(Interval interval) const {
    ParameterInfo info = *this;
    info.accepted = interval;
    return info;
}
ParameterInfo ParameterInfo::rebuilds() const {
    ParameterInfo info = *this;
    info.effect = Effect::rebuild;
    return info;
}
ParameterInfo ParameterInfo::looks() const {
    ParameterInfo info = *this;
    info.effect = Effect::look;
    return info;
}
ParameterInfo ParameterInfo::with(std::string_view companion, std::string_view value) const {
    ParameterInfo info = *this;
    info.companions.emplace_back(companion, value);
    return info;
}
ParameterInfo ParameterInfo::when(std::function<bool()> uses) const {
    ParameterInfo info = *this;
    info.used = std::move(uses);
    return info;
}

Parameter::Parameter(Lesson& owner, ParameterInfo given, std::function<bool()> used)
    : info(used ? given.when(std::move(used)) : std::move(given)), value_(info.initial) {
    owner.parameters.push_back(this);
}

Number::Number(Lesson& owner, ParameterInfo declared, std::function<bool()> used)
    : Parameter(owner, std::move(declared), std::move(used)) {}

Whole::Whole(Lesson& owner, ParameterInfo declared, std::function<bool()> used)
    : Parameter(owner, of_kind(std::move(declared), Kind::whole), std::move(used)) {}

Switch::Switch(Lesson& owner, ParameterInfo declared, std::function<bool()> used)
    : Parameter(owner, of_kind(std::move(declared), Kind::toggle), std::move(used)) {}

File::File(Lesson& owner, ParameterInfo declared, std::function<bool()> used)
    : Parameter(owner, of_kind(std::move(declared), Kind::file), std::move(used)) {}

namespace {
const StoredFile& file_of_value(Real value) { return stored_file(static_cast<Index>(value)); }
}  // namespace

const std::string& File::path() const { return file_of_value(value()).path; }
const std::string& File::name() const { return file_of_value(value()).name; }
std::string_view File::bytes() const { return file_of_value(value()).bytes; }

void Parameter::set(Real value) {
    check(value);
    value_ = value == 0 ? 0 : value;  // -0 and 0 are one value
}

void Parameter::check(Real value) const {
    if (info.kind == Kind::file) {
        if (std::isfinite(value) && is_whole(value) && is_stored(static_cast<Index>(value), info.endings)) return;
        throw Refused(fmt::format("{} = {} is the number of no file that was named: give a file that ends in {}", info.key,
                                  format_exact(value), accepted_files(info.endings)));
    }
    if (std::isfinite(value) && accepted().contains(value) && (info.kind == Kind::number || is_whole(value))) return;
    const std::string shown = info.kind == Kind::number ? format_exact(value) : fmt::format("{}", value);
    if (!std::isfinite(value))
        throw Refused(fmt::format("{} = {} is not a finite number: give a number in {}, {}", info.key, shown, accepted().text(),
                                  unit_or_dimensionless(info.unit)));
    if (info.kind != Kind::number && !is_whole(value))
        throw Refused(
            fmt::format("{} = {} is not a whole number: give a whole number in {}", info.key, shown, accepted().text()));
    throw Refused(
        fmt::format("{} = {} is outside the accepted range {}", info.key, with_unit(shown, info.unit), accepted().text()));
}

Real Parameter::parse(std::string_view text, std::string_view unit_if_none) const {
    if (info.kind == Kind::choice) {
        for (std::size_t i = 0; i < info.options.size(); ++i)
            if (info.options[i].key == text) return static_cast<Real>(i);
        std::vector<std::string> keys;
        for (const Option& o : info.options) keys.emplace_back(o.key);
        throw Refused(fmt::format("{} = {} is not one of its options{}; give one of: {}", info.key, text,
                                  did_you_mean(text, keys), option_keys(info.options)));
    }
    if (info.kind == Kind::toggle) {
        if (text == "true" || text == "on" || text == "1") return 1;
        if (text == "false" || text == "off" || text == "0") return 0;
        throw Refused(fmt::format("{} = {} is not a switch position: give true or false", info.key, text));
    }
    if (info.kind == Kind::file) {
        try {
            return static_cast<Real>(store_file(text, info.endings));
        } catch (const Refused& e) {
            throw Refused(fmt::format("{} = {}", info.key, e.what()));
        }
    }
    const QuantityText read = read_quantity(text, info.unit, unit_if_none);
    if (read.problem != QuantityText::Problem::none) refuse_text(*this, text, read);
    check(read.value);
    return read.value;
}

std::string Parameter::text(Real value) const {
    switch (info.kind) {
        case Kind::choice:
            return std::string(info.options[static_cast<std::size_t>(value)].key);
        case Kind::toggle:
            return value != 0 ? "true" : "false";
        case Kind::whole:
            return fmt::format("{}", static_cast<long long>(value));
        case Kind::file:
            return value == 0 ? "none" : file_of_value(value).path;
        case Kind::number:
            break;
    }
    return format_exact(value);
}

}  // namespace pliant
