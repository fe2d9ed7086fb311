// What holds for the picture of any lesson.
#include "../every_lesson.h"
#include "picture.h"

#include <pliant/math/error.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>

using namespace pliant;
using namespace pliant::test;

namespace {

constexpr Index few_steps = 5;

std::string bytes_of(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string file_bytes(const Shot& shot) {
    const PictureFile file;
    take(shot, file.path());
    return bytes_of(file.path());
}

// A picture has things in it: many colours, in the scene's part as well as beside it, and no single one almost everywhere.
void check_not_empty(const Image& image) {
    CHECK(distinct_colours(image) > 200);
    const Image middle = viewer::crop(image, image.width / 4, image.height / 4, image.width / 3, image.height / 2);
    CHECK(distinct_colours(middle) > 50);
}

void check_pictures(const std::string& size, float ui_scale, const std::string& layout, const std::vector<const char*>& themes) {
    for (const LessonEntry& entry : every_lesson())
        for (const char* theme : themes) {
            CAPTURE(entry.info.id, theme, size, layout);
            Shot shot{std::string(entry.info.id), {}, few_steps, {}};
            shot.picture.size = size, shot.picture.layout = layout, shot.picture.theme = theme, shot.picture.ui_scale = ui_scale;
            check_not_empty(picture_of(shot));
        }
}

}  // namespace

TEST_CASE("two pictures of one scene are the same file", "[shots][every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        CAPTURE(entry.info.id);
        const Shot shot{std::string(entry.info.id), {}, few_steps, {}};
        CHECK(file_bytes(shot) == file_bytes(shot));
    }
}

TEST_CASE("OSMesa and EGL draw the same picture", "[shots][every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        CAPTURE(entry.info.id);
        Shot osmesa{std::string(entry.info.id), {}, few_steps, {}}, egl = osmesa;
        osmesa.picture.backend = "osmesa";
        egl.picture.backend = "egl";
        try {
            const auto difference = viewer::compare(picture_of(osmesa), picture_of(egl));
            CAPTURE(difference.largest, difference.fraction_over);
            CHECK(difference.largest == 0);
        } catch (const MachineLacks& lack) {
            SKIP(lack.what());
        }
    }
}

TEST_CASE("no lesson's picture is empty: slides", "[shots][every_lesson]") {
    check_pictures("1280x720", 1, "slide", {"dark", "projector"});
}
TEST_CASE("no lesson's picture is empty: the lab", "[shots][slow][every_lesson]") {
    check_pictures("1280x720", 1, "lab", {"dark", "projector"});
}
TEST_CASE("no lesson's picture is empty: slides for a projector", "[shots][slow][every_lesson]") {
    check_pictures("1920x1080", 1.5f, "slide", {"projector"});
}
TEST_CASE("no lesson's picture is empty: the lab for a projector", "[shots][slow][every_lesson]") {
    check_pictures("1920x1080", 1.5f, "lab", {"projector"});
}

TEST_CASE("a tour without names goes through every lesson", "[shots]") {
    const auto all = viewer::lessons_of_tour({});
    CHECK(std::ranges::equal(all, lessons(), {}, {}, [](const LessonEntry& e) { return &e; }));
    CHECK(viewer::lessons_of_tour({"moduli", "rod"}) == std::vector{&find_lesson("elasticity/moduli"), &find_lesson("mesh/rod")});
    CHECK_THROWS_AS(viewer::lessons_of_tour({"rodd"}), Refused);
}

TEST_CASE("a second run stands beside the first, and their difference in its place", "[shots]") {
    Shot shot{"fluids/navier_stokes", {"resolution=24"}, few_steps, {}};
    shot.picture.size = "640x360";
    const Image alone = picture_of(shot);
    shot.picture.beside = {"viscosity=0.05"};
    const Image two = picture_of(shot);
    shot.picture.difference = true;
    const Image difference = picture_of(shot);
    for (const Image& image : {two, difference}) check_not_empty(image);
    CHECK(viewer::compare(alone, two, 24).fraction_over > 0.02);
    CHECK(viewer::compare(two, difference, 24).fraction_over > 0.02);
    CHECK(viewer::compare(alone, difference, 24).fraction_over > 0.02);

    const auto refused = [](Shot s) { CHECK_THROWS_AS(picture_of(s), Refused); };
    Shot other = shot;
    other.picture.beside = {"resolution=16"};
    refused(other);  // of another size
    other.picture.beside = {};
    refused(other);  // a difference of one run
    other.picture.beside = {"viscosity"};
    refused(other);
    other.picture.beside = {"viscosity=-1"};
    refused(other);
    other = shot;
    other.picture.layout = "deck";
    refused(other);
}

TEST_CASE("the measure of emptiness tells an empty picture", "[shots]") {
    const Image blank{640, 360, std::vector<std::uint8_t>(640 * 360 * 3, 20)};
    CHECK(distinct_colours(blank) == 1);
}

TEST_CASE("theme, layout and field each change the picture", "[shots]") {
    Shot shot{"elasticity/moduli", {"resolution=2"}, {}, {}};
    shot.picture.size = "640x360";
    shot.picture.field = "stress";
    const Image plain = picture_of(shot);
    const auto differs = [&](auto change) {
        Shot other = shot;
        change(other.picture);
        return viewer::compare(plain, picture_of(other), 24).fraction_over > 0.005;
    };
    CHECK(differs([](PictureOptions& o) { o.theme = "projector"; }));
    CHECK(differs([](PictureOptions& o) { o.layout = "lab"; }));
    CHECK(differs([](PictureOptions& o) { o.component = 4; }));
    CHECK(differs([](PictureOptions& o) { o.field = "displacement"; }));
    CHECK(differs([](PictureOptions& o) { o.ui_scale = 1.5f; }));
}
