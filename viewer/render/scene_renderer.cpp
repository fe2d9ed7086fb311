#include "render/scene_renderer.h"

#include "render/shaders.h"

#include <algorithm>
#include <array>

namespace pliant::viewer {
namespace {

constexpr std::array<float, 8> line_corners{0, -1, 1, -1, 0, 1, 1, 1};
constexpr std::array<float, 8> square_corners{-1, -1, 1, -1, -1, 1, 1, 1};
constexpr std::array<float, 6> head_corners{0, 0, 1, -1, 1, 1};

void attribute(GLuint index, GLint count, GLenum type, GLsizei stride, std::size_t offset, GLuint divisor) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, count, type, type == GL_UNSIGNED_BYTE ? GL_TRUE : GL_FALSE, stride,
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(index, divisor);
}

template <class Item>
void upload(GLuint buffer, const std::vector<Item>& items) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(items.size() * sizeof(Item)), items.data(), GL_STREAM_DRAW);
}

// Of a mark; 0, which has no sign, where it shows no number.
float value_at(const std::vector<float>& values, std::size_t i) { return values.empty() ? 0 : values[i]; }

ColourTable one_colour(Rgba8 colour) {
    ColourTable table;
    table.fill(colour);
    return table;
}

// Of hatching and dashes, px at scale 1.
constexpr float pattern_size = 7;

void set(GLuint program, const char* name, float value) { glUniform1f(glGetUniformLocation(program, name), value); }

void texture_filter(GLenum filter) {
    for (const GLenum what : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, what, static_cast<GLint>(filter));
    for (const GLenum what : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) glTexParameteri(GL_TEXTURE_2D, what, GL_CLAMP_TO_EDGE);
}

}  // namespace

SceneRenderer::SceneRenderer()
    : triangle_program_(make_program(shaders::triangle_vertex, shaders::triangle_fragment)),
      grid_program_(make_program(shaders::grid_vertex, shaders::grid_fragment)),
      triangle_array_(make_vertex_array()),
      grid_array_(make_vertex_array()),
      instances_(make_buffer()),
      corners_(make_buffer()),
      grid_corners_(make_buffer()),
      numbers_(make_texture()),
      table_(make_texture()) {
    lines_ = mark_program(shaders::line_vertex, shaders::line_fragment, line_corners);
    heads_ = mark_program(shaders::head_vertex, shaders::plain_fragment, head_corners);
    points_ = mark_program(shaders::point_vertex, shaders::point_fragment, square_corners);

    glBindVertexArray(triangle_array_);
    glBindBuffer(GL_ARRAY_BUFFER, corners_);
    attribute(0, 3, GL_FLOAT, sizeof(Corner), offsetof(Corner, at), 0);
    attribute(1, 4, GL_UNSIGNED_BYTE, sizeof(Corner), offsetof(Corner, colour), 0);
    attribute(2, 1, GL_FLOAT, sizeof(Corner), offsetof(Corner, value), 0);
    glBindVertexArray(grid_array_);
    glBindBuffer(GL_ARRAY_BUFFER, grid_corners_);
    attribute(0, 3, GL_FLOAT, 5 * sizeof(float), 0, 0);
    attribute(1, 2, GL_FLOAT, 5 * sizeof(float), 3 * sizeof(float), 0);
    glBindVertexArray(0);
}

SceneRenderer::MarkProgram SceneRenderer::mark_program(const char* vertex, const char* fragment, std::span<const float> corners) {
    MarkProgram m{make_program(vertex, fragment), make_vertex_array(), make_buffer(), static_cast<int>(corners.size()) / 2};
    glBindVertexArray(m.array);
    glBindBuffer(GL_ARRAY_BUFFER, m.corners);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size_bytes()), corners.data(), GL_STATIC_DRAW);
    attribute(0, 2, GL_FLOAT, 2 * sizeof(float), 0, 0);
    glBindBuffer(GL_ARRAY_BUFFER, instances_);
    attribute(1, 3, GL_FLOAT, sizeof(Segment), offsetof(Segment, a), 1);
    attribute(2, 3, GL_FLOAT, sizeof(Segment), offsetof(Segment, b), 1);
    attribute(3, 4, GL_UNSIGNED_BYTE, sizeof(Segment), offsetof(Segment, colour), 1);
    attribute(4, 1, GL_FLOAT, sizeof(Segment), offsetof(Segment, value), 1);
    glBindVertexArray(0);
    return m;
}

