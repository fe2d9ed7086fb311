// What a scene takes from a lesson to colour it by.
#include <pliant/lesson/lesson.h>
#include <pliant/lesson/scene.h>
#include <catch2/catch_test_macros.hpp>

using namespace pliant;

namespace {

// Its field is computed whenever it is looked at.
class Looked final : public Lesson {
public:
    mutable int looks = 0;
    explicit Looked(Index rows) : numbers_(VecX::LinSpaced(2 * rows, 0, static_cast<Real>(2 * rows - 1))) {
        fields = {{.name = "pairs", .on = On::node, .rank = Rank::vector, .components = 2, .view = [this] {
                       return ++looks, view_of(numbers_)();
                   }}};
    }
    int dimension() const override { return 2; }
    void reset() override {}
    Real time_step() const override { return 1; }
    void draw(Scene&) const override {}

private:
    VecX numbers_;
};

}  // namespace

TEST_CASE("scene: a field is looked at once for a picture, however many rows it has") {
    for (const Index rows : {1, 1000}) {
        const Looked lesson(rows);
        Scene scene;
        scene.colour_by = {"pairs", 1};
        const auto values = scene.values(lesson, On::node);
        REQUIRE(values.size() == static_cast<std::size_t>(rows));
        CHECK(values.back() == static_cast<float>(2 * rows - 1));
        CHECK(lesson.looks == 1);
        CHECK(scene.values(lesson, On::cell).empty());
        CHECK(lesson.looks == 1);
        // Numbers of another moment that fit take their place.
        scene.override_values = std::vector<Real>(static_cast<std::size_t>(rows), 7);
        CHECK(scene.values(lesson, On::node).front() == 7);
        scene.override_values->push_back(7);
        CHECK(scene.values(lesson, On::node).back() == static_cast<float>(2 * rows - 1));
    }
}
