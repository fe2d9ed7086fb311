#include <pliant/document/prediction.h>
#include <pliant/document/walkthrough.h>
#include <pliant/document/walkthrough_words.h>
#include <pliant/text/format.h>
#include <pliant/text/number_text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace pliant {
namespace {

constexpr Real sketch_tolerance = 0.15;  // of the height
constexpr std::size_t most_options = 9;  // a digit each

class PredictionReader {
public:
    PredictionReader(const Block& block, const std::string& path) : block_(block), path_(path), line_(block.first_line) {}

    Prediction read() {
        std::size_t first = 0;
        while (first < block_.lines.size() && trimmed(block_.lines[first]).empty()) ++first, ++line_;
        if (first == block_.lines.size()) refuse("a prediction begins with one of: choice, number PROBE ..., sketch PROBE ...");
        const auto words = words_of_line(block_.lines[first]);
        Prediction p;
        if (words[0] == "choice" && words.size() == 1) return read_options(p, first + 1), p;
        if (words[0] == "number")
            read_number(p, words);
        else if (words[0] == "sketch")
            read_sketch(p, words);
        else
            refuse(fmt::format("'{}' is no prediction: begin with choice, number PROBE ... or sketch PROBE ...", words[0]));
        for (++first; first < block_.lines.size(); ++first)
            if (++line_; !trimmed(block_.lines[first]).empty()) refuse("a number or a sketch is asked for in one line");
        return p;
    }

private:
    [[noreturn]] void refuse(const std::string& what) const { throw Refused(fmt::format("{}:{}: {}", path_, line_, what)); }

    void read_options(Prediction& p, std::size_t first) {
        for (std::size_t k = first; k < block_.lines.size(); ++k) {
            ++line_;
            const std::string line = trimmed(block_.lines[k]);
            if (line.empty()) continue;
            const auto bar = line.rfind('|');
            if (bar == std::string::npos) refuse("an answer reads: WORDS | CONDITION, such as 'It grows | energy > before'");
            p.options.push_back({trimmed(line.substr(0, bar)), trimmed(line.substr(bar + 1)), line_});
            if (p.options.back().words.empty() || p.options.back().condition.empty())
                refuse("an answer needs words and a condition");
        }
        if (p.options.size() < 2 || p.options.size() > most_options)
            refuse(fmt::format("a choice has 2 to {} answers, this one {}", most_options, p.options.size()));
    }

    Real number_at(const std::vector<std::string>& words, std::size_t at) const {
        const auto value = at < words.size() ? finite_number(words[at]) : std::nullopt;
        if (!value) refuse(fmt::format("'{}' is no number", at < words.size() ? words[at] : ""));
        return *value;
    }

    void read_number(Prediction& p, const std::vector<std::string>& words) const {
        p.kind = Prediction::Kind::number;
        const bool relative = words.size() == 5 && words[4] == "relative";
        if (!(words.size() == 4 || relative) || words[2] != "within")
            refuse("it reads: number PROBE within TOLERANCE [relative]");
        p.probe = words[1];
        p.tolerance = number_at(words, 3);
        p.relative = relative;
        if (!(p.tolerance > 0)) refuse("the tolerance has to be above 0");
    }

    void read_sketch(Prediction& p, const std::vector<std::string>& words) const {
        p.kind = Prediction::Kind::sketch;
        const bool reads = words.size() == 9 && words[2] == "over" && (words[4] == "s" || words[4] == "steps") &&
                           words[5] == "from" && words[7] == "to";
        if (!reads) refuse("it reads: sketch PROBE over T s from A to B, or over N steps");
        p.probe = words[1];
        p.span = number_at(words, 3);
        p.height = {number_at(words, 6), number_at(words, 8)};
        p.tolerance = sketch_tolerance;
        if (!(p.span > 0) || !(p.height.max > p.height.min))
            refuse("a sketch needs a span above 0, and a height from less to more");
    }

    const Block& block_;
    const std::string& path_;
    int line_;
};

std::string in_quotes(const std::string& words) { return fmt::format("“{}”", words); }
std::string per_cent(Real part) { return part < 0.1 ? fmt::format("{:.2g} %", 100 * part) : fmt::format("{:.0f} %", 100 * part); }

}  // namespace

Prediction read_prediction(const Block& block, const std::string& path) { return PredictionReader(block, path).read(); }

void check_prediction(const Prediction& prediction, const Lesson& lesson) {
    if (!prediction.probe.empty()) lesson.probe(prediction.probe);
}

Sketch sketch_through(const std::vector<Real>& values) {
    if (values.size() < 2) throw Refused("a curve needs at least two values, at equal times");
    Sketch all(sketch_points);
    for (std::size_t k = 0; k < sketch_points; ++k) {
        const Real at = static_cast<Real>(k) / static_cast<Real>(sketch_points - 1) * static_cast<Real>(values.size() - 1);
        const auto left = std::min(static_cast<std::size_t>(at), values.size() - 2);
        all[k] = std::lerp(values[left], values[left + 1], at - static_cast<Real>(left));
    }
    return all;
}

