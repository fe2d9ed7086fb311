// What stands beside a question does not answer it: in the walkthrough of every lesson.
#include "../every_lesson.h"

#include <pliant/document/summary.h>
#include <pliant/document/walkthrough.h>
#include <pliant/document/walkthrough_sentences.h>
#include <pliant/document/walkthrough_words.h>
#include <pliant/run/runner.h>
#include <pliant/text/spoken.h>
#include <pliant/text/texts.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_range.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>

using namespace pliant;
using namespace pliant::test;

namespace {

struct ShownNumber {
    std::string where;
    Real value = 0;
};

// Between 1 and 10, so that units and powers of ten do not count.
Real mantissa(Real x) {
    if (x == 0 || !std::isfinite(x)) return 0;
    const Real size = std::abs(x);
    return size / std::pow(10, std::floor(std::log10(size)));
}

bool same_digits(Real a, Real b, Real tolerance) {
    const Real x = mantissa(a), y = mantissa(b);
    return x != 0 && y != 0 && std::min({std::abs(x - y), std::abs(10 * x - y), std::abs(x - 10 * y)}) <= tolerance * y;
}

// One that is met by chance in many places: 20, 0.5, 100.
bool is_round(Real x) {
    const std::string digits = fmt::format("{:.2e}", mantissa(x));
    return x == 0 || digits[3] == '0';
}

std::vector<Real> numbers_in(const std::string& text) {
    static const std::regex number("[0-9]+(\\.[0-9]+)?");
    std::vector<Real> found;
    for (auto it = std::sregex_iterator(text.begin(), text.end(), number); it != std::sregex_iterator(); ++it)
        found.push_back(std::stod(it->str()));
    return found;
}

// What is said beside the picture before the answer: title, words, formulas, question and choices.
std::string words_of_question(const Slide& slide) {
    std::string text = slide.title;
    for (const Block& b : slide.blocks)
        if (b.kind == BlockKind::text || b.kind == BlockKind::formula || b.kind == BlockKind::ask || b.kind == BlockKind::predict)
            text += " " + b.paragraph();
    return text;
}

bool told(const Slide& slide, Real value) {
    const std::vector<Real> numbers = numbers_in(words_of_question(slide));
    return std::ranges::any_of(numbers, [&](Real x) { return same_digits(x, value, 1e-3); });
}

bool is_number(const Parameter& p) { return p.info.is_number(); }

// The sliders of the slide, its numbers in large type, and what theory says of them.
std::vector<ShownNumber> shown_numbers(const WalkthroughPlayer& player, const Runner& runner) {
    std::vector<ShownNumber> shown;
    if (player.slide().has(BlockKind::controls))
        for (const Parameter* p : runner.lesson().parameters)
            if (is_number(*p) && p->used() && player.allows(p->info.key) && !player.hides(p->info.key))
                shown.push_back({fmt::format("the slider of {}", p->info.key), runner.wanted(*p)});
    for (const Probe* p : key_probes(runner.lesson())) {
        if (player.hides(p->name)) continue;
        if (const auto value = runner.value(*p)) shown.push_back({fmt::format("the number {}", p->name), *value});
        if (const auto exact = player.hides("theory") ? std::nullopt : runner.exact(*p))
            shown.push_back({fmt::format("the exact {}", p->name), *exact});
    }
    return shown;
}

// Of what is predicted alone, beside the words and matrices of the picture too.
std::vector<ShownNumber> numbers_of_picture(const WalkthroughPlayer& player, const Runner& runner) {
    Scene scene;
    scene.colour_by = runner.lesson().first_colours();
    runner.lesson().draw(scene);
    std::vector<ShownNumber> shown;
    if (!player.hides("labels"))
        for (const LabelMark& l : scene.labels)
            for (const Real x : numbers_in(l.text)) shown.push_back({fmt::format("the words '{}' in the picture", l.text), x});
    if (!player.hides("matrices"))
        for (const MatrixMark& m : scene.matrices)
            for (const Real x : m.entries) shown.push_back({fmt::format("the matrix {}", m.name), x});
    return shown;
}

// Probes of the prediction, which its conditions begin with.
bool predicted(const Slide& slide, std::string_view probe) {
    return std::ranges::any_of(slide.blocks, [&](const Block& b) {
        return b.kind == BlockKind::predict && std::ranges::any_of(b.lines, [&](const std::string& line) {
                   const auto bar = line.rfind('|');
                   const auto words = words_of_line(bar == std::string::npos ? line : line.substr(bar + 1));
                   return !words.empty() && (words[0] == probe || (words.size() > 1 && words[1] == probe));
               });
    });
}

std::vector<Real> settings(const Runner& runner) {
    std::vector<Real> values;
    for (const Parameter* p : runner.lesson().parameters) values.push_back(runner.wanted(*p));
    return values;
}

// "At which lengthening ...?", "For which ν ...?", "How long may a step be?"
bool asks_for_a_setting(const Slide& slide) {
    static const std::regex asks(
        "\\b(at|for|on|from|up to|with) (which|what)\\b|\\bhow (large|long|small|fine|stiff) (may|must|can)\\b",
        std::regex::icase);
    return std::ranges::any_of(slide.blocks, [](const Block& b) {
        const std::string text = b.paragraph();
        return b.kind == BlockKind::ask && std::regex_search(text, asks);
    });
}

// Where a setting is asked for, a slider that the slide has moved stands at a number that its words tell: else it tells the
// answer.
void check_sliders(const WalkthroughPlayer& player, const Runner& runner, const std::vector<Real>& before) {
    if (!asks_for_a_setting(player.slide()) || !player.slide().has(BlockKind::controls)) return;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Parameter& p = *runner.lesson().parameters[i];
        const Real now = runner.wanted(p);
        if (!is_number(p) || now == before[i] || now == p.info.initial || now == 0) continue;
        if (!player.allows(p.info.key) || player.hides(p.info.key) || !p.used()) continue;
        INFO("the slider of " << p.info.key << " stands at " << now << ", which the words of the slide do not tell: set it after "
                              << "`solve` or `run`, or name it in hide");
        CHECK(told(player.slide(), now));
    }
}

