// The parameters of the lesson, and what a dragged handle makes of them.
#include "projection.h"

namespace pliant::projection {
namespace {

constexpr Interval any_place{0, 1};

struct ArrowKeys {
    std::string_view x, y, u, v;
    std::string_view x_symbol, y_symbol, u_symbol, v_symbol;
    Real at_x, at_y, at_u, at_v;
};
constexpr std::array<ArrowKeys, arrow_count> arrows{
    {{"arrow1_x", "arrow1_y", "arrow1_u", "arrow1_v", "x₁", "y₁", "u₁", "v₁", 0.25, 0.3, 1, 0.2},
     {"arrow2_x", "arrow2_y", "arrow2_u", "arrow2_v", "x₂", "y₂", "u₂", "v₂", 0.7, 0.45, -0.6, 0.8},
     {"arrow3_x", "arrow3_y", "arrow3_u", "arrow3_v", "x₃", "y₃", "u₃", "v₃", 0.4, 0.75, 0.2, -0.9}}};

ParameterInfo place_of(std::string_view key, std::string_view symbol, Real initial, std::function<bool()> used) {
    return {.key = key,
            .symbol = symbol,
            .unit = "m",
            .help = "where the arrow begins; drag its dot in the picture",
            .initial = initial,
            .useful = any_place,
            .effect = Effect::rebuild,
            .used = std::move(used)};
}
ParameterInfo speed_of(std::string_view key, std::string_view symbol, Real initial, std::function<bool()> used) {
    return {.key = key,
            .symbol = symbol,
            .unit = "m/s",
            .help = "of the fluid about the arrow; drag its head in the picture",
            .initial = initial,
            .useful = {-2, 2},
            .accepted = Interval{-100, 100},
            .effect = Effect::rebuild,
            .used = std::move(used)};
}

}  // namespace

DrawnArrow::DrawnArrow(Lesson& owner, std::size_t which, std::function<bool()> used)
    : x(owner, place_of(arrows[which].x, arrows[which].x_symbol, arrows[which].at_x, used)),
      y(owner, place_of(arrows[which].y, arrows[which].y_symbol, arrows[which].at_y, used)),
      u(owner, speed_of(arrows[which].u, arrows[which].u_symbol, arrows[which].at_u, used)),
      v(owner, speed_of(arrows[which].v, arrows[which].v_symbol, arrows[which].at_v, used)) {}

Projection::Projection()
    : given(*this,
            {.key = "field",
             .help = "the velocity that is given; drawn: drag three arrows in the picture; through-flow: fluid at rest, with an "
                     "inflow on the left",
             .effect = Effect::rebuild},
            {{"swirl", "swirl and source"},
             {"source_sink", "source and sink"},
             {"jet", "jet"},
             {"random", "random"},
             {"checkerboard", "checkerboard"},
             {"gradient", "a gradient"},
             {"drawn", "drawn: three arrows"},
             {"through_flow", "through-flow"}}),
      resolution(*this, {.key = "resolution",
                         .symbol = "n",
                         .help = "cells along each side of the square; Δx = 1 m / n",
                         .initial = 24,
                         .useful = {4, 128},
                         .accepted = Interval{1, 256},
                         .effect = Effect::rebuild}),
      arrangement(*this,
                  {.key = "grid",
                   .help = "staggered: velocity on faces, pressure in cells. Collocated: both in cells, differences over 2Δx, no "
                           "solids, plain conjugate gradients",
                   .effect = Effect::rebuild,
                   .used = [this] { return given != Given::through_flow; }},
                  {{"staggered", "staggered"}, {"collocated", "collocated"}}),
      boundary(*this,
               {.key = "boundary",
                .help = "a closed box, or what leaves on one side enters on the other",
                .effect = Effect::rebuild,
                .used = [this] { return given != Given::through_flow; }},
               {{"box", "box"}, {"periodic", "periodic"}}),
      obstacle(*this,
               {.key = "obstacle",
                .help = "cells that are solid and at rest",
                .effect = Effect::rebuild,
                .used = [this] { return staggered(); }},
               {{"none", "none"},
                {"disc", "disc"},
                {"two_rooms", "two rooms"},
                {"one_cell", "one fluid cell"},
                {"all_solid", "all solid"}}),
      solver(*this,
             {.key = "solver",
              .help = "conjugate gradients for the pressure: plain, or with a preconditioner",
              .initial = static_cast<Real>(PressurePreconditioner::multigrid),
              .effect = Effect::rebuild,
              .used = [this] { return staggered(); }},
             {{"cg", "plain"}, {"jacobi", "Jacobi"}, {"incomplete_cholesky", "incomplete Cholesky"}, {"multigrid", "multigrid"}}),
      tolerance(*this, {.key = "tolerance",
                        .symbol = "τ",
                        .help = "the solver stops when max|∇·u| ≤ τ max|∇·ũ|",
                        .initial = 1e-6,
                        .useful = {1e-10, 0.5},
                        .accepted = Interval{1e-12, 1, false, true},
                        .scale = Scale::log,
                        .effect = Effect::rebuild}),
      max_iterations(*this, {.key = "max_iterations",
                             .help = "the solver gives up after so many passes, and says what is left",
                             .initial = 1000,
                             .useful = {1, 1000},
                             .accepted = Interval{1, 100000},
                             .scale = Scale::log,
                             .effect = Effect::rebuild}),
      dt(*this, {.key = "time_step",
                 .symbol = "Δt",
                 .unit = "s",
                 .help = "in which the pressure acts: half the time takes twice the pressure, and the velocity is the same",
                 .initial = 1,
                 .useful = {0.01, 1},
                 .accepted = Interval{0, 10, true},
                 .scale = Scale::log,
                 .effect = Effect::rebuild}),
      speed(*this, {.key = "speed",
                    .symbol = "U",
                    .unit = "m/s",
                    .help = "largest speed of a push, of the noise, of the wave or of the inflow",
                    .initial = 1,
                    .useful = {-2, 2},
                    .accepted = Interval{-1000, 1000},
                    .effect = Effect::rebuild,
                    .used = [this] { return given != Given::drawn; }}),
      outflow(*this, {.key = "outflow",
                      .symbol = "a",
                      .help = "share of the inflow that may leave on the right; without the rest there is no pressure",
                      .initial = 1,
                      .useful = {0, 1},
                      .effect = Effect::rebuild,
                      .used = [this] { return walls_move(); }}),
      disturbance(*this,
                  {.key = "pressure_checkerboard",
                   .symbol = "A",
                   .unit = "m²/s²",
                   .help = "added to the pressure that was found, with + and − in turn from cell to cell: does the grid feel it?",
                   .initial = 0,
                   .useful = {-1, 1},
                   .accepted = Interval{-1000, 1000},
                   .effect = Effect::rebuild}),
      seed(*this, {.key = "seed",
                   .help = "of the noise: another number, another field",
                   .initial = 1,
                   .useful = {1, 100},
                   .accepted = Interval{0, 1e9},
                   .effect = Effect::rebuild,
                   .used = [this] { return given == Given::random; }}),
      cell_x(*this, {.key = "cell_x",
                     .symbol = "x_c",
                     .unit = "m",
                     .help = "place of the cell that is drawn large; drag its dot in the picture",
                     .initial = 0.34,
                     .useful = any_place,
                     .effect = Effect::rebuild}),
      cell_y(*this, {.key = "cell_y",
                     .symbol = "y_c",
                     .unit = "m",
                     .help = "place of the cell that is drawn large; drag its dot in the picture",
                     .initial = 0.62,
                     .useful = any_place,
                     .effect = Effect::rebuild}) {
    for (std::size_t k = 0; k < arrow_count; ++k) drawn.emplace_back(*this, k, [this] { return given == Given::drawn; });
    declare_fields();
    declare_state();
    declare_stages();
    declare_probes();
    declare_lines();
    declare_checks();
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
