// The shader programs of the scene, in GLSL that OpenGL 3.3 and OpenGL ES 3.0 share; the version line is added when they are
// compiled. Marks are expanded from their end points in pixels, so that lines and discs have smooth edges without multisampling.
#pragma once

namespace pliant::viewer::shaders {

inline constexpr const char* line_vertex = R"(
layout(location = 0) in vec2 corner;   // x: 0 at a, 1 at b; y: -1 or 1 across
layout(location = 1) in vec3 a;
layout(location = 2) in vec3 b;
layout(location = 3) in vec4 colour;
uniform mat4 matrix;
uniform vec2 viewport;                 // px
uniform float width;                   // px
uniform float shorten;                 // px taken off at b, for an arrow's head
out vec4 ink;
out vec2 along_across;                 // px
void main() {
    vec4 ca = matrix * vec4(a, 1.0), cb = matrix * vec4(b, 1.0);
    vec2 pa = ca.xy / ca.w * 0.5 * viewport, pb = cb.xy / cb.w * 0.5 * viewport;
    vec2 d = pb - pa;
    float len = length(d);
    vec2 dir = len > 0.0 ? d / len : vec2(1.0, 0.0);
    float cut = min(shorten, 0.6 * len);
    float half_width = 0.5 * width + 1.0;
    float end_cap = shorten > 0.0 ? 0.0 : 0.5 * width;
    vec2 p = mix(pa - dir * end_cap, pb - dir * (cut - end_cap), corner.x) + vec2(-dir.y, dir.x) * corner.y * half_width;
    vec4 c = mix(ca, cb, corner.x);
    gl_Position = vec4(p / (0.5 * viewport) * c.w, c.z - 0.0004 * c.w, c.w);
    along_across = vec2(corner.x * len, corner.y * half_width);
    ink = colour;
}
)";
inline constexpr const char* line_fragment = R"(
in vec4 ink;
in vec2 along_across;
uniform float width;
uniform float dash;                    // px; 0 for a full line
out vec4 colour;
void main() {
    float cover = clamp(0.5 * width + 0.5 - abs(along_across.y), 0.0, 1.0);
    if (dash > 0.0 && mod(along_across.x, 2.0 * dash) > dash) discard;
    if (cover <= 0.0) discard;
    colour = vec4(ink.rgb, ink.a * cover);
}
)";

inline constexpr const char* head_vertex = R"(
layout(location = 0) in vec2 corner;   // (0, 0) the tip, (1, ±1) the base
layout(location = 1) in vec3 a;
layout(location = 2) in vec3 b;
layout(location = 3) in vec4 colour;
uniform mat4 matrix;
uniform vec2 viewport;
uniform float width;
out vec4 ink;
void main() {
    vec4 ca = matrix * vec4(a, 1.0), cb = matrix * vec4(b, 1.0);
    vec2 pa = ca.xy / ca.w * 0.5 * viewport, pb = cb.xy / cb.w * 0.5 * viewport;
    vec2 d = pb - pa;
    float len = length(d);
    vec2 dir = len > 0.0 ? d / len : vec2(1.0, 0.0);
    float head = min(5.0 * width, 0.75 * len);
    vec2 p = pb - dir * head * corner.x + vec2(-dir.y, dir.x) * corner.y * 0.42 * head;
    gl_Position = vec4(p / (0.5 * viewport) * cb.w, cb.z - 0.0006 * cb.w, cb.w);
    ink = len > 0.5 ? colour : vec4(0.0);
}
)";
inline constexpr const char* plain_fragment = R"(
in vec4 ink;
out vec4 colour;
void main() {
    if (ink.a <= 0.0) discard;
    colour = ink;
}
)";

inline constexpr const char* point_vertex = R"(
layout(location = 0) in vec2 corner;   // -1 or 1 each way
layout(location = 1) in vec3 a;
layout(location = 3) in vec4 colour;
uniform mat4 matrix;
uniform vec2 viewport;
uniform float width;                   // radius, px
out vec4 ink;
out vec2 offset;                       // px
void main() {
    vec4 c = matrix * vec4(a, 1.0);
    offset = corner * (width + 1.0);
    gl_Position = vec4(c.xy + offset / (0.5 * viewport) * c.w, c.z - 0.0008 * c.w, c.w);
    ink = colour;
}
)";
inline constexpr const char* point_fragment = R"(
in vec4 ink;
in vec2 offset;
uniform float width;
uniform float shade;                   // 1: as a ball, 0: as a disc
out vec4 colour;
void main() {
    float r = length(offset);
    float cover = clamp(width + 0.5 - r, 0.0, 1.0);
    if (cover <= 0.0) discard;
    float z = sqrt(max(0.0, 1.0 - r * r / (width * width)));
    float light = mix(1.0, 0.55 + 0.45 * clamp(dot(vec3(offset / width, z), vec3(-0.35, 0.5, 0.79)), 0.0, 1.0), shade);
    colour = vec4(ink.rgb * light, ink.a * cover);
}
)";

inline constexpr const char* triangle_vertex = R"(
layout(location = 0) in vec3 a;
layout(location = 1) in vec4 colour;
uniform mat4 matrix;
uniform mat4 view;
out vec4 ink;
out vec3 eye;
void main() {
    gl_Position = matrix * vec4(a, 1.0);
    eye = (view * vec4(a, 1.0)).xyz;
    ink = colour;
}
)";
inline constexpr const char* triangle_fragment = R"(
in vec4 ink;
in vec3 eye;
uniform float shade;
out vec4 colour;
void main() {
    vec3 normal = normalize(cross(dFdx(eye), dFdy(eye)));
    float light = mix(1.0, 0.42 + 0.58 * abs(dot(normal, normalize(vec3(0.25, 0.45, 0.86)))), shade);
    colour = vec4(ink.rgb * light, ink.a);
}
)";

inline constexpr const char* grid_vertex = R"(
layout(location = 0) in vec3 a;
layout(location = 1) in vec2 texel;    // in cells
uniform mat4 matrix;
out vec2 at;
void main() {
    gl_Position = matrix * vec4(a, 1.0);
    at = texel;
}
)";
inline constexpr const char* grid_fragment = R"(
in vec2 at;
uniform highp sampler2D numbers;       // one value per cell
uniform sampler2D table;               // 256 colours
uniform vec2 range;
uniform float smooth_cells;
out vec4 colour;
float cell(ivec2 i) {
    return texelFetch(numbers, clamp(i, ivec2(0), textureSize(numbers, 0) - 1), 0).r;
}
void main() {
    vec2 p = at - 0.5;
    ivec2 i = ivec2(floor(p));
    vec2 f = p - vec2(i);
    float v = smooth_cells > 0.5 ? mix(mix(cell(i), cell(i + ivec2(1, 0)), f.x), mix(cell(i + ivec2(0, 1)), cell(i + ivec2(1, 1)), f.x), f.y)
                                 : cell(ivec2(floor(at)));
    float t = clamp((v - range.x) / max(range.y - range.x, 1e-30), 0.0, 1.0);
    colour = vec4(texture(table, vec2((t * 255.0 + 0.5) / 256.0, 0.5)).rgb, 1.0);
}
)";

}  // namespace pliant::viewer::shaders
