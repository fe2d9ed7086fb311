// `pliant list`, `keys`, `describe`, `run`, `share` and `walkthrough`: everything that needs no picture.
#include <pliant/document/extensions.h>
#include <pliant/document/report.h>
#include <pliant/document/share.h>
#include <pliant/document/summary.h>
#include <pliant/document/walkthrough.h>
#include <pliant/run/recorder.h>
#include <pliant/study/lesson_page.h>
#include <pliant/text/file.h>

#include "command_line/grid_output.h"
#include "command_line/options.h"
#include "command_line/output_paths.h"
#include "command_line/terminal.h"
#include "panels/keys.h"
#include "session/companion.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace pliant::viewer {
namespace {

std::string joined(const std::vector<std::string>& lines) { return fmt::format("{}\n", fmt::join(lines, "\n")); }

void print_slide(std::size_t number, const Slide& slide, const std::vector<ExpectationResult>& results, bool notes) {
    print(fmt::format("\n{}. {}\n", number, slide.title));
    for (const Block& b : slide.blocks) {
        if (b.kind == BlockKind::text || b.kind == BlockKind::answer) print("  " + joined(b.lines));
        if (b.kind == BlockKind::formula) print("      " + joined(b.lines));
        if (b.kind == BlockKind::ask) print("  Predict: " + joined(b.lines));
        if (b.kind == BlockKind::actions) print("  > " + fmt::format("{}\n", fmt::join(b.lines, "\n  > ")));
    }
    if (notes && !slide.notes().empty()) print("  Notes: " + slide.notes() + "\n");
    for (const ExpectationResult& r : results) print(fmt::format("  {} {}   ({})\n", r.met ? "✓" : "✗", r.text, r.measured));
}

// What a walkthrough and its extensions expected.
struct Tally {
    int met = 0, missed = 0;
    std::string misses{};

    void add(const std::string& path, const std::vector<ExpectationResult>& results) {
        for (const ExpectationResult& r : results) {
            r.met ? ++met : ++missed;
            if (!r.met) misses += fmt::format("\n{}:{}: {} ({})", path, r.line, r.text, r.measured);
        }
    }
};

void play_extensions(const LessonEntry& entry, Tally& tally) {
    const auto extensions = extensions_of(entry);
    if (!extensions.empty()) print("\nPossibilities for extensions\n");
    std::size_t number = 0;
    for (const Extension& e : extensions) {
        const auto results = played(entry, e);
        print_slide(++number, e.slide(), results, false);
        tally.add(e.walkthrough.path, results);
    }
}

void check_table(const std::string& path) {
    refuse_other_ending("--csv", path, ".csv", "a table is written as CSV");
    check_writable(path);
}

}  // namespace

int list_lessons(bool json) {
    print(json ? list_json() : list_text());
    return 0;
}

int list_keys(bool markdown) {
    print(markdown ? keys_markdown() : keys_text());
    return 0;
}

int describe(const std::string& lesson, bool json, bool markdown, const std::string& sources) {
    const LessonEntry& entry = find_lesson(lesson);
    print(json ? lesson_json(entry) : markdown ? lesson_markdown(entry, sources) : lesson_text(entry));
    return 0;
}

