// One word for one thing: docs/glossary.md against every text that a person reads.
#include <pliant/document/extensions.h>
#include <pliant/document/walkthrough.h>
#include <pliant/document/walkthrough_sentences.h>
#include <pliant/study/claims.h>
#include <pliant/text/file.h>
#include <pliant/text/spoken.h>
#include <pliant/text/texts.h>

#include "../every_lesson.h"

#include <fmt/format.h>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace pliant;
using namespace pliant::test;

namespace {

struct Sentence {
    std::string where, text;
};
using Sentences = std::vector<Sentence>;

std::string without_blanks_around(std::string text) {
    text.erase(0, std::min(text.find_first_not_of(' '), text.size()));
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

// The second column of the table.
std::vector<std::string> banned_terms() {
    std::istringstream page(read_file(PLIANT_SOURCE_DIR "/docs/glossary.md"));
    std::vector<std::string> terms;
    for (std::string line; std::getline(page, line);) {
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, '|');) cells.push_back(without_blanks_around(cell));
        if (cells.size() < 4 || cells[1] == "say" || cells[1].starts_with("---")) continue;
        std::istringstream list(cells[2]);
        for (std::string term; std::getline(list, term, ';');) terms.push_back(without_blanks_around(term));
    }
    return terms;
}

bool is_letter(char c) {
    return (static_cast<unsigned char>(c) & 0x80) != 0 || std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

std::string lowered(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(c < 0x80 ? std::tolower(c) : c); });
    return text;
}

// The first term that stands in the text as a word of its own; "" for none.
std::string banned_in(const std::string& text, const std::vector<std::string>& terms) {
    const std::string low = lowered(text);
    for (const std::string& term : terms) {
        const std::string word = lowered(term);
        for (auto at = low.find(word); at != low.npos; at = low.find(word, at + 1)) {
            const bool begins = at == 0 || !is_letter(low[at - 1]),
                       ends = at + word.size() == low.size() || !is_letter(low[at + word.size()]);
            if (begins && ends) return term;
        }
    }
    return "";
}

// "damping_mode", "scene=spin": a name for programs; "" for none. x_d and ε_max are symbols.
std::string identifier_in(const std::string& text) {
    static const std::regex snake("[a-z]{3,}_[a-z0-9]{2,}"), setting("\\b[a-z]{2,}=[A-Za-z0-9]");
    std::smatch found;
    if (std::regex_search(text, found, snake) || std::regex_search(text, found, setting)) return found.str();
    return "";
}

// A parameter of the lesson by its key, "k_bending", where it is not the symbol; "" for none.
std::string key_in(const std::string& text, const Lesson& lesson) {
    for (const Parameter* p : lesson.parameters) {
        const std::string key(p->info.key);
        if (key.find('_') == std::string::npos || key == p->info.symbol) continue;
        if (!banned_in(text, {key}).empty()) return key;
    }
    return "";
}

void add_slides(Sentences& all, const std::string& where, const std::vector<Slide>& slides) {
    for (const Slide& slide : slides) {
        all.push_back({where + ", slide", slide.title});
        for (const Block& b : slide.blocks) {
            const bool words = b.kind == BlockKind::text || b.kind == BlockKind::ask || b.kind == BlockKind::answer ||
                               b.kind == BlockKind::notes;
            if (words) all.push_back({fmt::format("{}, slide {}, line {}", where, slide.title, b.first_line), b.paragraph()});
        }
    }
}

// What the panel says of actions.
void add_actions(Sentences& all, const std::string& where, const Lesson& lesson, const std::vector<Slide>& slides) {
    for (const Slide& slide : slides)
        for (const Block& b : slide.blocks)
            if (b.kind == BlockKind::actions)
                for (const std::string& line : b.lines)
                    all.push_back({fmt::format("{}, slide {}: '{}'", where, slide.title, line), action_sentence(lesson, line)});
}

