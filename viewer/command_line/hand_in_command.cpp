// `pliant handin`: what a student handed in, read and checked.
#include <pliant/document/hand_in.h>
#include <pliant/text/file.h>

#include "command_line/options.h"
#include "command_line/terminal.h"

#include <algorithm>

namespace pliant::viewer {

int hand_in(const std::string& path, bool json) {
    const HandInRead read = read_hand_in(read_file(path), path);
    const auto findings = check_hand_in(read.hand_in);
    print(json ? hand_in_report_json(read, findings) : hand_in_report(read, findings));
    const bool holds = read.unchanged && std::ranges::all_of(findings, &HandInFinding::holds);
    return holds ? 0 : static_cast<int>(ExitCode::check_failed);
}

}  // namespace pliant::viewer
