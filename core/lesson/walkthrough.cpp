#include <pliant/lesson/format.h>
#include <pliant/lesson/scene_file.h>
#include <pliant/lesson/texts.h>
#include <pliant/lesson/until.h>
#include <pliant/lesson/walkthrough.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

namespace pliant {
namespace {

struct Fence {
    std::string_view name;
    BlockKind kind;
};
constexpr std::array<Fence, 5> fences{{{"formula", BlockKind::formula},
                                       {"ask", BlockKind::ask},
                                       {"do", BlockKind::actions},
                                       {"expect", BlockKind::expect},
                                       {"answer", BlockKind::answer}}};

std::vector<std::string> words_of(const std::string& line) {
    std::istringstream in(line);
    return {std::istream_iterator<std::string>(in), {}};
}

std::optional<Real> as_number(std::string_view text) {
    Real value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::string trimmed(std::string_view line) {
    const auto first = line.find_first_not_of(" \t\r"), last = line.find_last_not_of(" \t\r");
    return first == std::string_view::npos ? "" : std::string(line.substr(first, last - first + 1));
}

// Reads the file line by line into slides and blocks.
class Reader {
public:
    Reader(std::string_view text, std::string_view path) : text_(text) { result_.path = path; }

    Walkthrough read() {
        std::istringstream in{std::string(text_)};
        for (std::string line; std::getline(in, line);) ++number_, take(line);
        if (inside_) refuse("the block that begins with ``` has no end");
        if (result_.slides.empty()) refuse("there is no slide: begin one with '## Title'");
        return std::move(result_);
    }

private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw Refused(fmt::format("{}:{}: {}", result_.path, number_, what));
    }

    void take(const std::string& line) {
        if (line.starts_with("```")) return fence(trimmed(line.substr(3)));
        if (inside_) return block().lines.push_back(line);
        if (line.starts_with("## ")) return result_.slides.push_back({trimmed(line.substr(3)), {}});
        if (line.starts_with("# ")) return void(result_.title = trimmed(line.substr(2)));
        const std::string text = trimmed(line);
        if (result_.slides.empty()) return;  // words before the first slide introduce the file itself
        auto& blocks = result_.slides.back().blocks;
        const bool goes_on = !blocks.empty() && blocks.back().kind == BlockKind::text && !paragraph_ended_;
        paragraph_ended_ = text.empty();
        if (text.empty()) return;
        if (goes_on)
            blocks.back().lines.back() += " " + text;
        else
            blocks.push_back({BlockKind::text, {text}, number_});
    }

    void fence(const std::string& name) {
        if (inside_) {
            if (!name.empty()) refuse("a block ends with ``` alone");
            inside_ = false;
            return;
        }
        if (result_.slides.empty()) refuse("a block stands before the first slide ('## Title')");
        const auto found = std::ranges::find(fences, name, &Fence::name);
        if (found == fences.end()) refuse(fmt::format("unknown block '{}'; known: formula, ask, do, expect, answer", name));
        result_.slides.back().blocks.push_back({found->kind, {}, number_ + 1});
        inside_ = true;
        paragraph_ended_ = true;
    }

    Block& block() { return result_.slides.back().blocks.back(); }

    std::string_view text_;
    Walkthrough result_;
    int number_ = 0;
    bool inside_ = false, paragraph_ended_ = true;
};

}  // namespace

bool Slide::has(BlockKind kind) const { return std::ranges::find(blocks, kind, &Block::kind) != blocks.end(); }

Walkthrough parse_walkthrough(std::string_view text, std::string_view path) { return Reader(text, path).read(); }

Walkthrough walkthrough_of(const LessonEntry& entry) {
    const std::string path = fmt::format("{}/walkthrough.md", entry.info.id);
    const std::string_view text = find_text(path);
    if (text.empty()) throw Refused(fmt::format("{} has no walkthrough", entry.info.id));
    return parse_walkthrough(text, path);
}

WalkthroughPlayer::WalkthroughPlayer(Runner& runner, Walkthrough walkthrough, std::function<void()> after_step)
    : runner_(runner), walkthrough_(std::move(walkthrough)), after_step_(std::move(after_step)) {}

void WalkthroughPlayer::refuse(int line, const std::string& what) const {
    throw Refused(fmt::format("{}:{}: {}", walkthrough_.path, line, what));
}

bool WalkthroughPlayer::next() {
    const bool acts = slide().has(BlockKind::actions) || slide().has(BlockKind::expect) || slide().has(BlockKind::answer);
    if (!revealed_ && acts) return reveal(), true;
    if (slide_ + 1 == walkthrough_.slides.size()) return false;
    ++slide_;
    revealed_ = false;
    results_.clear();
    return true;
}

bool WalkthroughPlayer::back() {
    if (slide_ == 0 && !revealed_) return false;
    const std::size_t target = revealed_ ? slide_ : slide_ - 1;
    // Initial parameters, then everything that the slides before did.
    Runner::Assignments initial;
    for (const Parameter* p : runner_.lesson().parameters) initial.emplace_back(p->info.key, p->text(p->info.initial));
    runner_.assign(initial);
    runner_.reset();
    shown_field_.clear();
    for (slide_ = 0; slide_ < target; ++slide_) reveal();
    revealed_ = false;
    results_.clear();
    return true;
}

void WalkthroughPlayer::reveal() {
    before_.clear();
    for (const Probe& p : runner_.lesson().probes)
        if (const auto value = runner_.value(p)) before_[std::string(p.name)] = *value;
    results_.clear();
    for (const Block& b : slide().blocks) {
        int number = b.first_line;
        for (const std::string& raw : b.lines) {
            const std::string line = trimmed(raw);
            if (!line.empty() && b.kind == BlockKind::actions) act(line, number);
            if (!line.empty() && b.kind == BlockKind::expect) results_.push_back(check(line, number));
            ++number;
        }
    }
    revealed_ = true;
}

namespace {

Runner::Assignments assignments_of(const std::vector<std::string>& words) {
    Runner::Assignments result;
    for (std::size_t i = 1; i < words.size(); ++i) {
        const auto equals = words[i].find('=');
        if (equals == std::string::npos) throw Refused(fmt::format("'{}' is not KEY=VALUE", words[i]));
        result.emplace_back(words[i].substr(0, equals), words[i].substr(equals + 1));
    }
    return result;
}

// "run 20 steps", "run 0.5 s", "run rest", "run to advection".
void run_for(Runner& runner, const std::vector<std::string>& words, const std::function<void()>& after_step) {
    if (words.size() == 2 && words[1] == "rest") return advance(runner, Until::at_rest(), after_step);
    const auto amount = words.size() == 3 ? as_number(words[1]) : std::nullopt;
    if (amount && words[2] == "s") return advance(runner, Until::after_time(*amount), after_step);
    if (amount && words[2].starts_with("step"))
        return advance(runner, Until::after_steps(static_cast<Index>(*amount)), after_step);
    if (words.size() == 3 && words[1] == "to") return runner.run_to_stage(words[2]);
    throw Refused("run needs one of: N steps, T s, rest, to STAGE");
}

Pull pull_of(const std::vector<std::string>& words) {
    std::array<Real, 4> numbers{};
    constexpr std::array<std::size_t, 4> where{1, 3, 4, 5};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto value = words.size() == 6 ? as_number(words[where[i]]) : std::nullopt;
        if (!value) throw Refused("pull needs: INDEX to X Y Z");
        numbers[i] = *value;
    }
    const Vec<3> to(numbers[1], numbers[2], numbers[3]);
    return {static_cast<Index>(numbers[0]), to, to};
}

}  // namespace

