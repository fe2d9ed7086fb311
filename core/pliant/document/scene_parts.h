// What a scene holds beside its lesson, parameters and events: where the run stands, what stands beside it, and how all of it is
// looked at. Every part is optional, and what is at its default is not written.
#pragma once
#include <pliant/document/prediction.h>
#include <pliant/run/runner.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

struct Camera {
    Vec<3> target = Vec<3>::Zero();  // m
    Real distance = 1;               // m; in 2D the height of what is seen
    Real yaw = 0, pitch = 0;         // rad
    bool operator==(const Camera&) const = default;
};

// What is done to a run where it stands, and no step has seen yet.
struct SceneChanges {
    Runner::Assignments set{};
    std::optional<Pull> pull{};
    bool release = false;
    bool empty() const { return set.empty() && !pull && !release; }
    bool operator==(const SceneChanges&) const = default;
};

// How far a run has come: it is run again to there.
struct ScenePlace {
    static constexpr Index most_steps = 10'000'000, most_passes = 1'000'000;
    Index step = 0, passes = 0;
    SceneChanges changes{};
    bool fails = false;  // the next pass breaks down
    Place place() const { return {step, passes}; }
    bool operator==(const ScenePlace&) const = default;
};

// A run of the lesson by itself.
struct SceneRun {
    Runner::Assignments parameters{};
    std::vector<Event> events{};
    ScenePlace place{};
    bool operator==(const SceneRun&) const = default;
};

// The run pinned behind the present one, and what coloured its picture.
struct ScenePinned {
    SceneRun run{};
    std::string field{};
    int component = -1;
    bool operator==(const ScenePinned&) const = default;
};

// The second run, B. Its place follows from that of A.
struct SceneBeside {
    Runner::Assignments set{};                   // other values at the start than those of A
    std::optional<std::vector<Event>> events{};  // those of A when not given
    SceneChanges changes{};
    bool addressed = false;   // the sliders set B
    bool difference = false;  // A − B is shown
    bool operator==(const SceneBeside&) const = default;
};

inline constexpr std::array<std::string_view, 5> scene_comparisons{"now", "before", "difference", "side by side", "swipe"};

struct SceneView {
    std::string field{};  // that colours the picture
    int component = -1;
    std::string stage{};                     // to stop after, in the step being shown
    std::optional<Interval> range{};         // of the colours, where it is not that of the numbers now
    bool diverging = false;                  // the colours of that range go apart from its middle
    bool fixed = false;                      // that range stays
    std::optional<Interval> change_range{};  // likewise of what a stage changed
    bool change_diverging = false;
    bool arrows = true, labels = true, smooth = true, patterns = false, extreme = false;
    std::string compare = "now";  // one of scene_comparisons
    std::string of_stage{};       // what the comparison is of; "" for the stage that ran last
    Real swipe = 0.5;             // where the line of a swipe is, 0 to 1
    bool operator==(const SceneView&) const = default;
};

struct SceneStops {
    std::vector<std::string> stages{}, passes{}, conditions{};
    bool assumptions = false, laws = false;
    bool empty() const { return *this == SceneStops{}; }
    bool operator==(const SceneStops&) const = default;
};

// A number of the run: of a field, or of a probe.
struct SceneNumber {
    std::string field{};
    Index index = 0;
    int component = -1;
    std::optional<Place> when{};  // asked of the past
    Index from = 0;               // the step from which it is followed
    bool operator==(const SceneNumber&) const = default;
};

struct SceneInspector {
    std::string on{};  // "node"; "" when nothing is picked
    Index index = 0;
    std::vector<SceneNumber> asked{};   // the questions that led to the last
    std::vector<SceneNumber> pinned{};  // followed over time
    bool empty() const { return *this == SceneInspector{}; }
    bool operator==(const SceneInspector&) const = default;
};

struct SceneSlide {
    std::size_t number = 1;     // from 1
    std::size_t extension = 0;  // that is open, from 1; 0 for the walkthrough
    bool revealed = false, unlocked = false;
    std::string lecture{};  // the file, or name, of a lecture whose slide it is; "" for the lesson's walkthrough
    Guess predicted{};      // on the slide
    bool operator==(const SceneSlide&) const = default;
};

inline constexpr std::array<std::string_view, 3> scene_layouts{"lab", "slide", "deck"};
inline constexpr std::array<std::string_view, 5> scene_tabs{"plots", "inspect", "claims", "atlas", "methods"};

struct SceneLayout {
    std::string layout = "lab";  // one of scene_layouts
    std::string tab = "plots";   // one of scene_tabs
    std::string claim{};         // the id of the card that is unfolded
    std::string fill{};          // what alone is on the screen: "picture", "matrix", "atlas", "plot NAME"; "" for none
    bool operator==(const SceneLayout&) const = default;
};

// What a person has set of a plot.
struct ScenePlot {
    std::string name{};  // of a probe or a line, "along", "map", or "pin 1" of the first number that is followed
    std::optional<Interval> x{}, y{};
    std::optional<bool> x_log{}, y_log{};
    std::vector<std::string> hidden{};  // names of curves
    bool operator==(const ScenePlot&) const = default;
};

struct ScenePlots {
    std::optional<std::vector<std::string>> shown{};  // names as those of ScenePlot; those of the lesson when not given
    std::vector<ScenePlot> plots{};
    bool cost = false;  // cost and error in their place
    int axis = 0;       // of the field along a line
    std::array<Real, 2> across{0.5, 0.5};
    bool empty() const { return *this == ScenePlots{}; }
    bool operator==(const ScenePlots&) const = default;
};

// A knob of the stability atlas; without a range what its slider spans.
struct SceneKnob {
    std::string key{};
    std::optional<Interval> range{};
    bool log = false;
    bool operator==(const SceneKnob&) const = default;
};

struct SceneAtlas {
    static constexpr Index most_cells = 512, most_steps = 100'000;
    SceneKnob across{}, up{};
    std::optional<Index> cells{}, steps{};  // along each knob; of each cell
    bool operator==(const SceneAtlas&) const = default;
};

}  // namespace pliant
