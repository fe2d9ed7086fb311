#include "linear_body_picture.h"

#include <cmath>

namespace pliant::linear_body {
namespace {

// Largest of 1, 2, 5, 10, 20, ... (or 0.5, 0.2, ...) that is not above the value.
Real round_down(Real value) {
    const Real decade = std::pow(10.0, std::floor(std::log10(value)));
    const Real lead = value / decade;
    return decade * (lead >= 5 ? 5 : lead >= 2 ? 2 : 1);
}

}  // namespace

Real magnification_for(Real largest_strain) {
    if (largest_strain == 0) return 1;
    const Real wanted = round_down(0.3 / largest_strain);
    return wanted < 1 && largest_strain < 0.6 ? 1 : wanted;
}

void draw_surface(Scene& scene, const Lesson& lesson, const SimplexMesh<3>& mesh, const std::function<Vec<3>(Index)>& place,
                  float opacity) {
    TriangleMarks surface{.corners = {}, .triangles = {}, .ink = Ink::body, .opacity = opacity, .edges = true};
    const std::vector<float> on_nodes = scene.values(lesson, On::node), on_elements = scene.values(lesson, On::element);
    for (Index f = 0; f < mesh.facet_count(); ++f) {
        const int first = static_cast<int>(surface.corners.size());
        surface.triangles.push_back({first, first + 1, first + 2});
        for (int a = 0; a < 3; ++a) {
            const Index n = mesh.facets()(a, f);
            surface.corners.push_back(position<3>(place(n)));
            if (!on_nodes.empty()) surface.values.push_back(on_nodes[static_cast<std::size_t>(n)]);
            if (!on_elements.empty()) surface.values.push_back(on_elements[static_cast<std::size_t>(mesh.facet_simplex(f))]);
        }
        surface.pick.ids.push_back(mesh.facet_simplex(f));
    }
    surface.pick.pickable = true;
    surface.pick.on = On::element;
    scene.triangles.push_back(std::move(surface));
}

}  // namespace pliant::linear_body
