// The parameters of the lesson, and what a dragged handle makes of them.
#include "projection.h"

namespace pliant::projection {
namespace {

struct ArrowKeys {
    std::string_view x, y, u, v;
    std::string_view x_symbol, y_symbol, u_symbol, v_symbol;
    Real at_x, at_y, at_u, at_v;
};
constexpr std::array<ArrowKeys, arrow_count> arrows{
    {{"arrow1_x", "arrow1_y", "arrow1_u", "arrow1_v", "x₁", "y₁", "u₁", "v₁", 0.25, 0.3, 1, 0.2},
     {"arrow2_x", "arrow2_y", "arrow2_u", "arrow2_v", "x₂", "y₂", "u₂", "v₂", 0.7, 0.45, -0.6, 0.8},
     {"arrow3_x", "arrow3_y", "arrow3_u", "arrow3_v", "x₃", "y₃", "u₃", "v₃", 0.4, 0.75, 0.2, -0.9}}};

ParameterInfo place_of(std::string_view key, std::string_view symbol, Real initial) {
    return quantity(key, symbol, "m", initial, {0, 1}, "where the arrow begins; drag its dot in the picture").rebuilds();
}
ParameterInfo speed_of(std::string_view key, std::string_view symbol, Real initial) {
    return quantity(key, symbol, "m/s", initial, {-2, 2}, {-100, 100},
                    "of the fluid about the arrow; drag its head in the picture")
        .rebuilds();
}

}  // namespace

DrawnArrow::DrawnArrow(Lesson& owner, std::size_t which, std::function<bool()> used)
    : x(owner, place_of(arrows[which].x, arrows[which].x_symbol, arrows[which].at_x), used),
      y(owner, place_of(arrows[which].y, arrows[which].y_symbol, arrows[which].at_y), used),
      u(owner, speed_of(arrows[which].u, arrows[which].u_symbol, arrows[which].at_u), used),
      v(owner, speed_of(arrows[which].v, arrows[which].v_symbol, arrows[which].at_v), used) {}

Projection::Projection() {
    for (std::size_t k = 0; k < arrow_count; ++k) drawn.emplace_back(*this, k, [this] { return given == Given::drawn; });
    declare_fields(), declare_stages(), declare_probes(), declare_lines(), declare_checks();
}

// A handle goes where the hand goes.
std::vector<std::pair<std::string, Real>> Projection::dragged(const Pull& pull) const {
    if (pull.index == cell_handle) return {{"cell_x", pull.to[0]}, {"cell_y", pull.to[1]}};
    const bool tip = pull.index >= first_tip;
    const Index k = pull.index - (tip ? first_tip : first_place);
    if (given != Given::drawn || k < 0 || k >= Index(arrow_count)) return {};
    const ArrowKeys& keys = arrows[static_cast<std::size_t>(k)];
    if (!tip) return {{std::string(keys.x), pull.to[0]}, {std::string(keys.y), pull.to[1]}};
    const Vec<2> velocity = (pull.to.head<2>() - drawn[static_cast<std::size_t>(k)].place()) / drawn_scale;
    return {{std::string(keys.u), velocity[0]}, {std::string(keys.v), velocity[1]}};
}

}  // namespace pliant::projection
