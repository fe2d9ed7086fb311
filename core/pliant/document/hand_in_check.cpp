// Repeats what was measured in a hand-in, and reports it.
#include <pliant/document/hand_in.h>
#include <pliant/document/share.h>
#include <pliant/document/summary.h>
#include <pliant/text/format.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;
using Entry = HandInEntry;
constexpr Real comes_out_within = 1e-6;  // relative

std::string place_of(const Entry& e) {
    return fmt::format("{}, {} (t = {})", e.lesson, place_words({e.step, e.passes}), format_quantity(e.time, "s"));
}

HandInFinding repeated(const Entry& e) try {
    const SceneFile scene = read_share(e.scene);
    if (scene.lesson != e.lesson)
        return {true, false, fmt::format("the scene is one of {}, and the entry names {}", scene.lesson, e.lesson)};
    Runner runner(find_lesson(scene.lesson), scene.parameters, 0);
    runner.set_events(scene.events);
    while (runner.place().step < e.step) runner.step();
    while (runner.place().passes < e.passes && runner.place().step == e.step) runner.step_pass();
    const Real value = runner.value(e.probe);
    const Real off = std::abs(value - e.value), scale = std::max(std::abs(value), std::abs(e.value));
    const std::string name = fmt::format("{} in {}", spoken(e.probe), place_of(e));
    if (off <= comes_out_within * scale)
        return {true, true, fmt::format("{}: {} comes out", name, format_quantity(e.value, e.unit))};
    return {true, false,
            fmt::format("{}: {} is handed in, and {} comes out", name, format_quantity(e.value, e.unit),
                        format_quantity(value, e.unit))};
} catch (const Diverged& d) {
    return {true, false, fmt::format("{} in {}: the run does not get there: {}", spoken(e.probe), place_of(e), d.what())};
} catch (const Refused& r) {
    return {true, false, fmt::format("{} in {}: {}", spoken(e.probe), place_of(e), r.what())};
}

// What the person says of the answer.
std::string said_of(const Entry& e) {
    const std::string_view own = !e.own_verdict ? "" : *e.own_verdict ? " (“I was right”)" : " (“I was not right”)";
    return fmt::format("{}{}", own, e.after_answer ? " (after the answer)" : "");
}

HandInFinding repeated_or_told(const Entry& e, const RepeatClaim& claim) try {
    if (claim)
        if (const auto finding = claim(e)) return *finding;
    if (!e.scene.empty()) return repeated_prediction(e);
    return {false, true, fmt::format("prediction, {}, {}: {}", e.lesson, e.slide, e.text)};
} catch (const Error& error) {
    return {true, false, fmt::format("prediction, {}, {}: it cannot be played again: {}", e.lesson, e.slide, error.what())};
}

HandInFinding told(const Entry& e, const RepeatClaim& claim) {
    switch (e.kind) {
        case Entry::Kind::prediction:
            return repeated_or_told(e, claim);
        case Entry::Kind::answer:
            return {false, true,
                    fmt::format("answer, {}{}{}: {}{}", e.lesson, e.slide.empty() ? "" : ", ", e.slide, e.text, said_of(e))};
        case Entry::Kind::picture:
            return {false, true, fmt::format("picture of {}{}{}", place_of(e), e.text.empty() ? "" : ": ", e.text)};
        case Entry::Kind::measurement:
            break;
    }
    return repeated(e);
}

bool all_hold(const HandInRead& read, const std::vector<HandInFinding>& findings) {
    return read.unchanged && std::ranges::all_of(findings, &HandInFinding::holds);
}

}  // namespace

std::vector<HandInFinding> check_hand_in(const HandIn& h, const RepeatClaim& claim) {
    std::vector<HandInFinding> findings;
    for (const Entry& e : h.entries) findings.push_back(told(e, claim));
    return findings;
}

std::string hand_in_report(const HandInRead& read, const std::vector<HandInFinding>& findings) {
    const HandIn& h = read.hand_in;
    std::string text = fmt::format("Handed in by {}: {} {}\n", h.name.empty() ? "nobody who gave a name" : h.name,
                                   h.entries.size(), h.entries.size() == 1 ? "entry" : "entries");
    text += read.unchanged
                ? "The file is as it was saved. (The checksum tells a change by hand; it cannot tell who made the file, nor that "
                  "nobody computed it anew.)\n"
                : "The file was changed after it was saved: its checksum is not that of what it says.\n";
    for (const HandInFinding& f : findings) text += fmt::format("  {} {}\n", !f.repeated ? "·" : f.holds ? "✓" : "✗", f.words);
    const auto predicted = [](const Entry& e, bool after) {
        return e.kind == Entry::Kind::prediction && e.after_answer == after;
    };
    const auto right = std::ranges::count_if(h.entries, [&](const Entry& e) { return predicted(e, false) && e.right; });
    const auto asked = std::ranges::count_if(h.entries, [&](const Entry& e) { return predicted(e, false); });
    const auto late = std::ranges::count_if(h.entries, [&](const Entry& e) { return predicted(e, true); });
    if (asked > 0) text += fmt::format("{} of {} {} right.\n", right, asked, asked == 1 ? "prediction was" : "predictions were");
    if (late > 0)
        text += fmt::format("{} {} made after the answer was seen.\n", counted(late, "prediction"), late == 1 ? "was" : "were");
    return text;
}

std::string hand_in_report_json(const HandInRead& read, const std::vector<HandInFinding>& findings) {
    Json j{{"name", read.hand_in.name},
           {"unchanged", read.unchanged},
           {"holds", all_hold(read, findings)},
           {"entries", Json::array()}};
    for (std::size_t k = 0; k < findings.size(); ++k) {
        const Entry& e = read.hand_in.entries[k];
        Json entry{
            {"lesson", e.lesson}, {"repeated", findings[k].repeated}, {"holds", findings[k].holds}, {"words", findings[k].words}};
        if (e.own_verdict) entry["own_verdict"] = *e.own_verdict ? "right" : "not right";
        if (e.after_answer) entry["after_answer"] = true;
        if (!e.probe.empty()) entry["probe"] = e.probe, entry["value"] = e.value;
        j["entries"].push_back(std::move(entry));
    }
    return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace pliant
