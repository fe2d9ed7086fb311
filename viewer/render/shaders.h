// The shader programs of the scene, in GLSL that OpenGL 3.3 and OpenGL ES 3.0 share; the version line is added when they are
// compiled. Marks are expanded from their end points in pixels, so that lines and discs have smooth edges without multisampling.
#pragma once

namespace pliant::viewer::shaders {

// Added to the fragment shaders: a colour with the hatching of negative numbers over it, dark on light and light on dark.
#define PLIANT_HATCH                                                                                   \
    "vec3 hatched(vec3 rgb, float spacing) {\n"                                                        \
    "    float across = mod(gl_FragCoord.x + gl_FragCoord.y, spacing * 1.4);\n"                        \
    "    float line = 1.0 - smoothstep(0.18 * spacing, 0.3 * spacing, abs(across - 0.7 * spacing));\n" \
    "    vec3 ink = dot(rgb, vec3(0.3, 0.59, 0.11)) > 0.35 ? vec3(0.0) : vec3(1.0);\n"                 \
    "    return mix(rgb, ink, 0.6 * line);\n"                                                          \
    "}\n"

inline constexpr const char* line_vertex = R"(
layout(location = 0) in vec2 corner;   // x: 0 at a, 1 at b; y: -1 or 1 across
layout(location = 1) in vec3 a;
layout(location = 2) in vec3 b;
layout(location = 3) in vec4 colour;
layout(location = 4) in float value;
uniform mat4 matrix;
uniform vec2 viewport;                 // px
uniform float width;                   // px
uniform float shorten;                 // px taken off at b, for an arrow's head
out vec4 ink;
out vec2 along_across;                 // px
out float number;
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
    number = value;
    ink = colour;
}
)";
inline constexpr const char* line_fragment = R"(
in vec4 ink;
in vec2 along_across;
in float number;
uniform float width;
uniform float dash;                    // px; 0 for a full line
uniform float pattern;                 // px; dashes negative numbers, 0 for none
out vec4 colour;
void main() {
    float cover = clamp(0.5 * width + 0.5 - abs(along_across.y), 0.0, 1.0);
    if (pattern > 0.0 && number < 0.0 && mod(along_across.x, pattern) > 0.55 * pattern) discard;
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
layout(location = 4) in float value;
uniform mat4 matrix;
uniform vec2 viewport;
uniform float width;                   // radius, px
out float number;
out vec4 ink;
out vec2 offset;                       // px
void main() {
    vec4 c = matrix * vec4(a, 1.0);
    offset = corner * (width + 1.0);
    gl_Position = vec4(c.xy + offset / (0.5 * viewport) * c.w, c.z - 0.0008 * c.w, c.w);
    number = value;
    ink = colour;
}
)";
inline constexpr const char* point_fragment = R"(
in vec4 ink;
in vec2 offset;
in float number;
uniform float width;
uniform float shade;                   // 1: as a ball, 0: as a disc
uniform float pattern;                 // above 0: a negative number is a square with a bar, a minus
out vec4 colour;
void main() {
    bool negative = pattern > 0.0 && number < 0.0;
    float r = negative ? max(abs(offset.x), abs(offset.y)) * 1.1 : length(offset);
    float cover = clamp(width + 0.5 - r, 0.0, 1.0);
    if (cover <= 0.0) discard;
    float z = sqrt(max(0.0, 1.0 - r * r / (width * width)));
    float light = mix(1.0, 0.55 + 0.45 * clamp(dot(vec3(offset / width, z), vec3(-0.35, 0.5, 0.79)), 0.0, 1.0), shade);
    vec3 bar = dot(ink.rgb, vec3(0.3, 0.59, 0.11)) > 0.35 ? vec3(0.0) : vec3(1.0);
    bool on_bar = negative && abs(offset.y) < max(1.0, 0.2 * width) && abs(offset.x) < 0.7 * width;
    colour = vec4(on_bar ? bar : ink.rgb * light, ink.a * cover);
}
)";

inline constexpr const char* triangle_vertex = R"(
layout(location = 0) in vec3 a;
layout(location = 1) in vec4 colour;
layout(location = 2) in float value;
uniform mat4 matrix;
uniform mat4 view;
out float number;
out vec4 ink;
out vec3 eye;
void main() {
    gl_Position = matrix * vec4(a, 1.0);
    eye = (view * vec4(a, 1.0)).xyz;
    number = value;
    ink = colour;
}
)";
inline constexpr const char* triangle_fragment = PLIANT_HATCH R"(
in vec4 ink;
in vec3 eye;
in float number;
uniform float shade;
uniform float pattern;                 // px, of the hatching of negative numbers; 0 for none
out vec4 colour;
void main() {
    vec3 normal = normalize(cross(dFdx(eye), dFdy(eye)));
    float light = mix(1.0, 0.42 + 0.58 * abs(dot(normal, normalize(vec3(0.25, 0.45, 0.86)))), shade);
    vec3 rgb = ink.rgb * light;
    colour = vec4(pattern > 0.0 && number < 0.0 ? hatched(rgb, pattern) : rgb, ink.a);
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
inline constexpr const char* grid_fragment = PLIANT_HATCH R"(
in vec2 at;
uniform highp sampler2D numbers;       // one value per cell
uniform sampler2D table;               // 256 colours
uniform vec2 range;
uniform float smooth_cells;
uniform float pattern;                 // px, of the hatching of negative numbers; 0 for none
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
    if (pattern <= 0.0) return;
    // Lines between equal numbers, at the tenths of the range.
    float level = 10.0 * t, width = max(fwidth(level), 1e-6);
    float line = smooth_cells > 0.5 && t > 0.0 && t < 1.0 ? 1.0 - smoothstep(0.6, 1.4, abs(fract(level - 0.5) - 0.5) / width) : 0.0;
    if (v < 0.0) colour.rgb = hatched(colour.rgb, pattern);
    colour.rgb = mix(colour.rgb, dot(colour.rgb, vec3(0.3, 0.59, 0.11)) > 0.35 ? vec3(0.0) : vec3(1.0), 0.5 * line);
}
)";

}  // namespace pliant::viewer::shaders