Sketch sketch_typed(const std::string& text) {
    std::string spaced = text;
    std::ranges::replace_if(
        spaced, [](char c) { return c == ',' || c == ';'; }, ' ');
    std::vector<Real> values;
    for (const std::string& word : words_of_line(spaced)) {
        const auto value = finite_number(word);
        if (!value)
            throw Refused(fmt::format("'{}' is no number: a curve is typed as its values at equal times, such as 3, 5, 8", word));
        values.push_back(*value);
    }
    return sketch_through(values);
}

Sketch sampled(const Track& track, Real span) {
    Sketch all;
    if (track.empty()) return all;
    std::size_t next = 0;
    for (std::size_t k = 0; k < sketch_points; ++k) {
        const Real at = span * static_cast<Real>(k) / static_cast<Real>(sketch_points - 1);
        while (next < track.size() && track[next].first < at) ++next;
        if (next == 0 || next == track.size()) {
            all.push_back(next == 0 ? track.front().second : track.back().second);
            continue;
        }
        const auto& [x0, y0] = track[next - 1];
        const auto& [x1, y1] = track[next];
        all.push_back(x1 > x0 ? std::lerp(y0, y1, (at - x0) / (x1 - x0)) : y1);
    }
    return all;
}

PredictionVerdict judge_choice(const Prediction& p, const Guess& guess, const std::vector<bool>& met) {
    PredictionVerdict v;
    if (guess.option) v.predicted = p.options.at(*guess.option).words;
    for (std::size_t k = 0; k < p.options.size(); ++k)
        if (met[k]) v.came += (v.came.empty() ? "" : "; ") + p.options[k].words;
    v.right = guess.option && met.at(*guess.option);
    if (v.came.empty())
        v.words = "None of the answers came true.";
    else if (!guess.option)
        v.words = fmt::format("The run gives {}.", in_quotes(v.came));
    else if (v.right)
        v.words = fmt::format("You were right: {}.", in_quotes(v.predicted));
    else
        v.words = fmt::format("You predicted {}; the run gives {}.", in_quotes(v.predicted), in_quotes(v.came));
    return v;
}

PredictionVerdict judge_number(const Prediction& p, const Guess& guess, Real measured, const std::string& unit) {
    PredictionVerdict v;
    v.came = format_quantity(measured, unit, 4);
    if (!guess.number) return v.words = fmt::format("The run gives {}.", v.came), v;
    v.predicted = format_quantity(*guess.number, unit, 4);
    const Real off = std::abs(*guess.number - measured), accepted = p.tolerance * (p.relative ? std::abs(measured) : 1);
    v.right = off <= accepted;
    const std::string distance = measured != 0 && p.relative ? per_cent(off / std::abs(measured)) : format_quantity(off, unit, 2);
    const std::string limit = p.relative ? per_cent(p.tolerance) : format_quantity(p.tolerance, unit, 2);
    v.words = fmt::format("You predicted {}; the run gives {}. That is {} off, and up to {} counts as right: {}.", v.predicted,
                          v.came, distance, limit, v.right ? "right" : "not this time");
    return v;
}

PredictionVerdict verdict_of_words(const Guess& guess) {
    PredictionVerdict v;
    if (guess.words.empty()) return v;
    v.predicted = guess.words;
    const bool ends = std::string_view(".!?").find(guess.words.back()) != std::string_view::npos;
    v.words = fmt::format("You said: {}{}", in_quotes(guess.words), ends ? "" : ".");
    if (guess.was_right) v.words += *guess.was_right ? " You were right, as you say." : " You were not right, as you say.";
    return v;
}

void note_after_answer(PredictionVerdict& v, const Guess& guess) {
    if (guess.given() && guess.after_answer) v.words += " (Said after the answer was seen.)";
}

PredictionVerdict judge_sketch(const Prediction& p, const Guess& guess, const Sketch& measured, const std::string& unit) {
    PredictionVerdict v;
    if (measured.empty()) return v.words = "Nothing was measured.", v;
    v.came = fmt::format("{} at the end", format_quantity(measured.back(), unit, 4));
    if (guess.sketch.empty()) return v.words = fmt::format("The run gives {}.", v.came), v;
    v.predicted = fmt::format("{} at the end", format_quantity(guess.sketch.back(), unit, 4));
    Real sum = 0;
    for (std::size_t k = 0; k < measured.size(); ++k) sum += std::abs(measured[k] - guess.sketch[k]);
    const Real mean = sum / static_cast<Real>(measured.size()), part = mean / (p.height.max - p.height.min);
    v.right = part <= p.tolerance;
    v.words =
        fmt::format("Your curve is off by {} on average, {} of the plot's height, and up to {} counts as right: {}.",
                    format_quantity(mean, unit, 2), per_cent(part), per_cent(p.tolerance), v.right ? "right" : "not this time");
    return v;
}

}  // namespace pliant
