// The lesson contract. A lesson declares its parameters, state, fields, stages, probes, lines, assumptions and conserved
// quantities as data; sliders, command-line flags, scene files, plots, documentation and tests follow from these declarations
// alone.
//
// The Runner is the only one that advances a lesson: it runs the stages of a step in their order, one pass at a time if asked.
#pragma once
#include <pliant/lesson/array.h>
#include <pliant/lesson/parameter.h>
#include <pliant/lesson/scene.h>
#include <pliant/math/error.h>
#include <pliant/math/types.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pliant {

// A symbol of formulas that is no parameter, field or probe, or that means something else in them, and its unit; "" of a number.
struct Symbol {
    std::string_view symbol, unit = "";
};

// A pause point inside one time step.
//
// A stage runs once, unless `again` is given: then `run` is one pass of an inner loop (a Newton iteration, a solver sweep), and
// after each pass `again` tells whether another one follows. With `loop_from` the loop goes back to that earlier stage instead,
// so that several stages form one loop body. `begin` runs before the first pass and `end` after the last.
struct Stage {
    std::string_view name;          // key: "advection"
    std::string_view formula = "";  // what it evaluates, in symbols
    // The part of it that holds as the parameters are, where it says several things; empty: the whole.
    std::function<std::string_view()> formula_in_force{};
    std::string_view source = "";  // lecture, paper, section, equation
    // Where its work is done, for the page of the lesson: "core/pliant/solids/rod.cpp: rod_strains", or several functions of a
    // file, parted by commas.
    std::string_view code = "";
    std::function<void()> run;
    std::vector<std::string_view> reads{}, writes{};  // names of fields, or of probes that a stage measures
    std::function<bool()> active{};                   // a term that the scene lacks is not run; always active when empty
    std::function<bool()> again{};
    std::string_view loop_from = "";
    std::function<void()> begin{}, end{};
    // How a number of a field (or probe) that it writes came about; called right after one of its passes. Empty for a field that
    // this pass has not written yet: what is applied in `end` while the loop still runs.
    std::function<std::optional<Explanation>(const Question&)> explain{};

    std::vector<Symbol> symbols{};  // of its formula, beside those of the lesson

    bool in_use() const { return !active || active(); }
    std::string_view formula_now() const { return formula_in_force ? formula_in_force() : formula; }

    // For declarations of a few lines: stage_of(…).done_in("core/…: f").maps({"u"}, {"force"}).because(…).when(…)
    Stage done_in(std::string_view places) const;  // `code`
    Stage where(std::vector<Symbol> of_formula) const;
    Stage maps(std::vector<std::string_view> from, std::vector<std::string_view> to) const;
    Stage because(std::function<std::optional<Explanation>(const Question&)> why) const;
    Stage when(std::function<bool()> runs) const;
    Stage shows(std::function<std::string_view()> formula_that_holds) const;
    // One pass of a loop; what runs before the first and after the last one.
    Stage repeats(std::function<bool()> goes_on, std::function<void()> before = {}, std::function<void()> after = {}) const;
    // The last of several stages that form one loop, which goes back to an earlier one.
    Stage loops_from(std::string_view first, std::function<bool()> goes_on) const;
};
Stage stage_of(std::string_view name, std::string_view formula, std::string_view source, std::function<void()> run);

// A number to watch. `value` is empty where the quantity is not defined (a slope through one point). `exact` is the closed form
// at time t, where one exists.
struct Probe {
    std::string_view name, symbol = "", unit = "", help = "";
    std::function<std::optional<Real>()> value;
    std::function<std::optional<Real>(Real t)> exact{};
    // How it follows from fields and parameters now.
    std::function<Explanation()> explain{};
    std::string_view formerly = "";  // the name that it had in older scenes, whose conditions still hold

    // For declarations of a few lines: probe_of(…).exactly(…). Where it is not defined it has neither a value nor a closed form.
    Probe exactly(std::function<std::optional<Real>(Real t)> closed_form) const;
    Probe exactly(std::function<std::optional<Real>()> at_all_times) const;
    Probe when(std::function<bool()> defined) const;
    Probe once(std::string_view name_before) const;
    // It is what the formula gives: of parameters, parts, numbers of fields (Input::now, or Input::all_of under one symbol),
    // other probes, and Input::live. Fields and probes are looked up when it is first asked for.
    Probe formula(const Lesson& lesson, FormulaText text, std::vector<Input> inputs) const;
    Probe formula(const Lesson& lesson, Explanation text_and_inputs) const;
};
Probe probe_of(std::string_view name, std::string_view symbol, std::string_view unit, std::string_view help);
Probe probe_of(std::string_view name, std::string_view symbol, std::string_view unit, std::string_view help,
               std::function<std::optional<Real>()> value, std::function<Explanation()> why = {});