void add_declarations(Sentences& all, const std::string& id, const Lesson& lesson) {
    for (const Parameter* p : lesson.parameters) {
        const std::string where = fmt::format("{}, parameter {}", id, p->info.key);
        all.push_back({where, std::string(p->info.help)});
        all.push_back({where, spoken(p->info.key)});
        for (const Option& o : p->info.options) all.push_back({where, std::string(o.label)});
    }
    for (const Stage& s : lesson.stages) all.push_back({id + ", stage", spoken(s.name)});
    for (const Field& f : lesson.fields) {
        all.push_back({fmt::format("{}, field {}", id, f.name), std::string(f.help)});
        all.push_back({id + ", field", spoken(f.name)});
    }
    for (const Probe& p : lesson.probes) {
        all.push_back({fmt::format("{}, probe {}", id, p.name), std::string(p.help)});
        all.push_back({id + ", probe", spoken(p.name)});
    }
    for (const Line& l : lesson.lines) {
        const std::string where = fmt::format("{}, line {}", id, l.name);
        for (const std::string_view text : {l.help, l.position_name, l.reference_name, l.value_name})
            all.push_back({where, std::string(text)});
        all.push_back({where, spoken(l.name)});
        for (const CompareCurve& c : l.others) all.push_back({where, std::string(c.name)});
    }
    for (const Assumption& a : lesson.assumptions) {
        all.push_back({fmt::format("{}, assumption {}", id, a.name), std::string(a.broken)});
        all.push_back({id + ", assumption", spoken(a.name)});
    }
}

void add_claims(Sentences& all, const std::string& id) {
    for (const Claim* c : claims_of(id)) {
        for (const std::string& text : {c->statement, c->experiment, c->figure, c->question})
            all.push_back({"claim " + c->id, text});
        for (const std::string& answer : c->answers) all.push_back({"claim " + c->id, answer});
    }
}

Sentences sentences_of(const LessonEntry& entry) {
    Sentences all;
    const std::string id(entry.info.id);
    const auto lesson = entry.make();
    all.push_back({id, std::string(entry.info.title)});
    all.push_back({id, std::string(entry.info.summary)});
    add_declarations(all, id, *lesson);
    add_claims(all, id);
    if (find_text(id + "/walkthrough.md").empty()) return all;
    const Walkthrough walkthrough = walkthrough_of(entry);
    for (const std::string& p : walkthrough.introduction) all.push_back({id + ", introduction", p});
    add_slides(all, id, walkthrough.slides);
    add_actions(all, id, *lesson, walkthrough.slides);
    for (const Extension& e : extensions_of(entry)) {
        add_slides(all, id + ", extensions", e.walkthrough.slides);
        add_actions(all, id + ", extensions", *lesson, e.walkthrough.slides);
    }
    return all;
}

}  // namespace

TEST_CASE("every text of a lesson keeps to the glossary, and has no names for programs in it", "[every_lesson]") {
    const auto terms = banned_terms();
    REQUIRE(terms.size() > 20);
    for (const LessonEntry& entry : every_lesson()) {
        const Sentences all = sentences_of(entry);
        const auto lesson = entry.make();
        CHECK(all.size() > 10);
        for (const auto& [where, text] : all) {
            CAPTURE(where, text);
            CHECK(banned_in(text, terms) == "");
            CHECK(identifier_in(text) == "");
            CHECK(key_in(text, *lesson) == "");
        }
    }
}

TEST_CASE("the keys and groups keep to the glossary", "[glossary]") {
    const auto terms = banned_terms();
    std::istringstream page(read_file(PLIANT_SOURCE_DIR "/docs/keys.md"));
    for (std::string line; std::getline(page, line);) {
        CAPTURE(line);
        CHECK(banned_in(line, terms) == "");
        CHECK(identifier_in(line) == "");
    }
    for (const Group group : all_groups) CHECK(banned_in(std::string(name_of(group)), terms) == "");
}

TEST_CASE("the glossary finds what it bans, and lets symbols pass", "[glossary]") {
    const auto terms = banned_terms();
    CHECK(banned_in("Set the Timestep to 1.", terms) == "timestep");
    CHECK(banned_in("the Forward Euler method", terms) == "forward Euler");
    CHECK(banned_in("centred differences in colour", terms) == "");
    CHECK(identifier_in("set scene=spin damping_mode=naive") != "");
    CHECK(identifier_in("choose implicit_euler") == "implicit_euler");
    CHECK(identifier_in("x_d, ε_max, u_old and σ_xx; n = 4") == "");
}
