#include "app/presenter_view.h"

#include <pliant/document/summary.h>
#include <pliant/text/format.h>

#include "app/lecture_slide.h"
#include "panels/typeset_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <vector>

namespace pliant::viewer {
namespace {

std::string words_of_block(const Slide& slide, BlockKind kind) {
    std::string text;
    for (const Block& b : slide.blocks)
        if (b.kind == kind) text += (text.empty() ? "" : "\n") + without_marks(b.paragraph());
    return text;
}

// What the next press does.
std::string next_press_of(const LabState& lab) {
    const WalkthroughPlayer& player = *lab.session.walkthrough;
    const Slide& slide = player.slide();
    if (next_shows_more(lab)) return shown_by_slide(lab) == ShownBySlide::claim ? "measures the claim" : "makes the map";
    if (!player.revealed()) {
        const bool runs = slide.has(BlockKind::actions), answers = slide.has(BlockKind::answer);
        return runs && answers ? "runs, and shows the answer" : runs ? "runs" : answers ? "shows the answer" : "ends this slide";
    }
    const std::size_t next = lab.session.slide_number() + 2, count = lab.session.slide_count();
    return next <= count ? fmt::format("turns to slide {}", next) : "nothing: this is the last slide";
}

// Of each slide: what a lecture says, else what its notes begin with.
std::vector<std::optional<Real>> minutes_of_slides(const Session& s) {
    std::vector<std::optional<Real>> all;
    if (const Lecture* lecture = s.lecture()) {
        for (const LectureSlide& slide : lecture->slides)
            all.push_back(slide.minutes > 0 ? slide.minutes : planned_minutes(slide.slide.notes()));
        return all;
    }
    for (const Slide& slide : s.walkthrough->walkthrough().slides) all.push_back(planned_minutes(slide.notes()));
    return all;
}

void tell_minutes(PresenterView& view, const Session& s) {
    const auto minutes = minutes_of_slides(s);
    Real so_far = 0, all = 0;
    for (std::size_t i = 0; i < minutes.size(); ++i) {
        all += minutes[i].value_or(0);
        if (i <= s.slide_number()) so_far += minutes[i].value_or(0);
    }
    if (s.slide_number() < minutes.size()) view.minutes = minutes[s.slide_number()];
    if (all > 0) view.minutes_so_far = so_far, view.minutes_in_all = all;
}

void tell_slide(PresenterView& view, const LabState& lab) {
    const Session& s = lab.session;
    const Slide& slide = s.walkthrough->slide();
    view.number = s.slide_number() + 1, view.count = s.slide_count();
    view.title = slide.title;
    view.notes = without_marks(slide.notes());
    if (view.notes.empty()) view.notes = "This slide has no notes.";
    view.question = words_of_block(slide, BlockKind::ask);
    view.answer = words_of_block(slide, BlockKind::answer);
    view.next_press = next_press_of(lab);
    if (const Slide* next = s.slide_after()) {
        view.next_title = next->title;
        const std::string text = words_of_block(*next, BlockKind::text);
        view.next_words = text.empty() ? words_of_block(*next, BlockKind::ask) : text;
    }
    tell_minutes(view, s);
}

void tell_readings(PresenterView& view, const LabState& lab) {
    const auto probes = key_probes(lab.session.lesson());
    const auto& held = lab.held.key_numbers;
    for (std::size_t k = 0; k < probes.size() && k < held.size(); ++k) {
        const auto& [value, exact, awaits] = held[k];
        view.readings.push_back({named_with_symbol(probes[k]->name, probes[k]->symbol, "  "),
                                 !awaits.empty() ? "—"
                                 : value         ? format_quantity(*value, probes[k]->unit)
                                                 : "undefined",
                                 exact ? fmt::format("exact {}", format_quantity(*exact, probes[k]->unit)) : ""});
    }
}

}  // namespace

std::optional<Real> planned_minutes(std::string_view notes) {
    constexpr std::array<std::string_view, 13> numbers{"Half a", "One",   "Two",  "Three", "Four",   "Five",  "Six",
                                                       "Seven",  "Eight", "Nine", "Ten",   "Eleven", "Twelve"};
    const std::size_t end = notes.find(" minute");
    if (end == std::string_view::npos || end == 0) return {};
    const std::string_view number = notes.substr(0, end);
    const auto named = std::ranges::find(numbers, number);
    if (named == numbers.begin()) return 0.5;
    if (named != numbers.end()) return static_cast<Real>(named - numbers.begin());
    int digits = 0;
    const auto [stop, error] = std::from_chars(number.data(), number.data() + number.size(), digits);
    return error == std::errc() && stop == number.data() + number.size() ? std::optional<Real>(digits) : std::nullopt;
}

PresenterView presenter_view(const LabState& lab) {
    const Session& s = lab.session;
    PresenterView view;
    view.lesson = std::string(s.entry().info.title);
    view.in_deck = lab.layout == Layout::deck || lab.layout == Layout::presenter;
    view.black = lab.black, view.filled = static_cast<bool>(lab.fill);
    if (s.walkthrough) tell_slide(view, lab);
    tell_readings(view, lab);
    const Runner& r = s.runner();
    const std::string time =
        r.is_static() ? fmt::format("step {}", r.place().step) : fmt::format("t = {}", format_quantity(r.time(), "s", 3));
    view.now = fmt::format("{}, the run {}", time, s.playing ? "goes on" : s.under_way() ? "computes a step" : "stands");
    if (s.message()) view.message = s.message()->text;
    return view;
}

}  // namespace pliant::viewer
