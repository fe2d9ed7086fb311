// Standard output and standard error that are closed, full or no longer read: the exit code is the one that the run has earned,
// and the files are written.
#include "pliant.h"

using namespace pliant::test;

namespace {

const Arguments small_run{"run", "elasticity/moduli", "--set", "resolution=1"};

Arguments with_arguments(Arguments a, const Arguments& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// What ends with this exit code, each with something to say on standard error but for the first.
struct Ending {
    Arguments arguments;
    int exit_code;
};
std::vector<Ending> endings() {
    return {{small_run, 0},
            {{"run", "mesh/mass_spring", "--time", "0.00123"}, 0},
            {{"study", "time/integration", "--map", "time_step=0.1,0.2", "omega=1,2", "--steps", "20", "--out", "maps"}, 0},
            {{"run", "elasticity/moduli", "--set", "youngs_modulus=-1"}, 2},
            {{"run", "mesh/mass_spring", "--set", "integrator=explicit_euler", "--set", "time_step=0.1", "--steps", "5000"}, 3},
            {{}, 4}};
}

std::vector<std::string> broken_outputs() {
    std::vector<std::string> all{"2>&-"};
    if (fs::exists("/dev/full")) all.emplace_back("2>/dev/full");
    return all;
}

// A pipe that nobody reads.
class DeafPipe {
public:
    DeafPipe() {
        int ends[2];
        REQUIRE(pipe2(ends, O_CLOEXEC) == 0);
        close(ends[0]);
        end_ = ends[1];
    }
    ~DeafPipe() { close(end_); }
    DeafPipe(const DeafPipe&) = delete;
    DeafPipe& operator=(const DeafPipe&) = delete;
    int end() const { return end_; }

private:
    int end_;
};

}  // namespace

TEST_CASE("a standard error that is closed or full changes no exit code", "[process]") {
    const Scratch scratch;
    for (const std::string& redirection : broken_outputs())
        for (Ending ending : endings()) {
            for (std::string& a : ending.arguments)
                if (a == "maps") a = scratch.path("maps");
            INFO(sentence(ending.arguments) << " " << redirection);
            CHECK(call_with(redirection, ending.arguments).exit_code == ending.exit_code);
        }
    CHECK(fs::exists(scratch.path("maps/map.csv")));
}

TEST_CASE("files are whole when standard error is closed or full, and hold nothing else", "[process]") {
    const Scratch scratch;
    const Arguments rounded{"run", "mesh/mass_spring", "--time", "0.00123"};
    output_of(with_arguments(rounded, {"--csv", scratch.path("right.csv")}));
    for (const std::string& redirection : broken_outputs()) {
        INFO(redirection);
        // With the first descriptors closed as well, a file would get one of their numbers.
        for (const std::string& closed : {std::string(), std::string("<&-")}) {
            const std::string csv = scratch.path("probes.csv");
            CHECK(call_with(redirection + " " + closed, with_arguments(rounded, {"--csv", csv})).exit_code == 0);
            CHECK(contents_of(csv) == contents_of(scratch.path("right.csv")));
            fs::remove(csv);
        }
    }
    CHECK(scratch.names() == std::vector<std::string>{"right.csv"});
}

TEST_CASE("who stops listening to standard error does not end the run", "[process]") {
    const Scratch scratch;
    const DeafPipe pipe;
    const std::string csv = scratch.path("probes.csv");
    Child child("/bin/sh",
                {"-c", "exec \"$0\" \"$@\" 2>&" + std::to_string(pipe.end()), PLIANT_PROGRAM, "run", "mesh/mass_spring", "--time",
                 "0.00123", "--csv", csv},
                scratch.folder() / "out", scratch.folder() / "err", {}, {pipe.end()});
    REQUIRE(child.wait());
    CHECK(child.exit_code() == 0);
    CHECK(contents_of(csv).starts_with("step,"));
}

TEST_CASE("who has read enough of standard output gets the exit code that the run has earned", "[process]") {
    const Scratch scratch;
    const DeafPipe pipe;
    Child child("/bin/sh", {"-c", "exec \"$0\" \"$@\" >&" + std::to_string(pipe.end()), PLIANT_PROGRAM, "list", "--json"},
                scratch.folder() / "out", scratch.folder() / "err", {}, {pipe.end()});
    REQUIRE(child.wait());
    CHECK(child.exit_code() == 0);
    CHECK(contents_of(scratch.folder() / "err").empty());
}

TEST_CASE("a standard output that is closed or full is told, and the files are written", "[process]") {
    const Scratch scratch;
    std::vector<std::string> broken{">&-", "<&- >&-"};
    if (fs::exists("/dev/full")) broken.emplace_back(">/dev/full");
    for (const std::string& redirection : broken) {
        INFO(redirection);
        const std::string csv = scratch.path("probes.csv");
        const Outcome run = call_with(redirection, with_arguments(small_run, {"--csv", csv}));
        CHECK(run.exit_code == 2);
        CHECK(contains(run.err, "standard output cannot be written"));
        CHECK(contents_of(csv).starts_with("step,"));
        for (const Arguments& text :
             {Arguments{"--help"}, Arguments{"--version"}, Arguments{"list"}, Arguments{"describe", "moduli"}}) {
            const Outcome outcome = call_with(redirection, text);
            INFO(sentence(text));
            CHECK(outcome.exit_code == 2);
            CHECK(contains(outcome.err, "standard output cannot be written"));
        }
        CHECK(call_with(redirection + " 2>&-", small_run).exit_code == 2);
        CHECK(call_with(redirection, {"run", "nothing"}).exit_code == 2);
        fs::remove(csv);
    }
}
