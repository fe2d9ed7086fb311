// Every header of core, of the kits of the lessons and of the viewer compiles by itself.
//
// A header is alone when its text sees nothing but what it includes. So it need not come first in a unit of its own: it is alone
// as well where all that stands before it is among what it includes itself, directly or not. That lets one unit try a chain of
// headers, and lets the headers that most of them include be compiled once.
#ifdef PLIANT_COMPILER
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <catch2/catch_test_macros.hpp>

#include "sources.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;
using namespace layering;

namespace {

using Paths = std::set<std::string>;

using Chain = std::vector<std::string>;

// What headers include, by the path by which they are included themselves; those of the libraries have no entry.
using Headers = std::map<std::string, std::vector<std::string>>;

struct Project {
    Headers headers{};
    std::map<std::string, std::string> texts{};  // of the headers
};

Project project() {
    Project all;
    for (const std::string root : {"core/", "lessons/", "viewer/"})
        for (const Source& s : sources_below(root == "lessons/" ? "lessons/kits" : root.substr(0, root.size() - 1))) {
            if (!s.path.ends_with(".h")) continue;
            const std::string header = s.path.substr(root.size());
            all.texts[header] = s.text;
            for (const Include& i : includes_of(s.text)) all.headers[header].push_back(i.path);
            all.headers.try_emplace(header);
        }
    return all;
}

// What `header` includes, directly or not, itself too.
const Paths& closure(const Headers& headers, const std::string& header, std::map<std::string, Paths>& known) {
    const auto [entry, fresh] = known.try_emplace(header);
    if (!fresh) return entry->second;
    Paths all{header};
    if (const auto own = headers.find(header); own != headers.end())
        for (const std::string& included : own->second) all.merge(Paths(closure(headers, included, known)));
    return known[header] = std::move(all);
}

// The fewest units that try all headers: chains in which each header includes the one before it, directly or not. They are found
// as a largest matching of headers with the next of their chain.
class Units {
public:
    explicit Units(const Headers& headers) : headers_(headers) {
        for (const auto& [header, ignored] : headers) behind_[base_of(header)].push_back(header);
        for (const auto& [base, group] : behind_) {
            for (const std::string& header : group) {
                Paths asked;
                find_next(header, group, asked);
            }
            for (const std::string& header : group)
                if (!before_.contains(header)) units_[base].push_back(chain_from(header));
        }
    }

    // By the header that is compiled before, or none.
    const std::map<std::string, std::vector<Chain>>& units() const { return units_; }

private:
    inline static const std::vector<std::string> bases{"pliant/run/runner.h", "pliant/lesson/lesson.h", "pliant/math/types.h"};

    bool includes(const std::string& header, const std::string& other) {
        return header != other && closure(headers_, header, closures_).contains(other);
    }

    // The largest of the headers compiled before that this one includes, "" where there is none.
    std::string base_of(const std::string& header) {
        const auto found = std::ranges::find_if(bases, [&](const std::string& base) { return includes(header, base); });
        return found == bases.end() ? "" : *found;
    }

    // An augmenting path of the matching (Kuhn, 1955).
    bool find_next(const std::string& header, const std::vector<std::string>& group, Paths& asked) {
        for (const std::string& next : group) {
            if (!includes(next, header) || !asked.insert(next).second) continue;
            const auto taken = before_.find(next);
            if (taken != before_.end() && !find_next(taken->second, group, asked)) continue;
            before_[next] = header, next_[header] = next;
            return true;
        }
        return false;
    }

    Chain chain_from(std::string header) const {
        Chain chain{header};
        for (auto next = next_.find(header); next != next_.end(); next = next_.find(next->second)) chain.push_back(next->second);
        return chain;
    }