// A curve sampled now: a field along a line, or one measured quantity against another.
struct Curve {
    std::vector<Real> position, value;

    void add(Real at, Real number) { position.push_back(at), value.push_back(number); }
    // f at so many places, two at least, from one end to the other, both included.
    void add_range(Real from, Real to, int places, const std::function<Real(Real)>& f);
};
// The points that `sample` gives; none where its computation gives up (Diverged) or there is none: a curve beside a run never
// takes the run's own numbers along.
Curve curve_of(const std::function<void(Curve&)>& sample);

// One more curve in the picture of a line: a rival model, a mark at the present value.
struct CompareCurve {
    std::string_view name;
    std::function<void(Curve&)> sample;  // nothing to draw when it gives no point
    bool points = false;                 // draw points rather than a curve
};
struct Line {
    std::string_view name, unit = "", position_name = "", position_unit = "", help = "";
    std::function<void(Curve&)> sample;
    std::function<void(Curve&)> reference{};  // exact, or published, values to draw beside it
    std::string_view reference_name = "exact";
    std::string_view value_name = "";  // of the axis of values; the line's own name when not given
    bool reference_points = false;     // draw the reference as points (a table) rather than as a curve
    bool log_log = false;              // both axes logarithmic at first; what is not positive is left out
    std::function<bool()> used{};
    std::vector<CompareCurve> others{};  // drawn beside both

    bool in_use() const { return !used || used(); }

    // For declarations of a few lines: line_of(…).against("closed form", …).beside({…}).when(…)
    Line against(std::string_view what, std::function<void(Curve&)> curve, bool as_points = false) const;
    Line beside(std::vector<CompareCurve> curves) const;
    Line measures(std::string_view name_of_values) const;
    Line on_log_axes() const;
    Line when(std::function<bool()> uses) const;
};
Line line_of(std::string_view name, std::string_view unit, std::string_view position_name, std::string_view position_unit,
             std::string_view help, std::function<void(Curve&)> sample);

// Parameters that would mend what went wrong, as one button: "Δt = 5 ms".
struct Fix {
    std::string label;
    std::vector<std::pair<std::string, std::string>> assign;  // key, value as text
};
// One parameter at another value, labelled with its symbol.
Fix fix_by(const Parameter& parameter, Real value);

// A condition under which the model or the method is valid: value ≤ limit. `broken` says what goes wrong beyond the limit.
struct Assumption {
    std::string_view name, unit = "";
    std::function<Real()> value, limit;
    std::string_view formula = "", broken = "";
    std::function<bool()> used{};
    std::function<std::optional<Fix>()> fix{};  // asked for when it is broken
    std::string_view otherwise_named = "";      // what there is when it is broken: "locking" for "no locking"

    bool in_use() const { return !used || used(); }

    // For declarations of a few lines: assumption_of(…).otherwise(…).when(…).mended_by(…)
    Assumption otherwise(std::string_view name_when_broken) const;
    Assumption when(std::function<bool()> uses) const;
    Assumption mended_by(std::function<std::optional<Fix>()> asked) const;
    Assumption mended_by(Fix always) const;
};
Assumption assumption_of(std::string_view name, std::string_view unit, std::function<Real()> value, std::function<Real()> limit,
                         std::string_view formula, std::string_view broken);

enum class Law { constant, never_grows, zero };

// A probe that should obey a law while `expected` says so. Tolerances are in the unit of the probe.
//
// What should stay constant or never grow is measured against the moment at which the law begins to hold, and so is its
// tolerance: it is asked for then, once, so that a run that blows up cannot widen it. That of a law `zero` is asked for now: a
// part of what has to cancel. `cancels` is the size of the terms whose sum the probe is, now; to the tolerance comes the part
// of it that is lost to rounding.
struct Conserved {
    std::string_view probe;
    Law law = Law::constant;
    std::function<Real()> tolerance;
    std::function<bool()> expected{};
    std::function<Real()> cancels{};
};

// A person's hand in the scene: something picked (index < 0: a place, not a thing) at `from`, now drawn to `to`, in metres.
struct Pull {
    Index index = -1;
    Vec<3> from = Vec<3>::Zero(), to = Vec<3>::Zero();
    bool operator==(const Pull&) const = default;
};

struct UnstructuredGrid;

class Lesson {
public:
    // First, since parameters join it as they are made.
    std::vector<Parameter*> parameters;
    std::vector<StateArray> state;
    std::vector<Field> fields;
    std::vector<Stage> stages;
    std::vector<Probe> probes;
    std::vector<Line> lines;
    std::vector<Assumption> assumptions;
    std::vector<Conserved> conserved;
    std::vector<Symbol> formula_symbols;  // of the formulas of all its stages

