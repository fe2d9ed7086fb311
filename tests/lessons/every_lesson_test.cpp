// What must hold for every lesson, whatever it teaches. A new lesson is tested by being registered.
#include "../every_lesson.h"

#include <pliant/document/report.h>
#include <pliant/document/scene_file.h>
#include <pliant/document/walkthrough.h>
#include <pliant/run/runner.h>
#include <pliant/run/until.h>
#include <pliant/text/texts.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_range.hpp>

#include <bit>
#include <cmath>
#include <filesystem>
#include <regex>
#include <set>

using namespace pliant;
using namespace pliant::test;

namespace {

const LessonEntry& any_lesson() { return GENERATE(from_range(every_lesson())); }

void check_finite(const Runner& runner) {
    for (const Field& f : runner.lesson().fields) {
        if (!f.in_use()) continue;
        INFO("field " << f.name);
        REQUIRE(f.view().size() % static_cast<std::size_t>(f.components) == 0);
        REQUIRE(std::ranges::all_of(f.view(), [](Real x) { return std::isfinite(x); }));
    }
    for (const StateArray& a : runner.lesson().state)
        REQUIRE(std::ranges::all_of(a.view(), [](Real x) { return std::isfinite(x); }));
    for (const Probe& p : runner.lesson().probes) REQUIRE_NOTHROW(runner.value(p));
}

// Of the state and of every field that follows from it.
std::uint64_t hash_of_all(const Lesson& lesson) {
    std::uint64_t hash = state_hash(lesson);
    for (const Field& f : lesson.fields)
        if (f.in_use())
            for (const Real x : f.view()) hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3u;
    return hash;
}

// A few steps, or the whole of a static lesson.
Index some_steps(const Runner& runner) { return runner.is_static() ? 1 : 10; }

}  // namespace

// tests/cases.cmake.in goes by the same files.
TEST_CASE("every lesson has a walkthrough, by which ctest knows it") {
    std::set<std::string> registered, found{"time/bead_chain"};  // the example of the developer guide has none
    for (const LessonEntry& entry : lessons()) registered.insert(std::string(entry.info.id));
    const std::filesystem::path root(PLIANT_SOURCE_DIR "/lessons");
    for (const auto& file : std::filesystem::recursive_directory_iterator(root))
        if (file.path().filename() == "walkthrough.md")
            found.insert(std::filesystem::relative(file.path().parent_path(), root).generic_string());
    CHECK(registered == found);
}

TEST_CASE("every lesson: the declaration is complete and its names are unique", "[every_lesson]") {
    const LessonEntry& entry = any_lesson();
    INFO(entry.info.id);
    const auto lesson = entry.make();
    CHECK_FALSE(entry.info.title.empty());
    CHECK_FALSE(entry.info.summary.empty());
    CHECK(entry.info.id.find('/') != std::string_view::npos);

    std::set<std::string_view> keys, fields;
    for (const Parameter* p : lesson->parameters) {
        INFO(p->info.key);
        CHECK(keys.insert(p->info.key).second);
        CHECK(p->accepted().contains(p->info.initial));
        CHECK(p->info.useful.min <= p->info.useful.max);
        if (p->info.scale == Scale::log) CHECK(p->info.useful.min > 0);
    }
    for (const Field& f : lesson->fields) CHECK(fields.insert(f.name).second);
    CHECK_FALSE(lesson->stages.empty());
    for (const Stage& s : lesson->stages) {
        INFO(s.name);
        CHECK_FALSE(s.formula.empty());
        CHECK_FALSE(s.source.empty());
        CHECK_FALSE(s.writes.empty());
        for (const auto& list : {s.reads, s.writes})
            for (const auto& name : list) {
                INFO(name);
                CHECK((fields.contains(name) || std::ranges::find(lesson->probes, name, &Probe::name) != lesson->probes.end()));
            }
    }
    // The light of a broken assumption says what there is, not what should be.
    for (const Assumption& a : lesson->assumptions) CHECK_FALSE(a.otherwise_named.empty());
    for (const Conserved& c : lesson->conserved) CHECK_NOTHROW(lesson->probe(c.probe));
    for (const auto& name : lesson->first_plots()) {
        INFO(name);
        const auto is_named = [&](const auto& item) { return item.name == name; };
        CHECK((std::ranges::any_of(lesson->probes, is_named) || std::ranges::any_of(lesson->lines, is_named)));
    }
    if (!lesson->first_colours().field.empty()) CHECK(lesson->find_field(lesson->first_colours().field));
}

TEST_CASE("every lesson: each parameter refuses what lies outside its bounds and names itself", "[every_lesson]") {
    const LessonEntry& entry = any_lesson();
    INFO(entry.info.id);
    const auto lesson = entry.make();
    for (Parameter* p : lesson->parameters) {
        INFO(p->info.key);
        const Real before = p->value(), size = p->accepted().max - p->accepted().min;
        const Real beyond = p->info.kind == Kind::file ? 1e9 : p->accepted().max + std::max(size, 1.0);
        for (const Real bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, beyond, p->accepted().min - std::max(size, 1.0)}) {
            try {
                p->set(bad);
                FAIL("accepted " << bad);
            } catch (const Refused& e) {
                CHECK(std::string(e.what()).find(p->info.key) != std::string::npos);
            }
            CHECK(p->value() == before);
        }
        if (p->accepted().open_max) CHECK_THROWS_AS(p->set(p->accepted().max), Refused);
        if (p->accepted().open_min) CHECK_THROWS_AS(p->set(p->accepted().min), Refused);
        CHECK(p->parse(p->text()) == p->value());
    }
}