namespace {

// The second run of a scene; null where it has none.
std::unique_ptr<Companion> beside_of(const LessonEntry& entry, const Runner& a, const SceneFile& scene) {
    if (!scene.beside) return nullptr;
    auto b = std::make_unique<Companion>(entry, a, scene.beside->set);
    if (scene.beside->events) b->follow_script(*scene.beside->events);
    return b;
}

// Into the step at which the scene stands, and what was done there.
void go_into_step(Runner& runner, const ScenePlace& to) {
    while (runner.place() < to.place()) runner.step_pass();
    apply_to(runner, to.changes);
}

// The names in "a,b". Throws Refused for one that the lesson has not.
std::vector<std::string> fields_from(const std::string& list, const Lesson& lesson) {
    std::vector<std::string> names;
    std::string_view rest = list;
    while (!rest.empty()) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        const std::string name(rest.substr(0, comma));
        if (!lesson.find_field(name)) lesson.field(name);
        names.push_back(name);
        rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
    return names;
}

std::string report_of(const RunOptions& o, const Runner& runner, const std::vector<UnusedSetting>& unused, const Companion* b) {
    if (o.json) return run_json(runner, unused, b ? &b->runner() : nullptr, fields_from(o.fields, runner.lesson()));
    const auto words = [&](const Runner& run) { return o.summary ? summary_text(run) : run_text(run); };
    if (!b) return words(runner);
    const std::string stopped = b->stopped().empty() ? "" : fmt::format("B stopped: {}\n", b->stopped());
    return fmt::format("A\n{}\nB\n{}{}", words(runner), stopped, words(b->runner()));
}

}  // namespace

int run(const RunOptions& options) {
    const SceneFile scene = scene_from(options);
    const LessonEntry& entry = find_lesson(scene.lesson);
    if (!options.csv_path.empty()) check_table(options.csv_path);
    Runner runner(entry, scene.parameters, 0);
    runner.set_events(scene.events);
    fields_from(options.fields, runner.lesson());
    GridOutput grids(options.vtu_path, entry, runner.lesson());
    const auto unused = tell_unused(unused_settings(scene), options.strict);
    const bool to_place = runs_to_place(options, scene);
    const Until until = to_place ? Until::after_steps(scene.place->step) : until_from(options, entry, runner.is_static());
    const auto beside = beside_of(entry, runner, scene);
    std::string csv = csv_header(runner.lesson());
    const auto record = [&] {
        if (!options.csv_path.empty()) csv += csv_row(runner);
        grids.note(runner);
        if (beside) beside->follow(runner);
    };

    std::optional<Diverged> divergence;
    try {
        record();
        advance(runner, until, record);
        if (to_place) go_into_step(runner, *scene.place);
        if (to_place && beside) beside->apply(scene.beside->changes);
        runner.check_probes();
    } catch (const Diverged& e) {
        divergence = e;
    }
    if (!options.csv_path.empty()) write_file(options.csv_path, csv);
    grids.finish(runner, divergence.has_value());
    if (divergence) runner.note_failure(divergence->failure);
    print(report_of(options, runner, unused, beside.get()));
    if (divergence) throw *divergence;
    if (until.what == Until::What::time && !runner.is_static() && std::abs(runner.time() - until.time) > 1e-9 * until.time)
        tell(fmt::format("the time was rounded to whole steps: {} s", runner.time()));
    return 0;
}

int share(const RunOptions& options) {
    const SceneFile scene = scene_from(options);
    const Runner checked(find_lesson(scene.lesson), scene.parameters, 0);
    tell_unused(unused_settings(scene), options.strict);
    print(share_text(scene) + "\n");
    return 0;
}

int walkthrough(const std::string& lesson, const WalkthroughOptions& o) {
    const LessonEntry& entry = find_lesson(lesson);
    Runner runner(entry);
    WalkthroughPlayer player(runner, walkthrough_of(entry));
    tell_unused(unused_settings(entry, player.walkthrough()), o.strict);
    print(player.walkthrough().title + "\n");
    Tally tally;
    bool more = true;
    while (more) {
        const std::size_t slide = player.slide_number();
        const bool was_revealed = player.revealed();
        more = player.next();
        if (player.slide_number() != slide || (was_revealed && !more) || (!more && !player.revealed())) continue;
        print_slide(slide + 1, player.slide(), player.results(), o.notes);
        tally.add(player.walkthrough().path, player.results());
    }
    play_extensions(entry, tally);
    print(fmt::format("\n{} expectations met, {} missed\n", tally.met, tally.missed));
    if (o.check && tally.missed) throw CheckFailed("the walkthrough misses what it expects:" + tally.misses);
    return 0;
}

}  // namespace pliant::viewer
