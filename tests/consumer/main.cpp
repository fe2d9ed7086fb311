// Refuses a Poisson's ratio through the installed library: headers, archive and their own dependencies must all be found.
#include <pliant/math/error.h>
#include <pliant/math/parallel.h>

#include <iostream>
#include <string>

int main() {
    const pliant::Vec<2> corner(3, 4);
    if (corner.norm() != 5) return 1;
    pliant::set_threads(2);
    if (pliant::parallel_sum(100'000, [](pliant::Index first, pliant::Index last) { return double(last - first); }) != 100'000)
        return 1;
    try {
        throw pliant::Refused("poisson_ratio", 0.6, "", "(-1, 0.5)");
    } catch (const pliant::Error& error) {
        std::cout << error.what() << '\n';
        const bool named = std::string(error.what()).find("poisson_ratio") != std::string::npos;
        return named && error.code() == pliant::ExitCode::refused ? 0 : 1;
    }
}