    Lesson() = default;
    Lesson(const Lesson&) = delete;
    Lesson& operator=(const Lesson&) = delete;
    virtual ~Lesson() = default;

    // 2 or 3, of the picture.
    virtual int dimension() const = 0;

    // Refuses combinations of parameters that are each legal alone. Throws Refused.
    virtual void check() const {}

    // The names of the stages in the order in which they run, where the parameters make it another than that of `stages`, which
    // never move. Stages that it leaves out come last. Takes effect with the next step.
    virtual std::vector<std::string_view> stage_order() const { return {}; }

    // The initial state, from the parameters alone: two resets give equal bits. Every field in use has its size and finite
    // numbers afterwards.
    virtual void reset() = 0;

    // A parameter that only chooses what is looked at (Effect::look) has another value. What stages have made for the former one
    // is made again for this one, in place; nothing that goes into a later number may depend on it.
    virtual void looked() {}

    // Size of a step in s; 0 for a static lesson, whose step is one whole solve.
    virtual Real time_step() const = 0;

    // Nothing changes any more: a static lesson after its solve, a body that lies still, a flow that is steady. Known after any
    // whole step, from the parameters and the state.
    virtual bool at_rest() const { return false; }
    // Why this scene never comes to rest, as a sentence without its full stop; empty where it does. A run to rest is refused
    // with it. A lesson that moves says here what keeps it going, or overrides at_rest().
    virtual std::string unrest() const { return time_step() > 0 ? "nothing is known of a state that it stays in" : ""; }

    // The picture of now, coloured by scene.colour_by.
    virtual void draw(Scene& scene) const = 0;

    // The body, or the grid, as it is now, for files that other programs read (unstructured_grid.h); none by default.
    virtual std::optional<UnstructuredGrid> unstructured_grid() const;

    // What can be pulled; empty when nothing can.
    virtual std::optional<On> can_pull() const { return std::nullopt; }
    // Takes effect in the steps that follow, until released (empty).
    virtual void pull(const std::optional<Pull>&) {}

    // Parameters that a pull sets, as a slider would, and their values: a point that the person places, an angle. What is
    // pulled is then a handle, and pull() is not called. Values outside the accepted ranges are drawn to the nearest end.
    virtual std::vector<std::pair<std::string, Real>> dragged(const Pull&) const { return {}; }

    // The limit that was exceeded and what to do: "Δt = 0.01 s is above the stability limit 2/ω = 0.004 s: lower time_step or
    // ...".
    virtual std::string blow_up_hint() const { return ""; }

    // What would have prevented a blow-up, with the parameters as they are; empty when nothing is known.
    virtual std::optional<Fix> fix(const Failure&) const { return std::nullopt; }
    // What else the hint recommends, each a button behind that of fix().
    virtual std::vector<Fix> other_fixes(const Failure&) const { return {}; }

    // Parameters of a finer run of the same scene, to measure errors against where no closed form exists; empty when none makes
    // sense.
    virtual std::vector<std::pair<std::string, std::string>> finer() const { return {}; }
    // The probe whose error stands for the method's; by default the first with a closed form, else the first key number.
    virtual std::string_view error_probe() const;

    // The field that the picture is coloured by at first; "" for none.
    virtual ColourBy first_colours() const { return {}; }
    // The probes and lines that a lecturer would show first, at most three.
    virtual std::vector<std::string_view> first_plots() const { return {}; }

    // Keys of the two parameters that the stability atlas opens with, across and up; without them it chooses.
    virtual std::vector<std::string_view> map_knobs() const { return {}; }

    // The probes that a lecturer would read out, at most three, to show in large type.
    virtual std::vector<std::string_view> key_numbers() const { return {}; }

    // Those of a group, in the order in which they are declared.
    std::vector<const Parameter*> parameters_of(Group group) const;
    // The groups that the lab unfolds at first, where it cannot show all: those that a lecturer would go to.
    virtual std::vector<Group> first_groups() const { return {Group::scene, Group::method, Group::material}; }

    // The stages that the scene uses, in the order in which they run.
    std::vector<const Stage*> stages_in_use() const;

    // How a declared probe came about, where that is said apart from it. Throws Refused for an unknown one.
    void explain_probe(std::string_view name, std::function<Explanation()> why);

    // Also by the key, or the name, that it had before.
    Parameter& parameter(std::string_view key) const;      // throws Refused, with the nearest known key
    const Field& field(std::string_view name) const;       // throws Refused, likewise; names fields in use
    const Probe& probe(std::string_view name) const;       // throws Refused, likewise
    const Field* find_field(std::string_view name) const;  // null when there is none
};

}  // namespace pliant
