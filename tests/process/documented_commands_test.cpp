// Every command that README and the pages of docs print does what they say. A page is tested by itself: PLIANT_PAGE names it, and
// ctest has an entry for each.
#include "pliant.h"

#include <regex>
#include <set>

using namespace pliant::test;

namespace {

const std::string sources = PLIANT_SOURCE_DIR;

std::vector<std::string> pages() {
    if (const char* page = std::getenv("PLIANT_PAGE"); page && *page) return {page};
    std::vector<std::string> found{"README.md"};
    for (const char* folder : {"docs", "docs/lessons"})
        for (const auto& entry : fs::directory_iterator(fs::path(sources) / folder))
            if (entry.path().extension() == ".md") found.push_back(std::string(folder) + "/" + entry.path().filename().string());
    return found;
}

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    return {std::istream_iterator<std::string>(in), {}};
}

// What follows the name of the program, in "pliant run …", "build/release/bin/pliant run …" or "$ scripts/run run …".
std::optional<std::string> behind_program(const std::string& text) {
    static const std::regex program(R"(^(?:\$ )?(?:pliant|build/\S*/pliant|scripts/run)(?: +(.*))?$)");
    std::smatch m;
    if (!std::regex_match(text, m, program)) return std::nullopt;
    return m.str(1);
}

// Its words up to a remark, which stands behind two blanks or #.
std::string without_remark(const std::string& command) { return std::regex_replace(command, std::regex("(  | +#).*$"), ""); }

struct Commands {
    std::set<std::string> full;      // "run mesh/rod --steps 5"
    std::set<std::string> patterns;  // "run LESSON [--steps N]", "share"
};

// With a word that stands for another, LESSON, F.png, [--json], KEY=…; or one that opens a window, which is not run here.
bool is_pattern(const std::string& command) {
    if (command.find(" --present") != std::string::npos) return true;
    static const std::regex stands_for(R"((^|[ =])[A-Z]+(\.[a-z]+|x[A-Z]|=\S*|:\S*)?( |$)|\[|\.\.\.|…|\|)");
    return std::regex_search(command, stands_for);
}

class Reader {
public:
    static Commands read(const std::string& page) {
        Reader reader;
        std::istringstream in(page);
        for (std::string line; std::getline(in, line);) reader.take(line);
        return reader.commands_;
    }

private:
    void take(const std::string& line) {
        if (line.starts_with("```")) {
            inside_ = !inside_;
            last_.clear();
        } else if (inside_) {
            take_printed(line);
        } else {
            static const std::regex code("`([^`]+)`");
            for (std::sregex_iterator m(line.begin(), line.end(), code), end; m != end; ++m) note((*m)[1].str(), false);
        }
    }
    // A line of a block, or the options of the command above it.
    void take_printed(const std::string& line) {
        if (line.starts_with("    ") && !last_.empty()) {
            commands_.patterns.insert(words_of(last_).front() + " " + without_remark(line.substr(line.find_first_not_of(' '))));
            return;
        }
        last_ = note(line, true);
    }
    std::string note(const std::string& text, bool printed) {
        const auto behind = behind_program(without_remark(text));
        if (!behind) return "";
        const std::string& command = *behind;
        // A word alone is the name of a command, unless a block prints it.
        const bool named = words_of(command).size() < 2 && !printed;
        (is_pattern(command) || named || command.empty() ? commands_.patterns : commands_.full).insert(command);
        return command;
    }

    Commands commands_;
    bool inside_ = false;
    std::string last_;
};

// In a folder of its own, from which the sources are in sight. A claim may be that a run blows up.
void run_command(const std::string& command, bool may_diverge) {
    const Scratch scratch;
    for (const char* name : {"core", "lessons"}) fs::create_directory_symlink(fs::path(sources) / name, scratch.folder() / name);
    const auto words = words_of(command);
    const fs::path out = scratch.folder() / "standard_output", err = scratch.folder() / "standard_error";
    Child child(PLIANT_PROGRAM, words, out, err, {{"DISPLAY", std::nullopt}, {"WAYLAND_DISPLAY", std::nullopt}}, {},
                scratch.folder());
    REQUIRE(child.wait());
    INFO(contents_of(err));
    if (!may_diverge || child.exit_code() != diverged) CHECK(child.exit_code() == 0);
    const auto option = std::ranges::find(words, "--out");
    if (option != words.end())
        CHECK(fs::exists(scratch.folder() / *(option + 1)));
    else
        CHECK_FALSE(contents_of(out).empty());
}

// Its command and its options are there.
void check_pattern(const std::string& pattern) {
    const auto words = words_of(pattern);
    if (words.empty()) return;
    static const std::regex name("[a-z]+");
    if (!std::regex_match(words.front(), name)) return;
    const std::string help = output_of({words.front(), "--help"});
    static const std::regex option("--[a-z][a-z-]*");
    for (std::sregex_iterator m(pattern.begin(), pattern.end(), option), end; m != end; ++m) {
        INFO(m->str());
        CHECK(contains(help, m->str()));
    }
}

}  // namespace

TEST_CASE("documented commands: they are found in blocks and in texts, and told from what stands for them") {
    const Commands c = Reader::read(
        "Text `pliant run mesh/rod --steps 3` and `pliant share`, `pliant` and `pliant_bench`.\n"
        "| `pliant claims E4` | <!-- `pliant describe mesh/rod --markdown` -->\n"
        "```\n$ scripts/run list\npliant keys      the keys\nscripts/run     # the lab\npliant   the lab\nother run\n"
        "pliant run LESSON [--set key=value]...   a run\n             [--strict]    refuses\n```\n"
        "`pliant walkthrough LESSON --out DIR` `build/release/bin/pliant run rod --scene pliant1:eJx-_0` `pliant shot rod --out "
        "F.png`\n"
        "`pliant run rod --set F11=1 --steps 2`\n");
    CHECK(c.full == std::set<std::string>{"run mesh/rod --steps 3", "claims E4", "describe mesh/rod --markdown", "list", "keys",
                                          "run rod --scene pliant1:eJx-_0", "run rod --set F11=1 --steps 2"});
    CHECK(c.patterns == std::set<std::string>{"share", "", "run LESSON [--set key=value]...", "run [--strict]",
                                              "walkthrough LESSON --out DIR", "shot rod --out F.png"});
}

TEST_CASE("documented commands: all of a page run", "[every_page]") {
    for (const std::string& page : pages()) {
        INFO(page);
        const std::string text = contents_of(fs::path(sources) / page);
        REQUIRE_FALSE(text.empty());
        const Commands commands = Reader::read(text);
        // A page that has none says why.
        if (commands.full.empty()) CHECK(contains(text, "<!-- no commands: "));
        for (const std::string& command : commands.full) {
            INFO("pliant " << command);
            run_command(command, page == "docs/claims.md");
        }
        for (const std::string& pattern : commands.patterns) {
            INFO("pliant " << pattern);
            check_pattern(pattern);
        }
    }
}