    const Headers& headers_;
    std::map<std::string, Paths> closures_;
    std::map<std::string, std::vector<std::string>> behind_;
    std::map<std::string, std::string> before_, next_;  // in its chain
    std::map<std::string, std::vector<Chain>> units_;
};

std::string file_name(const std::string& header) {
    std::string name = header;
    std::ranges::replace(name, '/', '_');
    return name;
}

void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::string read_all(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

// What the compiler says of units that include these headers behind the base; "" when it says nothing.
std::string compile(const fs::path& folder, const std::string& base, const std::vector<Chain>& chains) {
    fs::create_directories(folder);
    const fs::path said = folder / "said.txt";
    const std::string compiler = fmt::format("\"{}\" -std=c++20 @\"{}\"", PLIANT_COMPILER, PLIANT_INCLUDE_FLAGS);
    const auto run = [&](const std::string& arguments) {
        const int status = std::system(fmt::format("{} {} >\"{}\" 2>&1", compiler, arguments, said.string()).c_str());
        return status == 0 ? "" : fmt::format("{}\nexit status {}", read_all(said), status);
    };
    std::string before;
    if (!base.empty()) {
        const fs::path first = folder / file_name(base);
        write(first, fmt::format("#include <{}>\n", base));
        if (std::string wrong = run(fmt::format("-x c++-header \"{0}\" -o \"{0}.gch\"", first.string())); !wrong.empty())
            return wrong;
        before = fmt::format("-include \"{}\"", first.string());
    }
    std::string units;
    for (const std::vector<std::string>& chain : chains) {
        const fs::path unit = folder / (file_name(chain.front()) + ".cpp");
        std::string text;
        for (const std::string& header : chain) text += fmt::format("#include \"{}\"\n", header);
        write(unit, text);
        units += fmt::format(" \"{}\"", unit.string());
    }
    return run(fmt::format("-fsyntax-only {}{}", before, units));
}

// Which chains have been tried as they are now, kept from one run of the test to the next: what has not changed is not compiled
// again.
class Passed {
public:
    explicit Passed(fs::path file) : file_(std::move(file)) {
        std::ifstream in(file_);
        for (std::size_t signature = 0; in >> signature;) passed_.insert(signature);
    }
    bool contains(std::size_t signature) const { return passed_.contains(signature); }
    void add(std::size_t signature) { std::ofstream(file_, std::ios::app) << signature << "\n"; }

private:
    fs::path file_;
    std::set<std::size_t> passed_;
};

// Of the chain with the texts of all that it includes, and of how it is compiled.
std::size_t signature_of(const Project& all, const std::string& base, const Chain& chain) {
    std::map<std::string, Paths> closures;
    std::string text = fmt::format("{} {} {}\n", PLIANT_COMPILER, read_all(PLIANT_INCLUDE_FLAGS), base);
    for (const std::string& header : chain) text += header + "\n";
    for (const std::string& header : closure(all.headers, chain.back(), closures))
        if (const auto own = all.texts.find(header); own != all.texts.end()) text += header + "\n" + own->second;
    return std::hash<std::string>{}(text);
}

fs::path work_folder(const std::string& name) { return fs::path(PLIANT_WORK_DIR) / "headers" / name; }

}  // namespace

TEST_CASE("headers are tried in chains in which each includes the one before", "[layering]") {
    const Headers headers{{"a.h", {"vector"}}, {"b.h", {"a.h"}}, {"c.h", {"a.h"}}, {"d.h", {"c.h", "b.h"}}, {"e.h", {}}};
    const auto chains = Units(headers).units().at("");
    CHECK(chains.size() == 3);
    std::size_t tried = 0;
    std::map<std::string, Paths> closures;
    for (const auto& chain : chains) {
        tried += chain.size();
        for (std::size_t k = 1; k < chain.size(); ++k) CHECK(closure(headers, chain[k], closures).contains(chain[k - 1]));
    }
    CHECK(tried == headers.size());
}

TEST_CASE("a header that does not compile alone is found", "[layering][headers][slow]") {
    const fs::path folder = work_folder("found");
    fs::create_directories(folder);
    write(folder / "good.h", "#pragma once\n#include <string>\ninline std::string good() { return {}; }\n");
    write(folder / "bad.h", "#pragma once\ninline std::string bad() { return {}; }\n");
    CHECK(compile(folder, "", {{(folder / "good.h").string()}}).empty());
    CHECK(compile(folder, "", {{(folder / "good.h").string()}, {(folder / "bad.h").string()}}).find("bad.h") !=
          std::string::npos);
}

TEST_CASE("every header compiles by itself", "[layering][headers][slow]") {
    const Project all = project();
    CHECK(all.headers.size() > 200);
    const Units units(all.headers);
    std::size_t tried = 0;
    for (const auto& [base, chains] : units.units()) {
        const fs::path folder = work_folder(base.empty() ? "none" : file_name(base));
        fs::create_directories(folder);
        Passed passed(folder / "passed.txt");
        std::vector<Chain> changed;
        std::vector<std::size_t> signatures;
        for (const Chain& chain : chains) {
            tried += chain.size();
            const std::size_t signature = signature_of(all, base, chain);
            if (!passed.contains(signature)) changed.push_back(chain), signatures.push_back(signature);
        }
        if (changed.empty()) continue;
        INFO(fmt::format("behind {}: {} units", base.empty() ? "nothing" : base, changed.size()));
        const std::string wrong = compile(folder, base, changed);
        CHECK(wrong == "");
        if (wrong.empty())
            for (const std::size_t signature : signatures) passed.add(signature);
    }
    CHECK(tried == all.headers.size());
}

#endif
