#include <pliant/document/walkthrough_words.h>
#include <pliant/math/error.h>
#include <pliant/study/claims_reader.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>
#include <sstream>

namespace pliant {
namespace {

constexpr std::string_view wrong_answer = "- [ ] ", right_answer = "- [x] ";

struct TextEntry {
    std::string_view name;
    std::string Claim::*text;
};
constexpr std::array<TextEntry, 6> text_entries{{{"source", &Claim::source},
                                                 {"experiment", &Claim::experiment},
                                                 {"figure", &Claim::figure},
                                                 {"unit", &Claim::unit},
                                                 {"criterion", &Claim::criterion},
                                                 {"question", &Claim::question}}};
constexpr std::array<std::string_view, 8> entry_names{"source",    "experiment", "figure", "unit",
                                                      "criterion", "expected",   "scene",  "question"};

void append(std::string& text, std::string_view words) {
    if (!text.empty()) text += ' ';
    text += words;
}

// Gathers what is said of a claim line by line, and takes it over where the next one begins.
class ClaimsReader {
public:
    ClaimsReader(std::string_view text, std::string_view lesson) : text_(text), lesson_(lesson) {}

    std::vector<Claim> read() {
        std::istringstream in{std::string(text_)};
        for (std::string line; std::getline(in, line);) ++number_, take(line);
        end_claim();
        if (claims_.empty()) refuse("there is no claim: begin one with '## ID'");
        return std::move(claims_);
    }

private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw Refused(fmt::format("{}/claims.md:{}: {}", lesson_, number_, what));
    }

    void take(const std::string& line) {
        if (line.starts_with("## ")) return begin_claim(trimmed(line.substr(3)));
        const std::string words = trimmed(line);
        if (claims_.empty() || words.empty()) return;
        if (line.starts_with("- ")) return begin_entry(line.substr(2));
        if (words.starts_with(wrong_answer) || words.starts_with(right_answer)) return begin_answer(words);
        if (given_.empty()) return append(claim().statement, words);
        if (!line.starts_with(' ')) refuse(fmt::format("'{}' is neither an entry, '- name: words', nor an indented line", words));
        append(*current_, words);
    }

    void begin_claim(const std::string& id) {
        end_claim();
        claims_.emplace_back();
        claim().id = id, claim().lesson = lesson_;
        given_.clear();
        chosen_.clear();
    }

    void begin_entry(const std::string& entry) {
        end_entry();
        const auto colon = entry.find(':');
        name_ = entry.substr(0, colon);
        if (colon == std::string::npos || std::ranges::find(entry_names, name_) == entry_names.end())
            refuse(fmt::format("'{}' is no entry of a claim; known: {}", trimmed(name_), fmt::join(entry_names, ", ")));
        if (!given_.insert(name_).second) refuse(fmt::format("{} has two entries '{}'", claim().id, name_));
        const auto found = std::ranges::find(text_entries, name_, &TextEntry::name);
        current_ = found == text_entries.end() ? &words_ : &(claim().*(found->text));
        append(*current_, trimmed(entry.substr(colon + 1)));
    }

    void begin_answer(const std::string& words) {
        if (name_ != "question") refuse("an answer stands below '- question:'");
        if (words.starts_with(right_answer)) chosen_.push_back(static_cast<int>(claim().answers.size()));
        current_ = &claim().answers.emplace_back(words.substr(right_answer.size()));
    }

    // Entries that are no text are read when all of their lines are there.
    void end_entry() {
        if (name_ == "scene") read_scene();
        if (name_ == "expected") read_expected();
        name_.clear();
        words_.clear();
    }

    void read_scene() {
        try {
            claim().scene = assignments_of(words_of_line("scene: " + words_));
        } catch (const Refused& e) {
            refuse(e.what());
        }
    }

    void read_expected() {
        for (const Verdict verdict : {Verdict::reproduced, Verdict::qualified})
            if (words_ == name_of(verdict)) return void(claim().expected = verdict);
        refuse(fmt::format("'{}' cannot be expected: give reproduced or qualified", words_));
    }

    void end_claim() {
        if (claims_.empty()) return;
        end_entry();
        const Claim& c = claim();
        if (c.statement.empty()) refuse(fmt::format("{} has no statement: write it below '## {}'", c.id, c.id));
        for (const TextEntry& entry : text_entries)
            if (entry.name != "unit" && (c.*(entry.text)).empty())
                refuse(fmt::format("{} has no {}: give '- {}: ...'", c.id, entry.name, entry.name));
        if (c.answers.size() < 2 || chosen_.size() != 1)
            refuse(fmt::format("{} has {} answers, {} of them right: give two or more, one with [x]", c.id, c.answers.size(),
                               chosen_.size()));
        claim().right_answer = chosen_.front();
    }

    Claim& claim() { return claims_.back(); }

    std::string_view text_, lesson_;
    std::vector<Claim> claims_;
    std::set<std::string> given_;     // entries of the present claim
    std::vector<int> chosen_;         // its right answers
    std::string name_, words_;        // the present entry, and its words where they are no text of the claim
    std::string* current_ = nullptr;  // what an indented line goes on with
    int number_ = 0;
};

}  // namespace

std::vector<Claim> read_claims(std::string_view text, std::string_view lesson) { return ClaimsReader(text, lesson).read(); }

}  // namespace pliant
