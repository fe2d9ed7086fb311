#include "tensor_texts.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

namespace pliant::energies {

std::string matrix_text(std::span<const Real> rows) {
    std::string text = "[";
    for (std::size_t k = 0; k < 9; ++k)
        text += fmt::format("{}{}", format_quantity(rows[k], "", 4), k == 8 ? "]" : k % 3 == 2 ? "; " : " ");
    return text;
}

std::string squares_text(std::span<const Real> x) {
    std::string text;
    for (const Real value : x)
        if (value != 0) text += fmt::format("{}{}²", text.empty() ? "" : " + ", as_factor(value, true));
    return text.empty() ? "0" : text;
}

}  // namespace pliant::energies
