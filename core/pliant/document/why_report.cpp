// Answers as JSON and as text.
#include <pliant/run/why.h>
#include <pliant/text/format.h>
#include <pliant/text/spoken.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

std::string_view name_of(Answer::Kind kind) {
    switch (kind) {
        case Answer::Kind::computed:
            return "computed";
        case Answer::Kind::combined:
            return "combined";
        case Answer::Kind::part:
            return "part";
        case Answer::Kind::parameter:
            return "parameter";
        case Answer::Kind::constant:
            return "constant";
        case Answer::Kind::state:
            return "state";
        case Answer::Kind::given:
            return "given";
    }
    return "";
}

Json json_of(const Answer& a, int depth) {
    Json j{{"symbol", a.symbol}, {"field", a.field}, {"index", a.index}};
    if (a.component >= 0) j["component"] = a.component;
    j["value"] = std::isfinite(a.value) ? Json(a.value) : Json(nullptr);
    j["unit"] = a.unit;
    j["kind"] = name_of(a.kind);
    j["step"] = step_number(a.when);
    j["passes"] = a.when.passes;
    j["stage"] = a.stage;
    j["formula"] = a.formula;
    j["substituted"] = a.substituted;
    if (!a.trouble.empty()) j["error"] = a.trouble;
    if (a.together) j["solved_together"] = true;
    if (a.leftover) j["left_over"] = true;
    if (!a.latex.empty()) j["latex"] = a.latex;
    if (!a.unit_check.empty()) j["unit_check"] = a.unit_check;
    j["inputs"] = Json::array();
    if (depth == 0) return j;
    for (const Answer& input : a.inputs) {
        j["inputs"].push_back(json_of(input, depth - 1));
        j["inputs"].back()["sensitivity"] = input.sensitivity;
        if (input.by_differences) j["inputs"].back()["sensitivity_by"] = "differences";
    }
    return j;
}

std::string where_from(const Answer& a) {
    if (a.together) return "solved together with it";
    if (a.leftover && a.stage.empty()) return "what the solve has left";
    switch (a.kind) {
        case Answer::Kind::computed:
            return a.stage.empty() ? "by definition" : fmt::format("stage {}", a.stage);
        case Answer::Kind::parameter:
            return "a parameter";
        case Answer::Kind::constant:
            return a.field;
        case Answer::Kind::state:
            return a.when.step == 0 ? "the initial state" : fmt::format("the state after step {}", a.when.step);
        default:
            return "";
    }
}

std::string name_of(const Answer& a) {
    switch (a.kind) {
        case Answer::Kind::constant:
        case Answer::Kind::part:
            return a.symbol;
        case Answer::Kind::parameter:
            return fmt::format("{} {}", a.field, a.symbol);
        default: {
            const std::string place = a.of_probe ? a.field : fmt::format("{}[{}]", a.field, a.index);
            return a.symbol.empty() || a.symbol == place ? place : fmt::format("{} {}", place, a.symbol);
        }
    }
}

// Long sums list what matters most. A part that is one of many terms tells its formula alone.
void text_of(const Answer& a, int indent, bool with_inputs, std::string& text) {
    constexpr std::size_t most = 12, most_parts = 3;
    const std::string origin = where_from(a);
    text += fmt::format("{:{}}{} = {}{}\n", "", indent, name_of(a), format_quantity(a.value, a.unit, 7),
                        origin.empty() ? "" : fmt::format("   ({})", origin));
    if (!a.formula.empty()) text += fmt::format("{:{}}{}\n", "", indent + 4, a.formula);
    if (!a.trouble.empty()) text += fmt::format("{:{}}the formula cannot be evaluated\n{}\n", "", indent + 4, a.trouble);
    if (!a.substituted.empty() && a.substituted != a.formula) text += fmt::format("{:{}}{}\n", "", indent + 4, a.substituted);
    if (const std::string words = unit_words(a); !words.empty()) text += fmt::format("{:{}}{}\n", "", indent + 4, words);
    if (!with_inputs) return;
    const auto parts = static_cast<std::size_t>(std::ranges::count(a.inputs, Answer::Kind::part, &Answer::kind));
    const auto inputs = inputs_to_read(a);
    const std::size_t shown = inputs.size() > most ? most - 2 : inputs.size();
    for (std::size_t k = 0; k < shown; ++k)
        text_of(*inputs[k], indent + 2, k == 0 || parts <= most_parts || inputs[k]->kind != Answer::Kind::part, text);
    if (shown < inputs.size())
        text += fmt::format("{:{}}… and {} more, none of which matters more than these\n", "", indent + 2, inputs.size() - shown);
}

}  // namespace

bool has_trouble(const Answer& a) { return !a.trouble.empty() || std::ranges::any_of(a.inputs, has_trouble); }

std::string unit_words(const Answer& a) {
    if (a.unit_check.empty() || a.unit_check == "ok") return "";
    return fmt::format("The sides differ in their unit: {}.", a.unit_check);
}

std::string why_json(const Answer& answer, int depth) { return json_of(answer, depth).dump(2) + "\n"; }

std::string why_text(const Answer& answer) {
    std::string text;
    text_of(answer, 0, true, text);
    return text;
}

std::string words_of_solve(const Answer& a, const Lesson& lesson) {
    const Field* field = lesson.find_field(a.field);
    if (!field || std::ranges::none_of(a.inputs, &Answer::together)) return "";
    const Index others = field->size() - 1;
    const auto left = std::ranges::find(a.inputs, true, &Answer::leftover);
    std::string text =
        fmt::format("Solved together with {} other {}{}: none of them comes first, the equation holds for all at once.", others,
                    name_of(field->on), others == 1 ? "" : "s");
    if (left != a.inputs.end()) text += fmt::format(" What the solver has left of it is {}: go on from there.", left->symbol);
    return text;
}

std::vector<const Answer*> inputs_to_read(const Answer& a) {
    constexpr std::size_t few = 8;  // that are seen at once stay in the order of the formula
    std::vector<const Answer*> inputs;
    for (const Answer& input : a.inputs) inputs.push_back(&input);
    if (inputs.size() > few) std::ranges::stable_sort(inputs, std::ranges::greater{}, &Answer::sensitivity);
    return inputs;
}

std::string title_of(const Answer& a, const Lesson& lesson) {
    const Field* field = lesson.find_field(a.field);
    if (!field) return a.field.empty() ? a.symbol : spoken(a.field);
    const std::string component =
        a.component >= 0 && field->rank != Rank::scalar
            ? fmt::format("the {} component of ", component_names(*field)[static_cast<std::size_t>(a.component)])
            : "";
    return fmt::format("{}the {} of {} {}", component, spoken(field->name), spoken(name_of(field->on)), a.index);
}

}  // namespace pliant