void check_shown(const WalkthroughPlayer& player, const Runner& runner, const std::vector<ShownNumber>& shown,
                 const std::vector<ShownNumber>& in_picture) {
    for (const Probe& p : runner.lesson().probes) {
        if (!player.slide().hides(p.name)) continue;
        const auto value = runner.value(p);
        if (!value || is_round(*value) || told(player.slide(), *value)) continue;
        const auto check = [&](const ShownNumber& number) {
            INFO(number.where << " shows " << number.value << " before the answer, and " << p.name << " is " << *value);
            CHECK_FALSE((!is_round(number.value) && same_digits(number.value, *value, 2e-3)));
        };
        for (const ShownNumber& number : shown) check(number);
        if (predicted(player.slide(), p.name))
            for (const ShownNumber& number : in_picture) check(number);
    }
}

// What Next does is told by its kind alone: no number, and no option of a choice.
void check_next(const WalkthroughPlayer& player, const Lesson& lesson) {
    if (!player.slide().has(BlockKind::ask)) return;
    const std::string next = next_sentence(lesson, player.slide());
    INFO("the line below the question reads '" << next << "'");
    CHECK(next.find_first_of("0123456789") == std::string::npos);
    for (const Parameter* p : lesson.parameters) {
        CHECK(next.find(spoken(p->info.key) + " to") == std::string::npos);
        for (const Option& o : p->info.options) CHECK(next.find(fmt::format("“{}”", o.label)) == std::string::npos);
    }
    const bool runs = std::ranges::any_of(player.slide().blocks, [](const Block& b) {
        return b.kind == BlockKind::actions &&
               std::ranges::any_of(b.lines, [](const std::string& l) { return l.starts_with("run "); });
    });
    if (runs) CHECK(next.find("run") != std::string::npos);
}

}  // namespace

TEST_CASE("every lesson: no slider, number or word of the picture answers the question beside it", "[every_lesson][answers]") {
    const LessonEntry& entry = GENERATE(from_range(every_lesson())).get();
    if (find_text(std::string(entry.info.id) + "/walkthrough.md").empty()) return;
    Runner runner(entry);
    std::vector<Real> before = settings(runner);
    WalkthroughPlayer player(runner, walkthrough_of(entry));
    do {
        INFO(entry.info.id << ", slide " << player.slide_number() + 1 << ": " << player.slide().title);
        check_sliders(player, runner, before);
        check_next(player, runner.lesson());
        if (player.slide().has(BlockKind::ask) && player.slide().has_answer()) CHECK(player.hides("lights"));
        const auto shown = shown_numbers(player, runner), in_picture = numbers_of_picture(player, runner);
        if (player.slide().has_answer()) player.next();
        if (player.slide().has(BlockKind::ask)) check_shown(player, runner, shown, in_picture);
        before = settings(runner);
    } while (player.next());
}
