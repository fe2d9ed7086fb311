#include <pliant/document/summary.h>
#include <pliant/lesson/setting_words.h>
#include <pliant/math/watch.h>
#include <pliant/study/method_comparison.h>
#include <pliant/study/stability_verdict.h>
#include <pliant/text/format.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace pliant {
namespace {

// What the lessons call the choice of their method, the first that a scene uses being the one that it is about.
constexpr std::array<std::string_view, 11> method_keys{
    "integrator", "advection_scheme", "viscosity_scheme", "scheme", "method", "solver",
    "energy",     "linear_solver",    "spring_rule",      "order",  "grid"};

std::size_t rank_of(const Parameter& p) {
    return static_cast<std::size_t>(std::ranges::find(method_keys, p.info.key) - method_keys.begin());
}

Real place_of(const Runner& r) { return r.is_static() ? static_cast<Real>(r.place().step) : r.time(); }

std::optional<Real> finite_value(const Runner& r, const Probe& p, bool exact) {
    try {
        const auto v = exact ? r.exact(p) : r.value(p);
        return v && std::isfinite(*v) ? v : std::nullopt;
    } catch (const Diverged&) {
        return std::nullopt;
    }
}

// How many steps make up what was asked for, which all methods then run.
Index steps_of(const LessonEntry& entry, const SceneFile& scene, const Until& until) {
    Runner r(entry, scene.parameters, 0);
    if (until.what == Until::What::steps) return until.steps;
    if (until.what == Until::What::time && !r.is_static()) return static_cast<Index>(std::llround(until.time / r.time_step()));
    r.set_events(scene.events);
    advance(r, until);
    return std::max<Index>(r.place().step, 1);
}

struct Sampled {
    std::vector<Real> at, value;
};

// The probe at a time, on a straight line between two samples where it has none then.
Real value_at(const Sampled& s, Real at, Real within) {
    const auto found = std::ranges::lower_bound(s.at, at - within);
    if (found == s.at.end()) return TimeSeries::undefined;
    const auto k = static_cast<std::size_t>(found - s.at.begin());
    if (*found <= at + within) return s.value[k];
    if (k == 0) return TimeSeries::undefined;
    return std::lerp(s.value[k - 1], s.value[k], (at - s.at[k - 1]) / (s.at[k] - s.at[k - 1]));
}

constexpr Index whole_parts = 1000;

class Comparing {
public:
    Comparing(const SceneFile& scene, const Parameter& choice, Index steps)
        : scene_(scene), entry_(find_lesson(scene.lesson)), key_(choice.info.key) {
        result_.lesson = scene.lesson, result_.parameter = key_, result_.steps = steps;
    }

    MethodComparison compare(const std::vector<Option>& options, const AfterRun& after_run) {
        const Overview whole("methods", whole_parts);
        whole_ = &whole;
        runs_ = options.size() + 1;  // the finer one as well
        for (const Option& option : options) {
            tell_share(0);
            result_.runs.push_back(run_of(option));
            // What is measured against a finer run waits for it.
            if (!reference_.at.empty())
                for (MethodRun& run : result_.runs) take_error(run);
            if (after_run) after_run(result_);
        }
        if (reference_.at.empty()) find_finer();
        for (MethodRun& run : result_.runs) take_error(run);
        if (std::ranges::none_of(result_.runs, [](const MethodRun& r) { return r.error.has_value(); }))
            result_.no_error = why_none();
        result_.reference_at = reference_.at, result_.reference_value = reference_.value;
        return std::move(result_);
    }

