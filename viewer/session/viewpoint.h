// Where the picture is seen from, as long as nobody chooses: framed for the scene, turned as the person turned it, and going
// along when what moves would leave it.
#pragma once
#include "render/framing.h"

namespace pliant::viewer {

// What is to be seen, and how.
struct Sighting {
    Frame frame;
    std::span<const Position> moving;
    float aspect = 1;   // of the part of the picture that is free
    int run = 0;        // which one, by a count: another run is framed at once
    Real seconds = 0;   // since the last look; with 0 the camera is at once where it belongs
    bool held = false;  // the person holds something: nothing slips from under the pointer
};

class Viewpoint {
public:
    // Of this moment.
    const Camera& look(const Sighting& sighting);
    // Of the last look.
    const Camera& camera() const { return camera_; }
    const Frame& frame() const { return shown_.frame; }
    // Whether it is on its way to where it belongs, so that another picture has to follow.
    bool moving() const { return moving_; }

    // The person looks from another side, px.
    void turn(float dx, float dy);
    bool turned() const { return turned_; }
    void turn_to(Real yaw, Real pitch);  // rad
    void turn_back() { turned_ = false; }

private:
    Camera belonging(const Sighting& sighting) const;

    struct Shown {
        Frame frame;
        float aspect = 0;
        int run = -1;
        bool operator==(const Shown&) const = default;
    };

    Camera camera_;
    Shown shown_;
    bool turned_ = false, moving_ = false;
};

}  // namespace pliant::viewer
