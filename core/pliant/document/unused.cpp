#include <pliant/document/unused.h>
#include <pliant/document/walkthrough_words.h>

#include <fmt/format.h>

#include <algorithm>

namespace pliant {
namespace {

// A value to try for a parameter, and what to say when it does.
struct Trial {
    Real value;
    Need::What what;
};

bool has_options(const Parameter& p) { return p.info.has_options(); }

// All other options of a choice or a switch. Of a number a hair more and a hair less, and, for what starts further away, its
// initial value and both ends of its slider. A file is not varied.
std::vector<Trial> trials_of(const Parameter& p) {
    std::vector<Trial> trials;
    const auto add = [&](Real value, Need::What what) {
        if (value != p.value() && p.accepted().contains(value)) trials.push_back({value, what});
    };
    if (p.info.kind == Kind::file) return trials;
    if (has_options(p)) {
        for (Real k = 0; k <= p.info.useful.max; ++k) add(k, Need::What::one_of);
        return trials;
    }
    const Real span = p.info.useful.max - p.info.useful.min;
    const Real hair = p.info.kind == Kind::whole ? 1 : 1e-9 * span;
    add(p.value() + hair, Need::What::above);
    add(p.value() - hair, Need::What::below);
    for (const Real value : {p.info.initial, p.info.useful.max, p.info.useful.min}) add(value, Need::What::one_of);
    return trials;
}

// A trial that is being made.
struct Change {
    const Parameter* parameter;
    Real before;
    Trial trial;
};

std::vector<Need> needs_of(const std::vector<Change>& changes) {
    std::vector<Need> needs;
    for (const auto& [p, before, trial] : changes)
        needs.push_back(
            {std::string(p->info.key), trial.what, {p->text(trial.what == Need::What::one_of ? trial.value : before)}});
    return needs;
}

// Looks for what makes a parameter used.
class Search {
public:
    Search(const Lesson& lesson, const Parameter& wanted) : parameters_(lesson.parameters), wanted_(wanted) {}

    // With the fewest changes.
    Ways ways() {
        constexpr std::size_t most = 3, most_with_numbers = 2;  // the work grows with the power
        for (std::size_t count = 1; count <= most && found_.empty(); ++count) {
            numbers_ = count <= most_with_numbers;
            try_changes(0, count);
        }
        return merged();
    }

private:
    void try_changes(std::size_t first, std::size_t count) {
        for (std::size_t i = first; i < parameters_.size(); ++i) {
            Parameter& p = *parameters_[i];
            if (&p == &wanted_ || (!numbers_ && !has_options(p))) continue;
            const Real before = p.value();
            for (const Trial& trial : trials_of(p)) {
                p.set(trial.value);
                changes_.push_back({&p, before, trial});
                if (count > 1)
                    try_changes(i + 1, count - 1);
                else if (wanted_.used())
                    found_.push_back(needs_of(changes_));
                changes_.pop_back();
                p.set(before);
            }
        }
    }

    // Ways that differ in the options of one key alone are one.
    Ways merged() const {
        Ways ways;
        for (const auto& way : found_)
            if (std::ranges::none_of(ways, [&](std::vector<Need>& w) { return take_in(w, way); })) ways.push_back(way);
        for (bool smaller = true; smaller;) {
            Ways next;
            for (const auto& way : ways)
                if (std::ranges::none_of(next, [&](std::vector<Need>& w) { return take_in(w, way); })) next.push_back(way);
            smaller = next.size() < ways.size();
            ways = std::move(next);
        }
        return ways;
    }
    // Where `a` lets a number lie above or below, a certain value of it in `b` says no more.
    static bool covers(const std::vector<Need>& a, const std::vector<Need>& b) {
        return std::ranges::equal(a, b, [](const Need& x, const Need& y) {
            return x.key == y.key && (x.what != Need::What::one_of || x.text() == y.text());
        });
    }
    // Does `a` say what `b` says, or can it be made to?
    static bool take_in(std::vector<Need>& a, const std::vector<Need>& b) {
        if (covers(a, b)) return true;
        Need* other = nullptr;
        const Need* with = nullptr;
        for (std::size_t i = 0; i < a.size(); ++i) {
            if (a[i].key != b[i].key) return false;
            if (a[i].text() == b[i].text()) continue;
            if (other) return false;
            other = &a[i], with = &b[i];
        }
        // Of a number, which may lie above or below or have a certain value, the first is enough.
        if (!other || other->what != Need::What::one_of) return true;
        if (with->what != Need::What::one_of) return false;
        for (const std::string& value : with->values)
            if (std::ranges::find(other->values, value) == other->values.end()) other->values.push_back(value);
        return true;
    }