TEST_CASE("every lesson: two resets give equal bits, and zero steps change nothing", "[every_lesson]") {
    const LessonEntry& entry = any_lesson();
    INFO(entry.info.id);
    Runner a(entry), b(entry);
    const auto fresh = hash_of_all(a.lesson());
    CHECK(hash_of_all(b.lesson()) == fresh);
    check_finite(a);
    for (Index i = 0; i < some_steps(a); ++i) a.step();
    a.reset();
    CHECK(hash_of_all(a.lesson()) == fresh);
    CHECK(a.time() == 0);
}

TEST_CASE("every lesson: a hundred steps stay finite", "[every_lesson]") {
    const LessonEntry& entry = any_lesson();
    INFO(entry.info.id);
    Runner runner(entry);
    for (int i = 0; i < 100; ++i) runner.step();
    check_finite(runner);
    CHECK(runner.place().step == 100);
    CHECK(runner.time() == 100 * runner.time_step());
}

TEST_CASE("every lesson: going back and running again gives the same bits, by step, stage and pass", "[every_lesson]") {
    const LessonEntry& entry = any_lesson();
    INFO(entry.info.id);
    Runner runner(entry);
    const Index n = some_steps(runner);
    std::vector<std::uint64_t> hashes{hash_of_all(runner.lesson())};
    for (Index i = 0; i < n; ++i) runner.step(), hashes.push_back(hash_of_all(runner.lesson()));

    // Back to each step, then forward again.
    for (Index i = n; i-- > 0;) {
        REQUIRE(runner.step_back());
        CHECK(hash_of_all(runner.lesson()) == hashes[static_cast<std::size_t>(i)]);
    }
    for (Index i = 0; i < n; ++i) runner.step();
    CHECK(hash_of_all(runner.lesson()) == hashes.back());

    // Into the step by stages and passes, and all the way back.
    const Place end = runner.place();
    std::vector<std::pair<Place, std::uint64_t>> trail;
    for (int i = 0; i < 12; ++i) {
        trail.emplace_back(runner.place(), hash_of_all(runner.lesson()));
        i % 2 ? runner.step_stage() : runner.step_pass();
    }
    while (!trail.empty()) {
        REQUIRE(runner.go_to(trail.back().first));
        CHECK(hash_of_all(runner.lesson()) == trail.back().second);
        trail.pop_back();
    }
    CHECK(runner.place() == end);
}

TEST_CASE("every lesson: two runners in one process do not disturb each other", "[every_lesson]") {
    const LessonEntry& entry = any_lesson();
    INFO(entry.info.id);
    Runner alone(entry), left(entry), right(entry);
    const Index n = some_steps(alone);
    for (Index i = 0; i < n; ++i) alone.step();
    for (Index i = 0; i < n; ++i) left.step(), right.step();
    CHECK(hash_of_all(left.lesson()) == hash_of_all(alone.lesson()));
    CHECK(hash_of_all(right.lesson()) == hash_of_all(alone.lesson()));
}

TEST_CASE("every lesson: a saved scene opens as the same run", "[every_lesson]") {
    const LessonEntry& entry = any_lesson();
    INFO(entry.info.id);
    // Every number a little off its initial value, so that all digits count.
    Runner::Assignments assignments;
    {
        const auto lesson = entry.make();
        for (const Parameter* p : lesson->parameters) {
            const Real value = p->info.initial * (1 + 1e-3) + 1e-17;
            if (p->info.kind == Kind::number && p->accepted().contains(value))
                assignments.emplace_back(p->info.key, p->text(value));
        }
    }
    Runner runner(entry, assignments);
    const SceneFile saved = parse_scene(scene_text(scene_of(runner)), "scene.json");
    Runner again(find_lesson(saved.lesson), saved.parameters);
    for (std::size_t i = 0; i < runner.lesson().parameters.size(); ++i)
        CHECK(runner.lesson().parameters[i]->value() == again.lesson().parameters[i]->value());
    runner.step(), again.step();
    CHECK(state_hash(runner.lesson()) == state_hash(again.lesson()));
}

TEST_CASE("every lesson: each preset opens and runs", "[every_lesson]") {
    const LessonEntry& entry = any_lesson();
    for (const std::string& name : preset_names(entry.info.id)) {
        INFO(entry.info.id << " " << name);
        const SceneFile scene = preset(entry, name);
        CHECK(scene.lesson == entry.info.id);
        Runner runner(entry, scene.parameters);
        for (Index i = 0; i < some_steps(runner); ++i) runner.step();
        check_finite(runner);
    }
}