    std::optional<Real> seconds(const std::vector<Option>& options) {
        const Runner present(entry_, scene_.parameters, 0);
        if (present.is_static()) return std::nullopt;
        Real sum = 0;
        for (const Option& option : options) {
            Runner::Assignments all = scene_.parameters;
            assign(all, key_, std::string(option.key));
            sum += static_cast<Real>(result_.steps) * step_seconds(all);
        }
        const Probe* const probe = find_probe(present.lesson(), present.lesson().error_probe());
        const auto finer = present.lesson().finer();
        const Real end = static_cast<Real>(result_.steps) * present.time_step();
        if (!probe || finer.empty() || (probe->exact && probe->exact(end))) return sum;
        Runner::Assignments all = scene_.parameters;
        for (const auto& [key, text] : finer) assign(all, key, text);
        return sum + end / Runner(entry_, all, 0).time_step() * step_seconds(all);
    }

private:
    // Of the first steps with all that is sampled in them, but for the very first, in which things are made.
    Real step_seconds(const Runner::Assignments& all) const {
        using Clock = std::chrono::steady_clock;
        constexpr Real long_enough = 0.1;
        constexpr int enough = 200;
        int steps = 0;
        Clock::time_point start = Clock::now();
        const auto spent = [&] { return std::chrono::duration<Real>(Clock::now() - start).count(); };
        try {
            Runner r(entry_, all, 0);
            r.set_events(scene_.events);
            const Probe* const probe = find_probe(r.lesson(), r.lesson().error_probe());
            const Probe* const energy = find_probe(r.lesson(), "energy");
            r.step();
            for (start = Clock::now(); steps < enough && spent() < long_enough; ++steps) {
                cancel_point();
                r.step();
                for (const Probe* p : {probe, energy})
                    if (p) finite_value(r, *p, false), finite_value(r, *p, true);
            }
        } catch (const Refused&) {
            return 0;  // nothing is run
        } catch (const Diverged&) {
            // What breaks down so soon costs no more.
            return 0;
        }
        return spent() / steps;
    }

    // Of the run that is under way.
    void tell_share(Real share) const {
        const Real done = static_cast<Real>(result_.runs.size()) + std::clamp(share, Real{0}, Real{1});
        whole_->tell(static_cast<Index>(static_cast<Real>(whole_parts) * done / static_cast<Real>(runs_)));
        cancel_point();
    }
    Real share_of_steps(const Runner& r) const {
        return static_cast<Real>(r.place().step) / static_cast<Real>(std::max<Index>(result_.steps, 1));
    }

    static void assign(Runner::Assignments& all, std::string key, std::string text) {
        std::erase_if(all, [&](const auto& a) { return a.first == key; });
        all.emplace_back(std::move(key), std::move(text));
    }

    MethodRun run_of(const Option& option) {
        MethodRun run{.option = std::string(option.key), .label = std::string(option.label)};
        Runner::Assignments all = scene_.parameters;
        assign(all, key_, run.option);
        try {
            Runner r(entry_, all, 0);
            r.set_events(scene_.events);
            follow(run, r);
        } catch (const Refused& e) {
            run.outcome = MethodRun::Outcome::refused;
            run.words = e.what();
        }
        return run;
    }

    const Probe* find_probe(const Lesson& lesson, std::string_view name) const {
        const auto found = std::ranges::find(lesson.probes, name, &Probe::name);
        return found == lesson.probes.end() ? nullptr : &*found;
    }

    void sample(MethodRun& run, const Runner& r, const Probe* probe) {
        if (!probe) return;
        const auto value = finite_value(r, *probe, false), exact = finite_value(r, *probe, true);
        if (value) run.value = value;
        run.curve.add(r.place().step, place_of(r), value.value_or(TimeSeries::undefined), exact.value_or(TimeSeries::undefined));
    }

    // The exact course is the same beside every method. One that ends before the run does, as free fall does at the ground, says
    // nothing of its end.
    void take_exact(const TimeSeries& curve) {
        if (!reference_.at.empty() || !curve.has_exact() || !std::isfinite(curve.exact().back())) return;
        for (std::size_t k = 0; k < curve.size(); ++k)
            if (std::isfinite(curve.exact()[k]))
                reference_.at.push_back(curve.at()[k]), reference_.value.push_back(curve.exact()[k]);
        if (!reference_.at.empty()) result_.reference = "the exact solution";
    }

