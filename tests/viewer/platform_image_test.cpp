// Pictures in memory and as files.
#include <pliant/math/error.h>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "platform/image.h"
#include "platform/png_file.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace pliant;
using namespace pliant::viewer;
using Catch::Matchers::ContainsSubstring;
namespace fs = std::filesystem;

namespace {

// A folder of its own that goes away with the test.
struct Folder {
    fs::path path;
    Folder() : path(fs::temp_directory_path() / ("pliant_image_test_" + std::to_string(getpid()))) {
        fs::remove_all(path);
        fs::create_directories(path);
    }
    ~Folder() { fs::remove_all(path); }
    std::size_t files() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), fs::directory_iterator()));
    }
};

Image gradient(int width, int height) {
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (const int value : {x, y, x * y}) image.rgb.push_back(static_cast<std::uint8_t>(value % 256));
        }
    }
    return image;
}

std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("A picture comes back from its file as it was, and the file is the same every time") {
    const Folder folder;
    const Image image = gradient(37, 21);
    write_png(image, folder.path / "a.png");
    write_png(image, folder.path / "b.png");
    CHECK(read_png(folder.path / "a.png") == image);
    CHECK(bytes_of(folder.path / "a.png") == bytes_of(folder.path / "b.png"));
    CHECK(folder.files() == 2);
}

TEST_CASE("An older picture is replaced, a link stays a link") {
    const Folder folder;
    write_png(gradient(5, 5), folder.path / "a.png");
    fs::create_symlink(folder.path / "a.png", folder.path / "link.png");
    write_png(gradient(8, 3), folder.path / "link.png");
    CHECK(fs::is_symlink(folder.path / "link.png"));
    CHECK(read_png(folder.path / "a.png") == gradient(8, 3));
    CHECK(folder.files() == 2);
}

TEST_CASE("A path that cannot be written is refused by name and leaves nothing behind") {
    const Folder folder;
    const Image image = gradient(4, 4);
    const auto path = folder.path / "absent" / "a.png";
    CHECK_THROWS_AS(write_png(image, path), Refused);
    CHECK_THROWS_WITH(write_png(image, path), ContainsSubstring(path.string()));
    CHECK_THROWS_WITH(write_png(image, folder.path), ContainsSubstring("folder"));
    CHECK_THROWS_AS(write_png(Image{}, folder.path / "empty.png"), Refused);
    CHECK(folder.files() == 0);
}

TEST_CASE("A full disk is refused, and a device is written to, not replaced") {
    if (!fs::is_character_file("/dev/full")) SKIP("this system has no /dev/full");
    CHECK_THROWS_AS(write_png(gradient(64, 64), "/dev/full"), Refused);
    CHECK(fs::is_character_file("/dev/full"));
    write_png(gradient(4, 4), "/dev/null");
    CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("What is no picture, or only half of one, is refused by name") {
    const Folder folder;
    CHECK_THROWS_WITH(read_png(folder.path / "absent.png"), ContainsSubstring("absent.png"));
    std::ofstream(folder.path / "text.png") << "this is no picture";
    CHECK_THROWS_WITH(read_png(folder.path / "text.png"), ContainsSubstring("text.png"));
    write_png(gradient(64, 64), folder.path / "whole.png");
    const std::string bytes = bytes_of(folder.path / "whole.png");
    for (const std::size_t size : {std::size_t{0}, std::size_t{7}, std::size_t{40}, bytes.size() / 2}) {
        std::ofstream(folder.path / "half.png", std::ios::binary) << bytes.substr(0, size);
        CHECK_THROWS_AS(read_png(folder.path / "half.png"), Refused);
    }
}

TEST_CASE("Differences of two pictures are measured") {
    const Image a = gradient(10, 10);
    Image b = a;
    CHECK(compare(a, b).largest == 0);
    CHECK(compare(a, b).fraction_over == 0);
    b.rgb[0] = 9;        // the first pixel by 9
    b.rgb[3 * 42] ^= 1;  // another one by 1
    CHECK(compare(a, b).largest == 9);
    CHECK(compare(a, b).fraction_over == Catch::Approx(0.02));
    CHECK(compare(a, b, 1).fraction_over == Catch::Approx(0.01));
    CHECK(compare(a, b, 9).fraction_over == 0);
    CHECK_THROWS_AS(compare(a, gradient(10, 11)), Refused);
    CHECK(compare(Image{}, Image{}).fraction_over == 0);
}

TEST_CASE("A part of a picture is cut out, and never more than there is") {
    const Image image = gradient(10, 8);
    const Image part = crop(image, 2, 3, 4, 2);
    REQUIRE((part.width == 4 && part.height == 2));
    CHECK(std::ranges::equal(part.row(0), image.row(3).subspan(6, 12)));
    const Image corner = crop(image, -5, 6, 8, 100);
    CHECK((corner.width == 3 && corner.height == 2));
    CHECK(crop(image, 50, 50, 4, 4).rgb.empty());
}
