#include "command_line/terminal.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

namespace pliant::viewer {
namespace {

int output_error = 0;  // errno of the first write to standard output that failed

void note(bool written) {
    if (!written && output_error == 0) output_error = errno;
}

void put(std::FILE* to, std::string_view text, bool now) {
    errno = 0;
    const bool written = std::fwrite(text.data(), 1, text.size(), to) == text.size() && (!now || std::fflush(to) == 0);
    if (to == stdout) note(written);
}

}  // namespace

void take_standard_descriptors() {
    signal(SIGPIPE, SIG_IGN);
    // Writing to what is open for reading alone fails, as writing to what is closed does.
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(descriptor, F_GETFD) < 0 && open("/dev/null", O_RDONLY) < 0) return;
}

void print(std::string_view text) { put(stdout, text, false); }

void print_now(std::string_view text) { put(stdout, text, true); }

void tell(std::string_view sentence) { put(stderr, fmt::format("pliant: {}\n", sentence), true); }

void tell_raw(std::string_view text) { put(stderr, text, true); }

int after_output(int code) {
    errno = 0;
    note(std::fflush(stdout) == 0 && std::ferror(stdout) == 0);
    if (output_error == 0 || output_error == EPIPE) return code;
    tell(fmt::format("standard output cannot be written: {}", std::strerror(output_error)));
    return code == 0 ? static_cast<int>(ExitCode::refused) : code;
}

}  // namespace pliant::viewer
