// The text of a walkthrough as slides and blocks.
#include <pliant/document/walkthrough.h>
#include <pliant/document/walkthrough_words.h>
#include <pliant/text/texts.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>

namespace pliant {

std::vector<std::string> words_of_line(const std::string& line) {
    std::istringstream in(line);
    return {std::istream_iterator<std::string>(in), {}};
}

bool SetUp::takes(const std::string& line) {
    const auto words = words_of_line(line);
    if (!open_ || words.empty()) return open_;
    const bool solves = words[0] == "solve";
    open_ = words[0] == "set" || words[0] == "reset" || words[0] == "preset" || words[0] == "show";
    return open_ || solves;
}

Runner::Assignments assignments_of(const std::vector<std::string>& words) {
    Runner::Assignments result;
    for (std::size_t i = 1; i < words.size(); ++i) {
        const auto equals = words[i].find('=');
        if (equals == std::string::npos) throw Refused(fmt::format("'{}' is not KEY=VALUE", words[i]));
        result.emplace_back(words[i].substr(0, equals), words[i].substr(equals + 1));
    }
    return result;
}

std::string trimmed(std::string_view line) {
    const auto first = line.find_first_not_of(" \t\r"), last = line.find_last_not_of(" \t\r");
    return first == std::string_view::npos ? "" : std::string(line.substr(first, last - first + 1));
}

namespace {

struct Fence {
    std::string_view name;
    BlockKind kind;
};
constexpr std::array<Fence, 12> fences{{{"scene", BlockKind::scene},
                                        {"show", BlockKind::show},
                                        {"formula", BlockKind::formula},
                                        {"ask", BlockKind::ask},
                                        {"predict", BlockKind::predict},
                                        {"do", BlockKind::actions},
                                        {"expect", BlockKind::expect},
                                        {"answer", BlockKind::answer},
                                        {"hide", BlockKind::hide},
                                        {"plots", BlockKind::plots},
                                        {"notes", BlockKind::notes},
                                        {"controls", BlockKind::controls}}};

}  // namespace

std::optional<BlockKind> block_kind(std::string_view name) {
    const auto found = std::ranges::find(fences, name, &Fence::name);
    return found == fences.end() ? std::nullopt : std::optional(found->kind);
}

std::string_view name_of(BlockKind kind) {
    const auto found = std::ranges::find(fences, kind, &Fence::kind);
    return found == fences.end() ? "text" : found->name;
}

namespace {

bool fits(BlockKind kind, ExtraBlock extra) {
    return kind == BlockKind::scene ? extra == ExtraBlock::scene : kind == BlockKind::show ? extra == ExtraBlock::show : true;
}

std::string known_fences(ExtraBlock extra) {
    std::vector<std::string_view> names;
    for (const Fence& f : fences)
        if (fits(f.kind, extra)) names.push_back(f.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

// Reads the file line by line into slides and blocks.
class Reader {
public:
    Reader(std::string_view text, std::string_view path, ExtraBlock extra) : text_(text), extra_(extra) { result_.path = path; }

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
        if (const auto at = line.find('\0'); at != std::string::npos)
            refuse(fmt::format("a NUL byte stands in column {}: this is no text, or it was damaged", at + 1));
        if (line.starts_with("```")) return fence(trimmed(line.substr(3)));
        if (inside_) return block().lines.push_back(line);
        if (line.starts_with("## ")) return result_.slides.push_back({trimmed(line.substr(3)), {}, number_});
        if (line.starts_with("# ")) return void(result_.title = trimmed(line.substr(2)));
        const std::string text = trimmed(line);
        if (result_.slides.empty()) return introduce(text);
        auto& blocks = result_.slides.back().blocks;
        const bool goes_on = !blocks.empty() && blocks.back().kind == BlockKind::text && !paragraph_ended_;
        paragraph_ended_ = text.empty();
        if (text.empty()) return;
        if (goes_on)
            blocks.back().lines.back() += " " + text;
        else
            blocks.push_back({BlockKind::text, {text}, number_});
    }

    void introduce(const std::string& text) {
        auto& paragraphs = result_.introduction;
        if (!text.empty() && (paragraphs.empty() || paragraph_ended_))
            paragraphs.push_back(text);
        else if (!text.empty())
            paragraphs.back() += " " + text;
        paragraph_ended_ = text.empty();
    }

    void fence(const std::string& name) {
        if (inside_) {
            if (!name.empty()) refuse("a block ends with ``` alone");
            inside_ = false;
            return;
        }
        if (result_.slides.empty()) refuse("a block stands before the first slide ('## Title')");
        const auto kind = block_kind(name);
        if (!kind || !fits(*kind, extra_)) refuse(fmt::format("unknown block '{}'; known: {}", name, known_fences(extra_)));
        result_.slides.back().blocks.push_back({*kind, {}, number_ + 1});
        inside_ = true;
        paragraph_ended_ = true;
    }

    Block& block() { return result_.slides.back().blocks.back(); }

    std::string_view text_;
    ExtraBlock extra_;
    Walkthrough result_;
    int number_ = 0;
    bool inside_ = false, paragraph_ended_ = true;
};

bool has_word(const Block& block, std::string_view word) {
    const auto words = words_of_line(block.paragraph());
    return std::ranges::find(words, word) != words.end();
}

}  // namespace

std::string Block::paragraph() const {
    std::string text;
    for (const std::string& line : lines)
        if (const std::string words = trimmed(line); !words.empty()) text += fmt::format("{}{}", text.empty() ? "" : " ", words);
    return text;
}

bool Slide::has(BlockKind kind) const { return std::ranges::find(blocks, kind, &Block::kind) != blocks.end(); }

std::string Slide::notes() const {
    std::string text;
    for (const Block& b : blocks)
        if (b.kind == BlockKind::notes) text += fmt::format("{}{}", text.empty() ? "" : "\n", b.paragraph());
    return text;
}

bool Slide::allows(std::string_view key) const {
    if (!has(BlockKind::controls)) return true;
    return std::ranges::any_of(blocks, [&](const Block& b) { return b.kind == BlockKind::controls && has_word(b, key); });
}

std::optional<std::vector<std::string>> Slide::plots() const {
    const auto block = std::ranges::find(blocks, BlockKind::plots, &Block::kind);
    if (block == blocks.end()) return std::nullopt;
    const std::string names = block->paragraph();
    return names == "none" ? std::vector<std::string>{} : words_of_line(names);
}

bool Slide::hides(std::string_view name) const {
    if (!has_answer()) return false;
    if (name == "lights" && has(BlockKind::ask)) return true;
    return std::ranges::any_of(blocks, [&](const Block& b) {
        if (b.kind == BlockKind::hide) return has_word(b, name);
        if (b.kind != BlockKind::expect && b.kind != BlockKind::predict) return false;
        // NAME OP ...; of a prediction: number NAME, sketch NAME, WORDS | NAME OP ...
        return std::ranges::any_of(b.lines, [&](const std::string& condition) {
            const auto bar = condition.rfind('|');
            const auto words = words_of_line(bar == std::string::npos ? condition : condition.substr(bar + 1));
            const bool asked = !words.empty() && (words[0] == "number" || words[0] == "sketch");
            return words.size() > 1 && words[asked ? 1 : 0] == name;
        });
    });
}

Walkthrough parse_walkthrough(std::string_view text, std::string_view path, ExtraBlock extra) {
    return Reader(text, path, extra).read();
}

Walkthrough walkthrough_of(const LessonEntry& entry) {
    const std::string path = fmt::format("{}/walkthrough.md", entry.info.id);
    const std::string_view text = find_text(path);
    if (text.empty()) throw Refused(fmt::format("{} has no walkthrough", entry.info.id));
    return parse_walkthrough(text, path);
}

}  // namespace pliant