    std::vector<Parameter*> parameters_;
    const Parameter& wanted_;
    std::vector<Change> changes_;
    bool numbers_ = true;  // are numbers tried as well?
    Ways found_;
};

std::string worded_list(const std::vector<std::string>& parts, std::string_view last) {
    std::string text;
    for (std::size_t i = 0; i < parts.size(); ++i)
        text += (i == 0 ? "" : i + 1 < parts.size() ? ", " : std::string(last)) + parts[i];
    return text;
}

// Sets what the assignments say. Throws Refused.
void assign_all(const Lesson& lesson, const Runner::Assignments& assignments) {
    for (const auto& [key, text] : assignments) {
        Parameter& p = lesson.parameter(key);
        p.set(p.parse(text));
    }
}

}  // namespace

std::string Need::text() const {
    if (what == What::one_of) return fmt::format("{}={}", key, worded_list(values, " or "));
    return fmt::format("{} {} {}", key, what == What::above ? "above" : "below", values.front());
}

std::string text_of(const Ways& ways) {
    std::vector<std::string> texts;
    for (const auto& way : ways) {
        std::vector<std::string> needs;
        for (const Need& need : way) needs.push_back(need.text());
        texts.push_back(worded_list(needs, " and "));
    }
    return worded_list(texts, ", or with ");
}

Ways ways_to_use(const LessonEntry& entry, const Runner::Assignments& assignments, std::string_view key) {
    const auto lesson = entry.make();
    assign_all(*lesson, assignments);
    const Parameter& p = lesson->parameter(key);
    return p.used() ? Ways{} : Search(*lesson, p).ways();
}

std::string UnusedSetting::text() const {
    const std::string sentence = needs.empty() ? fmt::format("{} has no effect here", key)
                                               : fmt::format("{} is used with {}: here it has no effect", key, needs);
    return place.empty() ? sentence : fmt::format("{}: {}", place, sentence);
}

UsedSettings::UsedSettings(const LessonEntry& entry) : lesson_(entry.make()) {}

UsedSettings::~UsedSettings() = default;

void UsedSettings::set(const Runner::Assignments& assignments, const std::string& place) {
    assign_all(*lesson_, assignments);
    for (const auto& [key, text] : assignments) {
        Parameter* const p = &lesson_->parameter(key);
        if (std::ranges::find(followed_, p, &Followed::parameter) == followed_.end()) followed_.push_back({p, place, false});
    }
}

void UsedSettings::load_defaults() {
    for (Parameter* p : lesson_->parameters) p->set(p->info.initial);
}

void UsedSettings::look() {
    for (Followed& f : followed_) f.used = f.used || f.parameter->used();
}

std::vector<UnusedSetting> UsedSettings::unused() const {
    std::vector<UnusedSetting> list;
    for (const Followed& f : followed_)
        if (!f.used)
            list.push_back({std::string(f.parameter->info.key), text_of(Search(*lesson_, *f.parameter).ways()), f.place});
    return list;
}

std::vector<UnusedSetting> unused_settings(const SceneFile& scene) {
    UsedSettings settings(find_lesson(scene.lesson));
    settings.set(scene.parameters);
    std::vector<Event> events = scene.events;
    std::ranges::stable_sort(events, {}, &Event::step);
    Index step = 0;
    for (const Event& e : events) {
        if (e.step > step) settings.look();
        step = e.step;
        settings.set(e.assign);
    }
    settings.look();
    return settings.unused();
}

namespace {

// What one action of a walkthrough does to the settings.
void follow_action(UsedSettings& settings, const LessonEntry& entry, const std::string& line, const std::string& place) {
    const auto words = words_of_line(line);
    if (words.empty()) return;
    if (words[0] == "set") return settings.set(assignments_of(words), place);
    settings.look();
    if (words[0] != "preset" || words.size() != 2) return;
    settings.load_defaults();
    settings.set(preset(entry, words[1]).parameters, place);
}

}  // namespace

std::vector<UnusedSetting> unused_settings(const LessonEntry& entry, const Walkthrough& walkthrough) {
    UsedSettings settings(entry);
    for (const Slide& slide : walkthrough.slides)
        for (const Block& b : slide.blocks) {
            if (b.kind != BlockKind::actions) continue;
            int line = b.first_line;
            for (const std::string& action : b.lines)
                follow_action(settings, entry, action, fmt::format("{}:{}", walkthrough.path, line++));
            settings.look();
        }
    return settings.unused();
}

}  // namespace pliant