void SceneRenderer::ensure_target(Size size) {
    if (size == size_) return;
    size_ = size;
    colour_ = make_texture();
    glBindTexture(GL_TEXTURE_2D, colour_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    texture_filter(GL_NEAREST);
    GLuint depth = 0, framebuffer = 0;
    glGenRenderbuffers(1, &depth);
    depth_ = GlRenderbuffer(depth);
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size.width, size.height);
    glGenFramebuffers(1, &framebuffer);
    framebuffer_ = GlFramebuffer(framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
}

GLuint SceneRenderer::render(const Picture& picture, int dimension, const Camera& camera, const Palette& colours,
                             const ColourScale& scale, Size size, float pixel_scale, float right_margin, bool patterns) {
    const Seen seen{picture.number, camera, &colours, scale, size, pixel_scale, right_margin, patterns};
    if (seen_ == seen) return colour_;
    seen_ = seen;
    const Scene& scene = picture.scene;
    const Projection projection(camera, dimension, static_cast<float>(size.width), static_cast<float>(size.height), right_margin);
    matrix_ = projection.matrix(), view_ = projection.view();
    lit_ = dimension == 3, pixel_scale_ = pixel_scale, palette_ = &colours, scale_ = scale;
    awaited_ = scene.awaits(scene.colour_by.field) && !scene.override_values, patterns_ = patterns && !awaited_;

    ensure_target(size);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, size.width, size.height);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_TRUE);
    const Rgba8 b = colours.background;
    glClearColor(b.r / 255.f, b.g / 255.f, b.b / 255.f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    // A flat picture is painted in order; in space the nearer covers the farther.
    lit_ ? glEnable(GL_DEPTH_TEST) : glDisable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);

    for (const GridMarks& g : scene.grids) draw_grid(g);
    for (const TriangleMarks& t : scene.triangles)
        if (t.opacity >= 1) draw_triangles(t);
    for (const LineMarks& l : scene.lines) draw_lines(l);
    for (const PointMarks& p : scene.points) draw_points(p);
    glDepthMask(GL_FALSE);
    for (const TriangleMarks& t : scene.triangles)
        if (t.opacity < 1) draw_triangles(t);
    if (scene.show_arrows) {
        glDisable(GL_DEPTH_TEST);
        for (const ArrowMarks& a : scene.arrows) draw_arrows(a);
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return colour_;
}

Rgba8 SceneRenderer::colour_of(const std::vector<float>& values, std::size_t i, Ink ink, float opacity) const {
    Rgba8 c = values.empty() ? palette_->of(ink) : awaited_ ? undefined_colour : scale_.of(values[i]);
    c.a = static_cast<std::uint8_t>(255 * std::clamp(opacity, 0.f, 1.f));
    return c;
}

void SceneRenderer::common_uniforms(GLuint program) const {
    glUseProgram(program);
    glUniformMatrix4fv(glGetUniformLocation(program, "matrix"), 1, GL_FALSE, matrix_.data());
    glUniform2f(glGetUniformLocation(program, "viewport"), static_cast<float>(size_.width), static_cast<float>(size_.height));
    set(program, "pattern", patterns_ ? pattern_size * pixel_scale_ : 0);
}

void SceneRenderer::draw_segments(const MarkProgram& mark, float width, float dash, float shorten) {
    if (segments_.empty()) return;
    upload(instances_, segments_);
    common_uniforms(mark.program);
    set(mark.program, "width", width);
    set(mark.program, "dash", dash);
    set(mark.program, "shorten", shorten);
    set(mark.program, "shade", lit_ ? 1.f : 0.f);
    glBindVertexArray(mark.array);
    glDrawArraysInstanced(mark.vertices == 3 ? GL_TRIANGLES : GL_TRIANGLE_STRIP, 0, mark.vertices,
                          static_cast<GLsizei>(segments_.size()));
}

