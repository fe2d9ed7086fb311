#include <pliant/lesson/lesson.h>
#include <pliant/lesson/unstructured_grid.h>
#include <pliant/text/suggest.h>

#include <fmt/format.h>

#include <algorithm>

namespace pliant {
namespace {

// The item of a list with this name; otherwise an error that names the list and the nearest item.
template <class List, class Name>
auto& named(List& list, std::string_view name, std::string_view what, Name name_of_item) {
    std::vector<std::string> known;
    for (auto& item : list) {
        if (name_of_item(item) == name) return item;
        known.emplace_back(name_of_item(item));
    }
    std::string all;
    for (const std::string& k : known) all += (all.empty() ? "" : ", ") + k;
    throw Refused(fmt::format("no {} is called '{}'{}; there are: {}", what, name, did_you_mean(name, known), all));
}

}  // namespace

Curve curve_of(const std::function<void(Curve&)>& sample) {
    Curve curve;
    try {
        if (sample) sample(curve);
    } catch (const Diverged&) {
        return {};
    }
    return curve;
}

std::vector<const Stage*> Lesson::stages_in_use() const {
    std::vector<const Stage*> used;
    for (const Stage& stage : stages)
        if (stage.in_use()) used.push_back(&stage);
    const auto order = stage_order();
    const auto rank = [&](const Stage* stage) { return std::ranges::find(order, stage->name) - order.begin(); };
    if (!order.empty()) std::ranges::stable_sort(used, {}, rank);
    return used;
}

std::optional<UnstructuredGrid> Lesson::unstructured_grid() const { return std::nullopt; }

std::vector<const Parameter*> Lesson::parameters_of(Group group) const {
    std::vector<const Parameter*> members;
    for (const Parameter* p : parameters)
        if (p->info.group == group) members.push_back(p);
    return members;
}

Parameter& Lesson::parameter(std::string_view key) const {
    for (Parameter* p : parameters)
        if (p->info.is_called(key)) return *p;
    return *named(parameters, key, "parameter", [](const Parameter* p) { return p->info.key; });
}

const Field& Lesson::field(std::string_view name) const {
    const Field& f = named(fields, name, "field", [](const Field& item) { return item.name; });
    if (!f.in_use())
        throw Refused(
            fmt::format("the field '{}' is not computed with these parameters: see `describe` for what switches it on", name));
    return f;
}

const Probe& Lesson::probe(std::string_view name) const {
    for (const Probe& p : probes)
        if (!p.formerly.empty() && p.formerly == name) return p;
    return named(probes, name, "probe", [](const Probe& item) { return item.name; });
}

void Lesson::explain_probe(std::string_view name, std::function<Explanation()> why) {
    named(probes, name, "probe", [](const Probe& item) { return item.name; }).explain = std::move(why);
}

const Field* Lesson::find_field(std::string_view name) const {
    const auto found = std::ranges::find(fields, name, &Field::name);
    return found == fields.end() ? nullptr : &*found;
}

std::string_view Lesson::error_probe() const {
    const auto with_exact = std::ranges::find_if(probes, [](const Probe& p) { return static_cast<bool>(p.exact); });
    if (with_exact != probes.end()) return with_exact->name;
    const auto keys = key_numbers();
    return keys.empty() ? "" : keys.front();
}

}  // namespace pliant
