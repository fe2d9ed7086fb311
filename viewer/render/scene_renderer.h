// Draws a Scene into a texture.
#pragma once
#include <pliant/lesson/scene.h>

#include "platform/context.h"
#include "render/camera.h"
#include "render/gl_objects.h"
#include "render/palette.h"
#include "render/picture.h"

#include <optional>
#include <span>

namespace pliant::viewer {

class SceneRenderer {
public:
    SceneRenderer();

    // Everything but the labels, which the panel writes over it. pixel_scale multiplies the sizes of marks; right_margin as for
    // Projection. With `patterns` negative numbers show by more than their colours: hatched areas with lines between equal
    // numbers, squares in place of discs, dashed lines. The texture is opaque, its rows bottom-up.
    // A picture that was drawn last, seen as it was then, is not drawn again.
    GLuint render(const Picture& picture, int dimension, const Camera& camera, const Palette& palette, const ColourScale& scale,
                  Size size, float pixel_scale, float right_margin, bool patterns = false);

private:
    // One instance: two ends, a colour and the number that it shows; 0 for none.
    struct Segment {
        Position a, b;
        Rgba8 colour;
        float value = 0;
    };
    struct Corner {
        Position at;
        Rgba8 colour;
        float value = 0;
    };
    struct MarkProgram {
        GlProgram program;
        GlVertexArray array;
        GlBuffer corners;
        int vertices = 0;
    };

    // How a picture was seen.
    struct Seen {
        long picture = 0;
        Camera camera{};
        const Palette* palette = nullptr;
        ColourScale scale{};
        Size size{};
        float pixel_scale = 1, right_margin = 0;
        bool patterns = false;
        bool operator==(const Seen&) const = default;
    };

    MarkProgram mark_program(const char* vertex, const char* fragment, std::span<const float> corners);
    void ensure_target(Size size);
    void draw_grid(const GridMarks& grid);
    void draw_triangles(const TriangleMarks& marks);
    void draw_lines(const LineMarks& marks);
    void draw_arrows(const ArrowMarks& marks);
    void draw_points(const PointMarks& marks);
    void draw_segments(const MarkProgram& program, float width, float dash = 0, float shorten = 0);
    void common_uniforms(GLuint program) const;
    Rgba8 colour_of(const std::vector<float>& values, std::size_t i, Ink ink, float opacity = 1) const;

    MarkProgram lines_, heads_, points_;
    GlProgram triangle_program_, grid_program_;
    GlVertexArray triangle_array_, grid_array_;
    GlBuffer instances_, corners_, grid_corners_;
    GlTexture numbers_, table_, colour_;
    GlFramebuffer framebuffer_;
    GlRenderbuffer depth_;
    Size size_;
    std::optional<Seen> seen_;

    // of the picture being drawn
    Eigen::Matrix4f matrix_, view_;
    bool lit_ = false, patterns_ = false, awaited_ = false;  // awaited: the numbers of the field are none yet
    float pixel_scale_ = 1;
    const Palette* palette_ = nullptr;
    ColourScale scale_;
    std::vector<Segment> segments_;
    std::vector<Corner> corners_data_;
};

}  // namespace pliant::viewer