void SceneRenderer::draw_lines(const LineMarks& marks) {
    segments_.clear();
    for (std::size_t i = 0; i + 1 < marks.ends.size(); i += 2)
        segments_.push_back(
            {marks.ends[i], marks.ends[i + 1], colour_of(marks.values, i / 2, marks.ink), value_at(marks.values, i / 2)});
    draw_segments(lines_, marks.width * pixel_scale_, marks.dashed ? 6 * pixel_scale_ : 0);
}

void SceneRenderer::draw_arrows(const ArrowMarks& marks) {
    segments_.clear();
    for (std::size_t i = 0; i < marks.from.size(); ++i)
        segments_.push_back({marks.from[i], marks.to[i], colour_of(marks.values, i, marks.ink)});
    const float width = marks.width * pixel_scale_;
    draw_segments(lines_, width, 0, 4 * width);
    draw_segments(heads_, width);
}

void SceneRenderer::draw_points(const PointMarks& marks) {
    segments_.clear();
    for (std::size_t i = 0; i < marks.at.size(); ++i)
        segments_.push_back({marks.at[i], marks.at[i], colour_of(marks.values, i, marks.ink), value_at(marks.values, i)});
    draw_segments(points_, marks.radius * pixel_scale_);
}

void SceneRenderer::draw_triangles(const TriangleMarks& marks) {
    corners_data_.clear();
    const bool per_triangle = marks.values.size() == marks.triangles.size() && marks.values.size() != marks.corners.size();
    for (std::size_t t = 0; t < marks.triangles.size(); ++t)
        for (const int corner : marks.triangles[t]) {
            const auto c = static_cast<std::size_t>(corner);
            const std::size_t v = per_triangle ? t : c;
            corners_data_.push_back(
                {marks.corners[c], colour_of(marks.values, v, marks.ink, marks.opacity), value_at(marks.values, v)});
        }
    upload(corners_, corners_data_);
    common_uniforms(triangle_program_);
    glUniformMatrix4fv(glGetUniformLocation(triangle_program_, "view"), 1, GL_FALSE, view_.data());
    set(triangle_program_, "shade", lit_ ? 1.f : 0.f);
    glBindVertexArray(triangle_array_);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_data_.size()));
    if (!marks.edges) return;
    segments_.clear();
    for (const auto& t : marks.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto a = static_cast<std::size_t>(t[k]), b = static_cast<std::size_t>(t[(k + 1) % 3]);
            segments_.push_back({marks.corners[a], marks.corners[b], palette_->of(Ink::edge)});
        }
    draw_segments(lines_, pixel_scale_);
}

void SceneRenderer::draw_grid(const GridMarks& g) {
    if (g.values.empty()) return;
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, numbers_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, g.nx, g.ny, 0, GL_RED, GL_FLOAT, g.values.data());
    texture_filter(GL_NEAREST);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, table_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 256, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 awaited_ ? one_colour(undefined_colour).data() : colour_table(scale_.map).data());
    texture_filter(GL_LINEAR);

    const float nx = static_cast<float>(g.nx), ny = static_cast<float>(g.ny), z = g.lower[2];
    const std::vector<float> quad{g.lower[0], g.lower[1], z, 0, 0,  g.upper[0], g.lower[1], z, nx, 0,
                                  g.lower[0], g.upper[1], z, 0, ny, g.upper[0], g.upper[1], z, nx, ny};
    upload(grid_corners_, quad);
    common_uniforms(grid_program_);
    glUniform1i(glGetUniformLocation(grid_program_, "numbers"), 0);
    glUniform1i(glGetUniformLocation(grid_program_, "table"), 1);
    const auto [least, greatest] = scale_.wide();
    glUniform2f(glGetUniformLocation(grid_program_, "range"), static_cast<float>(least), static_cast<float>(greatest));
    set(grid_program_, "smooth_cells", g.smooth ? 1.f : 0.f);
    glBindVertexArray(grid_array_);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace pliant::viewer
