// Courant numbers at which the lectures call semi-Lagrangian advection stable, asked for on the command line.
#include "pliant.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace pliant::test;

namespace {

// A column of the table of probes, step by step.
std::vector<double> column(const std::filesystem::path& table, const std::string& name) {
    std::ifstream file(table);
    std::string line, cell;
    REQUIRE(std::getline(file, line));
    std::istringstream heads(line);
    int wanted = 0;
    while (std::getline(heads, cell, ',') && cell != name) ++wanted;
    REQUIRE(cell == name);
    std::vector<double> values;
    while (std::getline(file, line)) {
        std::istringstream row(line);
        for (int k = 0; k <= wanted; ++k) std::getline(row, cell, ',');
        values.push_back(std::stod(cell));
    }
    return values;
}

}  // namespace

TEST_CASE("advection at Courant numbers 0.1 to 100 is finite, and its largest value never grows", "[process][advection]") {
    const auto table = std::filesystem::temp_directory_path() / "pliant_advection_extremes.csv";
    for (const char* scheme : {"semi_lagrangian_linear", "monotone_cubic", "mac_cormack"})
        for (const char* cfl : {"0.1", "1", "5", "20", "100"}) {
            INFO(scheme << " at CFL " << cfl);
            const Outcome outcome =
                call(with({"run", "fluids/advection", "--steps", "25", "--json", "--csv", table.string()},
                          {"blob=slotted_disc", "resolution=24", std::string("cfl=") + cfl, std::string("scheme=") + scheme}));
            INFO(outcome.err);
            REQUIRE(outcome.exit_code == 0);
            CHECK(Json::parse(outcome.out)["conserved"]["peak"]["status"] == "holds");
            const std::vector<double> peak = column(table, "peak"), lowest = column(table, "lowest");
            REQUIRE(peak.size() == 26);
            for (std::size_t k = 1; k < peak.size(); ++k) {
                CHECK(std::isfinite(peak[k]));
                CHECK(peak[k] <= peak[k - 1] + 1e-14);
                CHECK(lowest[k] >= lowest[k - 1] - 1e-14);
            }
        }
    std::filesystem::remove(table);
}

TEST_CASE("a Courant number that is none is refused with its range", "[process][advection]") {
    for (const char* cfl : {"0", "-1", "1e9", "nan"}) {
        const Outcome outcome = call({"run", "fluids/advection", "--steps", "1", "--set", std::string("cfl=") + cfl});
        INFO(outcome.err);
        CHECK(outcome.exit_code == refused);
        CHECK(contains(outcome.err, "cfl = "));
    }
}
