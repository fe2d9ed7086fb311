// A scene that is kept and drawn again as it is: each has a number of its own, so that who draws it knows it again.
#pragma once
#include <pliant/lesson/scene.h>

#include <memory>
#include <utility>

namespace pliant::viewer {

struct Picture {
    Picture(Scene s, long n) : scene(std::move(s)), number(n) {}
    Scene scene;
    long number;
};
using KeptPicture = std::shared_ptr<const Picture>;

}  // namespace pliant::viewer
