// What a person looks into: where the run is to stop, what a stage found and left, the thing that was picked, and how its numbers
// came about. It draws nothing.
#pragma once
#include <pliant/run/breakpoints.h>
#include <pliant/run/time_series.h>
#include <pliant/run/why.h>

#include "render/palette.h"

#include <optional>
#include <string>
#include <vector>

namespace pliant::viewer {

// What the picture and the profiles show of a stage: its result, what it found, or what it changed.
enum class Compare { now, before, difference, side_by_side, swipe };
std::string_view name_of(Compare compare);

// A node, element, cell, ... that has been picked.
struct Thing {
    On on = On::node;
    Index index = 0;
    bool operator==(const Thing&) const = default;
};

// A quantity followed over time, from when it was pinned.
struct Pin {
    std::string field;
    Index index = 0;
    int component = -1;
    std::string title, unit;
    Index from = 0;  // the whole step that it was followed from
    TimeSeries series{};
};

class Inspector {
public:
    Breakpoints breaks;
    std::string stopped;  // why the run stopped last; "" when it was not stopped

    // --- a stage: before and after ---
    Compare compare = Compare::now;
    std::string stage;  // whose; "" for the one that ran last
    float swipe = 0.5f;
    StepTrace trace;
    // The stage that is compared: empty before any has run.
    const Stage* shown_stage(const Runner& runner) const;
    // Makes sure that the trace belongs to the place where the run stands.
    void renew_trace(Runner& runner);
    // The numbers of a field that the shown stage found; empty where there are none.
    std::span<const Real> before(const Runner& runner, std::string_view field) const;
    // What the stage changed, one number per row: of a vector the length of the difference when component is -1.
    std::optional<std::vector<Real>> change(const Runner& runner, const Field& field, int component) const;
    // The picture as the shown stage found it, drawn by the lesson into `picture`; false when it is no longer stored.
    bool draw_before(Runner& runner, Scene& picture) const;

    // --- a thing, and its numbers over time ---
    std::optional<Thing> thing;
    std::vector<Pin> pins;
    void pin(const Runner& runner, const Field& field, Index index, int component);
    bool pinned(std::string_view field, Index index, int component) const;
    void unpin(std::size_t k) { pins.erase(pins.begin() + static_cast<std::ptrdiff_t>(k)); }
    void record(const Runner& runner);
    // Time, and a column per pinned quantity with its unit.
    std::string pins_csv(bool has_clock) const;
    // Every quantity of the picked thing: name, component, value, unit.
    std::string thing_csv(const Lesson& lesson) const;

    // --- why ---
    // The questions that led here; the last is answered.
    struct Asked {
        std::string field;
        Index index = 0;
        int component = -1;
        std::optional<When> when{};
        std::string title{};
    };
    std::vector<Asked> asked;
    std::optional<Answer> answer;
    // Throw Refused.
    void ask(Runner& runner, Asked question);
    void ask_back(Runner& runner);
    // The question again, where the run stands now.
    void ask_again(Runner& runner);

    // Another lesson or another run: what belonged to the one before goes. Breakpoints stay in the same lesson.
    void forget_run();
    void forget_lesson();

private:
    void answer_last(Runner& runner);
};

}  // namespace pliant::viewer