void WalkthroughPlayer::act(const std::string& line, int number) {
    const auto words = words_of(line);
    try {
        if (words[0] == "set") return runner_.assign(assignments_of(words));
        if (words[0] == "reset") return runner_.reset();
        if (words[0] == "run") return run_for(runner_, words, after_step_);
        if (words[0] == "release") return runner_.pull(std::nullopt);
        if (words[0] == "pull") return runner_.pull(pull_of(words));
        if (words[0] == "preset" && words.size() == 2)
            return runner_.load(preset(find_lesson(runner_.info().id), words[1]).parameters);
        if (words[0] == "show" && words.size() == 2) return void(shown_field_ = runner_.lesson().field(words[1]).name);
        throw Refused("unknown action; known: set, reset, run, show, pull, release, preset");
    } catch (const Refused& e) {
        refuse(number, fmt::format("{} (in '{}')", e.what(), line));
    }
}

Real WalkthroughPlayer::quantity(std::string_view name) const {
    if (name == "time") return runner_.time();
    if (name == "step") return static_cast<Real>(runner_.place().step);
    for (const Parameter* p : runner_.lesson().parameters)
        if (p->info.key == name) return p->value();
    const auto value = runner_.value(runner_.lesson().probe(name));
    if (!value) throw Refused(fmt::format("the probe '{}' is not defined here", name));
    return *value;
}

// NAME OP [FACTOR] VALUE [within TOLERANCE [relative]]
ExpectationResult WalkthroughPlayer::check(const std::string& line, int number) const try {
    const auto words = words_of(line);
    if (words.size() < 3) throw Refused("an expectation reads: NAME < VALUE, or NAME = VALUE within TOLERANCE [relative]");
    const Real left = quantity(words[0]);

    // The right side, with its optional factor.
    std::size_t at = 2;
    Real factor = 1;
    if (const auto number_first = as_number(words[at]); number_first && at + 1 < words.size() && words[at + 1] != "within")
        factor = *number_first, ++at;
    const std::string& term = words[at++];
    Real right = 0;
    if (const auto constant = as_number(term))
        right = *constant;
    else if (term == "exact")
        right = runner_.exact(runner_.lesson().probe(words[0])).value();
    else if (term == "before" && before_.contains(words[0]))
        right = before_.find(words[0])->second;
    else
        right = quantity(term);
    right *= factor;

    const std::string& op = words[1];
    bool met = false;
    if (op == "=") {
        const auto tolerance = at + 1 < words.size() && words[at] == "within" ? as_number(words[at + 1]) : std::nullopt;
        if (!tolerance) throw Refused("= needs a tolerance: within 1e-6, or within 1e-6 relative");
        const bool relative = at + 2 < words.size() && words[at + 2] == "relative";
        met = std::abs(left - right) <= *tolerance * (relative ? std::abs(right) : 1);
    } else if (op == "<" || op == "<=" || op == ">" || op == ">=") {
        met = op == "<" ? left < right : op == "<=" ? left <= right : op == ">" ? left > right : left >= right;
    } else {
        throw Refused(fmt::format("unknown comparison '{}'; known: < <= > >= =", op));
    }
    return {line, met, fmt::format("{} = {}, against {}", words[0], format_exact(left), format_exact(right)), number};
} catch (const Refused& e) {
    refuse(number, fmt::format("{} (in '{}')", e.what(), line));
} catch (const std::bad_optional_access&) {
    refuse(number, fmt::format("this probe has no exact value here (in '{}')", line));
}

}  // namespace pliant