TEST_CASE("every lesson: the picture has something in its frame, and its marks have colours for every field they show",
          "[every_lesson]") {
    const LessonEntry& entry = any_lesson();
    INFO(entry.info.id);
    Runner runner(entry);
    runner.step();
    for (const Field& f : runner.lesson().fields) {
        if (!f.in_use()) continue;
        INFO("field " << f.name);
        Scene scene;
        scene.colour_by = {std::string(f.name), -1};
        runner.lesson().draw(scene);
        CHECK(scene.grids.size() + scene.triangles.size() + scene.lines.size() + scene.points.size() > 0);
        CHECK(scene.lower != scene.upper);
        for (const PointMarks& m : scene.points) CHECK((m.values.empty() || m.values.size() == m.at.size()));
        for (const LineMarks& m : scene.lines) CHECK((m.values.empty() || m.values.size() == m.ends.size() / 2));
        for (const TriangleMarks& m : scene.triangles)
            CHECK((m.values.empty() || m.values.size() == m.corners.size() || m.values.size() == m.triangles.size()));
        for (const GridMarks& m : scene.grids)
            CHECK(m.values.size() == static_cast<std::size_t>(m.nx) * static_cast<std::size_t>(m.ny));
        for (const ArrowMarks& m : scene.arrows) CHECK(m.from.size() == m.to.size());
    }
}

namespace {

// The run gives one of the answers, and no other; what the slide asks for shows only with its answer.
void check_prediction_of(const WalkthroughPlayer& player) {
    const auto& p = player.prediction();
    if (!p) return;
    INFO(player.slide().title);
    REQUIRE(player.verdict());
    CHECK(player.slide().has(BlockKind::ask));
    CHECK_FALSE(player.verdict()->right);  // nothing was predicted
    if (p->kind == Prediction::Kind::choice) {
        std::size_t given = 0;
        for (const Prediction::Option& o : p->options) given += player.verdict()->came == o.words;
        CHECK(given == 1);
    } else if (p->kind != Prediction::Kind::words) {
        CHECK(player.slide().hides(p->probe));
    }
    if (p->kind != Prediction::Kind::sketch) return;
    REQUIRE(player.measured_curve().size() == sketch_points);
    for (const Real value : player.measured_curve()) CHECK((value >= p->height.min && value <= p->height.max));
    const auto [least, most] = std::ranges::minmax(player.measured_curve());
    CHECK(most - least > 0.1 * (p->height.max - p->height.min));  // worth a sketch
}

}  // namespace

TEST_CASE("every lesson: its walkthrough asks before it shows, and what it expects holds", "[every_lesson]") {
    const LessonEntry& entry = any_lesson();
    INFO(entry.info.id);
    if (find_text(std::string(entry.info.id) + "/walkthrough.md").empty()) {
        // Only the example of the developer guide has none.
        REQUIRE(entry.info.id == "time/bead_chain");
        return;
    }
    Runner runner(entry);
    WalkthroughPlayer player(runner, walkthrough_of(entry));
    std::size_t checked = 0, asked = 0, predicted = 0;
    for (const Slide& s : player.walkthrough().slides) asked += s.has(BlockKind::ask);
    do {
        if (!player.revealed()) continue;
        predicted += player.prediction() && player.prediction()->kind != Prediction::Kind::words;
        check_prediction_of(player);
        for (const ExpectationResult& r : player.results()) {
            INFO(r.text << "   " << r.measured);
            CHECK(r.met);
            ++checked;
        }
    } while (player.next());
    CHECK(checked >= 3);
    CHECK(asked >= 2);
    CHECK(predicted >= 2);

    // Back to the start: the first slide stands as it did.
    while (player.back()) {
    }
    CHECK(player.slide_number() == 0);
    CHECK_FALSE(player.revealed());
}

TEST_CASE("every lesson: what it declares and finds can be written out", "[every_lesson]") {
    const LessonEntry& entry = any_lesson();
    INFO(entry.info.id);
    Runner runner(entry);
    runner.step();
    for (const std::string& text : {describe_text(entry), describe_json(entry), describe_markdown(runner.lesson(), entry.info.id),
                                    run_json(runner, {}), run_text(runner)}) {
        CHECK(text.size() > 200);
        CHECK_FALSE(std::regex_search(text, std::regex("\\bnan\\b")));  // a word of its own: "Venant" is a name
    }
}

TEST_CASE("a lesson that solves anew from its parameters stores no fields for going back") {
    for (const auto& [id, fine] : {std::pair{"elasticity/energy_density", ""},
                                   {"elasticity/strain_measures", ""},
                                   {"elasticity/stress_strain", "resolution"},
                                   {"elasticity/deformation_gradient", ""},
                                   {"fluids/projection", "resolution"}}) {
        INFO(id);
        Runner runner(find_lesson(id));
        if (*fine) runner.assign({{fine, "4"}});
        for (int k = 0; k < 3; ++k) runner.step();
        CHECK(runner.history().bytes() < 3000);
        const auto now = hash_of_all(runner.lesson());
        REQUIRE(runner.step_back());
        CHECK(hash_of_all(runner.lesson()) == now);
    }
}