    void follow(MethodRun& run, Runner& r) {
        using Clock = std::chrono::steady_clock;
        const Probe* const probe = find_probe(r.lesson(), r.lesson().error_probe());
        const Probe* const energy = find_probe(r.lesson(), "energy");
        if (result_.probe.empty() && probe) result_.probe = probe->name, result_.unit = probe->unit;
        result_.is_static = r.is_static();
        if (probe) run.curve = TimeSeries(static_cast<bool>(probe->exact));
        StabilityWatch watch;
        const auto look = [&] {
            sample(run, r, probe);
            if (energy) watch.add(finite_value(r, *energy, false), finite_value(r, *energy, true));
        };
        look();
        const auto start = Clock::now();
        Clock::duration looking{};
        try {
            advance(r, Until::after_steps(result_.steps), [&] {
                const auto before = Clock::now();
                look();
                tell_share(share_of_steps(r));
                looking += Clock::now() - before;
            });
            judge(run, r, energy && watch.samples() > 4 ? std::optional(watch.verdict(true, true)) : std::nullopt);
        } catch (const Diverged& d) {
            run.outcome = MethodRun::Outcome::stopped;
            run.words = stop_words(d.failure, r);
        }
        run.ms = std::chrono::duration<Real, std::milli>(Clock::now() - start - looking).count();
        run.steps = r.place().step, run.time = r.time();
        for (const Stage& s : r.lesson().stages) run.passes += r.cost(s).passes;
        if (run.outcome != MethodRun::Outcome::stopped) take_exact(run.curve);
    }

    static std::string stop_words(const Failure& f, const Runner& r) {
        const std::string when =
            r.is_static() ? fmt::format("in step {}", f.step) : fmt::format("at {}", format_quantity(f.time, "s", 3));
        return fmt::format("stops {} in the stage {}{}", when, spoken(f.stage),
                           f.field.empty() ? "" : fmt::format(": {}", spoken(f.field)));
    }

    static void judge(MethodRun& run, const Runner& r, const std::optional<StabilityVerdict>& verdict) {
        using Outcome = MethodRun::Outcome;
        const std::string end = r.is_static() ? "solved" : "runs to the end";
        run.outcome = !verdict                                  ? Outcome::finished
                      : verdict->kind == Stability::stable      ? Outcome::steady
                      : verdict->kind == Stability::dissipative ? Outcome::loses
                                                                : Outcome::grows;
        run.words = end;
        if (run.outcome == Outcome::loses) run.words += ", and loses energy";
        if (run.outcome == Outcome::grows) run.words += ", but its energy grows";
    }

    // Where no method has a closed form beside it: the scene in the finer settings that the lesson names.
    void find_finer() {
        try {
            Runner probe_of_settings(entry_, scene_.parameters, 0);
            const auto finer = probe_of_settings.lesson().finer();
            if (finer.empty() || result_.probe.empty()) return;
            const Real end = probe_of_settings.is_static() ? static_cast<Real>(result_.steps)
                                                           : static_cast<Real>(result_.steps) * probe_of_settings.time_step();
            Runner::Assignments all = scene_.parameters;
            for (const auto& [key, text] : finer) assign(all, key, text);
            Runner r(entry_, all, 0);
            r.set_events(scene_.events);
            const auto look = [&] {
                if (const auto v = finite_value(r, r.lesson().probe(result_.probe), false))
                    reference_.at.push_back(place_of(r)), reference_.value.push_back(*v);
            };
            look();
            advance(r, r.is_static() ? Until::after_steps(result_.steps) : Until::after_time(end), [&] {
                look();
                tell_share(r.is_static() ? share_of_steps(r) : r.time() / end);
            });
            result_.reference = fmt::format("a finer run: {}", settings_words(r.lesson(), finer));
        } catch (const Diverged& d) {
            no_finer(fmt::format("it stops in the stage {}", spoken(d.failure.stage)));
        } catch (const Refused& e) {
            no_finer(e.what());
        }
    }

    void no_finer(const std::string& why) {
        reference_ = {};
        trouble_ = fmt::format("The finer run gives nothing to measure errors against: {}.", why);
    }

    std::string why_none() const {
        if (result_.reference.empty())
            return trouble_.empty() ? "There is neither an exact solution nor a finer run to measure errors against." : trouble_;
        const auto ended = [](const MethodRun& r) { return r.ran() && r.outcome != MethodRun::Outcome::stopped; };
        if (std::ranges::none_of(result_.runs, ended)) return "No method gets to the end, so none has an error there.";
        if (std::ranges::any_of(reference_.value, [](Real v) { return v != 0; }))
            return fmt::format("{} does not reach the end of the runs, so none has an error there.", result_.reference);
        return fmt::format("The {} is 0 in {}: an error would be relative to nothing.", spoken(result_.probe), result_.reference);
    }

