// `pliant claims`: what the lectures say, measured now.
#include <pliant/study/claims_report.h>

#include "command_line/options.h"
#include "command_line/terminal.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

namespace pliant::viewer {
namespace {

// All without ids; each once, however often it is named. Throws Refused.
std::vector<const Claim*> chosen(const std::vector<std::string>& ids) {
    std::vector<const Claim*> list;
    for (const std::string& id : ids) {
        const Claim* c = &find_claim(id);
        if (std::ranges::find(list, c) == list.end()) list.push_back(c);
    }
    if (ids.empty())
        for (const Claim& c : pliant::claims()) list.push_back(&c);
    return list;
}

// On a terminal alone: which claim is being measured, on a line that goes away.
class Progress {
public:
    explicit Progress(std::size_t count) : count_(count), shown_(isatty(STDERR_FILENO)) {}
    void measuring(std::size_t number, const Claim& c) const {
        if (shown_) tell_raw(fmt::format("\r\033[K{} of {}: {} …", number + 1, count_, c.id));
    }
    void clear() const {
        if (shown_) tell_raw("\r\033[K");
    }

private:
    std::size_t count_;
    bool shown_;
};

}  // namespace

int claims(const ClaimsOptions& o) { return measure_claims(chosen(o.ids), o); }

int measure_claims(const std::vector<const Claim*>& list, const ClaimsOptions& o) {
    const bool table = !o.json && !o.markdown;
    const Progress progress(list.size());
    std::vector<ClaimResult> results;
    if (table) print_now(claims_head());
    for (std::size_t i = 0; i < list.size(); ++i) {
        progress.measuring(i, *list[i]);
        results.push_back(measured(*list[i]));
        progress.clear();
        if (table) print_now(claims_row(results.back()));
    }
    print(o.json ? claims_json(results) : o.markdown ? claims_markdown(results) : claims_tail(results));
    if (const std::string text = fallen(results); !text.empty()) throw CheckFailed(text);
    return 0;
}

}  // namespace pliant::viewer
