// Programs started by a test, as a person's shell starts them.
#pragma once
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace pliant::test {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;
// Changes to the environment: a variable without a value is unset.
using Environment = std::vector<std::pair<std::string, std::optional<std::string>>>;

inline std::string contents_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

inline void write_text(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

// For whatever is waited for: only what hangs takes so long, however busy the machine is.
inline constexpr std::chrono::minutes patience{20};

// A folder of the test's own, gone when it ends.
class Scratch {
public:
    Scratch() {
        std::string name = (fs::temp_directory_path() / "pliant_test.XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no folder can be made in " + fs::temp_directory_path().string());
        folder_ = name;
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    const fs::path& folder() const { return folder_; }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    // Writes a file and gives its path.
    std::string file(const std::string& name, const std::string& text) const {
        write_text(folder_ / name, text);
        return path(name);
    }
    std::vector<std::string> names() const {
        std::vector<std::string> found;
        for (const auto& entry : fs::directory_iterator(folder_)) found.push_back(entry.path().filename().string());
        std::ranges::sort(found);
        return found;
    }

private:
    fs::path folder_;
};

// A process that ends with its owner at the latest. Its output goes to two files.
class Child {
public:
    // keep_open: descriptors that the program inherits; folder: where it runs, this process's own when empty.
    Child(const std::string& program, const Arguments& arguments, const fs::path& out, const fs::path& err,
          const Environment& environment = {}, const std::vector<int>& keep_open = {}, const fs::path& folder = {}) {
        std::vector<char*> words{const_cast<char*>(program.c_str())};
        for (const std::string& a : arguments) words.push_back(const_cast<char*>(a.c_str()));
        words.push_back(nullptr);
        pid_ = fork();
        if (pid_ < 0) throw std::runtime_error("no process can be started");
        if (pid_ == 0) {
            for (const auto& [name, value] : environment)
                value ? setenv(name.c_str(), value->c_str(), 1) : unsetenv(name.c_str());
            redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
            redirect(STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
            redirect(STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
            if (!folder.empty() && chdir(folder.c_str()) != 0) _exit(126);
            for (const int descriptor : keep_open) fcntl(descriptor, F_SETFD, 0);
            execvp(program.c_str(), words.data());
            _exit(127);
        }
    }
    ~Child() { end(SIGKILL); }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    bool running() {
        if (pid_ > 0 && waitpid(pid_, &status_, WNOHANG) == pid_) pid_ = -1;
        return pid_ > 0;
    }
    // Waits until it has ended by itself; false when it hangs.
    bool wait() {
        const auto deadline = std::chrono::steady_clock::now() + patience;
        auto pause = std::chrono::microseconds(500);
        while (running() && std::chrono::steady_clock::now() < deadline) {
            std::this_thread::sleep_for(pause);
            pause = std::min(2 * pause, std::chrono::microseconds(10000));
        }
        return !running();
    }
    void end(int signal) {
        if (!running()) return;
        kill(pid_, signal);
        waitpid(pid_, &status_, 0);
        pid_ = -1;
    }
    // Of one that has ended; -1 when a signal ended it.
    int exit_code() const { return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1; }

private:
    static void redirect(int descriptor, const char* file, int flags) {
        const int opened = open(file, flags, 0666);
        if (opened < 0 || dup2(opened, descriptor) < 0) _exit(126);
        close(opened);
    }
    pid_t pid_ = -1;
    int status_ = 0;
};

struct Outcome {
    int exit_code = -1;  // -1: ended by a signal, or it hung
    std::string out, err;
};

inline Outcome run_process(const std::string& program, const Arguments& arguments, const Environment& environment = {}) {
    const Scratch scratch;
    const fs::path out = scratch.folder() / "out", err = scratch.folder() / "err";
    Child child(program, arguments, out, err, environment);
    if (!child.wait()) child.end(SIGKILL);
    return {child.exit_code(), contents_of(out), contents_of(err)};
}

}  // namespace pliant::test