    void take_error(MethodRun& run) const {
        if (!run.value || run.outcome == MethodRun::Outcome::stopped) return;
        if (const auto& exact = run.curve.exact(); !exact.empty() && std::isfinite(exact.back())) {
            if (run.curve.scale().back() > 0) run.error = std::abs(*run.value - exact.back()) / run.curve.scale().back();
            return;
        }
        if (reference_.at.empty()) return;
        const Real at = result_.is_static ? static_cast<Real>(run.steps) : run.time;
        const Real reference = value_at(reference_, at, 1e-9 * std::max(std::abs(reference_.at.back()), Real{1e-300}));
        Real largest = 0;
        for (const Real v : reference_.value) largest = std::max(largest, std::abs(v));
        if (std::isfinite(reference) && largest > 0) run.error = std::abs(*run.value - reference) / largest;
    }

    const SceneFile& scene_;
    const LessonEntry& entry_;
    std::string key_;
    MethodComparison result_;
    Sampled reference_;
    std::string trouble_;  // of the finer run
    const Overview* whole_ = nullptr;
    std::size_t runs_ = 0;
};

}  // namespace

std::vector<const Parameter*> comparable_choices(const Lesson& lesson) {
    std::vector<const Parameter*> all;
    for (const Parameter* p : lesson.parameters)
        if (p->info.kind == Kind::choice && p->used() && p->info.options.size() > 1) all.push_back(p);
    std::ranges::stable_sort(all, {}, [](const Parameter* p) { return rank_of(*p); });
    return all;
}

const Parameter* method_of(const Lesson& lesson) {
    const auto all = comparable_choices(lesson);
    return all.empty() || rank_of(*all.front()) == method_keys.size() ? nullptr : all.front();
}

namespace {

// By its key, or method_of() when that is empty.
const Parameter& choice_of(const Runner& r, const SceneFile& scene, std::string_view key) {
    const auto choices = comparable_choices(r.lesson());
    std::vector<std::string_view> known;
    for (const Parameter* p : choices) known.push_back(p->info.key);
    const Parameter* choice = key.empty() ? method_of(r.lesson()) : nullptr;
    if (!key.empty()) {
        const Parameter& named = r.lesson().parameter(key);
        if (const auto found = std::ranges::find(choices, &named); found != choices.end()) choice = *found;
    }
    if (!choice)
        throw Refused(fmt::format("{} of {}: there are {}",
                                  key.empty() ? "no choice is the method" : fmt::format("'{}' is no choice that is used", key),
                                  scene.lesson, known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
    return *choice;
}

}  // namespace

MethodComparison compare_methods(const SceneFile& scene, std::string_view key, const Until& until, const AfterRun& after_run) {
    const LessonEntry& entry = find_lesson(scene.lesson);
    const Runner r(entry, scene.parameters, 0);
    const Parameter& choice = choice_of(r, scene, key);
    return Comparing(scene, choice, steps_of(entry, scene, until)).compare(choice.info.options, after_run);
}

std::optional<Real> seconds_to_compare(const SceneFile& scene, std::string_view key, const Until& until) {
    const LessonEntry& entry = find_lesson(scene.lesson);
    const Runner r(entry, scene.parameters, 0);
    const Parameter& choice = choice_of(r, scene, key);
    if (r.is_static()) return std::nullopt;
    return Comparing(scene, choice, steps_of(entry, scene, until)).seconds(choice.info.options);
}

std::string_view name_of(MethodRun::Outcome outcome) {
    switch (outcome) {
        case MethodRun::Outcome::steady:
            return "steady";
        case MethodRun::Outcome::loses:
            return "loses energy";
        case MethodRun::Outcome::grows:
            return "grows";
        case MethodRun::Outcome::finished:
            return "finished";
        case MethodRun::Outcome::stopped:
            return "stopped";
        case MethodRun::Outcome::refused:
            return "refused";
    }
    return "";
}

}  // namespace pliant
