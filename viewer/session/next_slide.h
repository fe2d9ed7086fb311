// The slide that comes next, played beside the lab for a small picture of it on the lecturer's page. It draws nothing.
#pragma once
#include <pliant/lecture/lecture.h>
#include <pliant/math/background.h>
#include <pliant/math/watch.h>

#include "render/camera.h"
#include "render/palette.h"
#include "render/picture.h"

#include <cstddef>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace pliant::viewer {

class Session;

inline constexpr float preview_aspect = 1.6f;  // width over height

// The slide as it comes up, its answer hidden.
struct SlidePreview {
    KeptPicture picture{};  // null where it shows words alone; another number for each slide
    int dimension = 3;
    Camera camera{};  // for preview_aspect
    ColourScale scale{};
    bool operator==(const SlidePreview&) const = default;
};

class NextSlide {
public:
    NextSlide() = default;
    NextSlide(const NextSlide&) = delete;
    NextSlide& operator=(const NextSlide&) = delete;
    // What is being played is called off and waited for.
    ~NextSlide() { cancel(); }

    // To be called while the lab rests: begins with the slide after that of the session, once for each, and takes up what is
    // done. Another slide calls off what is under way.
    void follow(const Session& session);
    void make_now(const Session& session);  // in this thread, once for each slide
    const SlidePreview& preview() const { return preview_; }
    bool busy() const { return under_way_ != nullptr; }

private:
    // A slide of a lecture, or of the walkthrough of a lesson.
    struct Wanted {
        std::string lesson, lecture;  // id; path
        std::size_t number = 0;
        bool operator==(const Wanted&) const = default;
    };
    struct Job {
        explicit Job(Wanted wanted) : slide(std::move(wanted)) {}
        Wanted slide;
        std::optional<Lecture> lecture{};
        Watch watch{};
        std::optional<Background<SlidePreview>> work{};  // last: it is waited for before the others go
    };
    static std::optional<Wanted> wanted_by(const Session& session);
    static SlidePreview played(const Job& job);
    // The job for the slide that is wanted, where it is another one than the last; null where it is not.
    std::unique_ptr<Job> next_job(const Session& session);
    void take(SlidePreview preview);
    void cancel();

    SlidePreview preview_;
    std::optional<Wanted> of_;  // that was begun last
    long pictures_ = 0;
    std::unique_ptr<Job> under_way_;
    std::list<std::unique_ptr<Job>> cancelled_;  // until their threads are done
};

}  // namespace pliant::viewer
