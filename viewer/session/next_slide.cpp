#include "session/next_slide.h"

#include "session/session.h"

#include <stop_token>

namespace pliant::viewer {

std::optional<NextSlide::Wanted> NextSlide::wanted_by(const Session& session) {
    if (!session.walkthrough || session.extension() || !session.slide_after()) return std::nullopt;
    const Lecture* lecture = session.lecture();
    const std::size_t next = session.slide_number() + 1;
    if (lecture) return Wanted{lecture->slides[next].lesson(), lecture->path, next};
    return Wanted{std::string(session.entry().info.id), "", next};
}

// As the lab opens it, in a session of its own.
SlidePreview NextSlide::played(const Job& job) {
    Session session(job.slide.lesson);
    if (job.lecture) {
        session.open_lecture(*job.lecture, job.slide.number);
    } else {
        session.start_walkthrough();
        session.go_to_slide(job.slide.number);
    }
    const int dimension = session.lesson().dimension();
    session.see_in(preview_aspect);
    session.viewpoint.look({.frame = frame_of(session.scene(), dimension), .moving = {}, .aspect = preview_aspect});
    return {session.picture(), dimension, session.seen_by(), session.colour_scale()};
}

std::unique_ptr<NextSlide::Job> NextSlide::next_job(const Session& session) {
    const auto wanted = wanted_by(session);
    if (wanted == of_) return nullptr;
    cancel();
    preview_ = {};
    of_ = wanted;
    if (!wanted || wanted->lesson.empty()) return nullptr;
    auto job = std::make_unique<Job>(*wanted);
    if (const Lecture* lecture = session.lecture()) job->lecture = *lecture;
    return job;
}

void NextSlide::follow(const Session& session) {
    std::erase_if(cancelled_, [](const auto& job) { return job->work->done(); });
    if (auto job = next_job(session)) {
        job->work.emplace([&j = *job](const std::stop_token& stop) {
            const Watched watched(j.watch);
            const std::stop_callback on_stop(stop, [&j] { j.watch.cancel(); });
            return played(j);
        });
        under_way_ = std::move(job);
    }
    if (!under_way_ || !under_way_->work->done()) return;
    const auto job = std::move(under_way_);
    try {
        take(job->work->take());
    } catch (const std::exception&) {
        // A slide that cannot be shown tells so when it comes up.
    }
}

void NextSlide::make_now(const Session& session) {
    if (const auto job = next_job(session)) take(played(*job));
}

// Each session counts its pictures from 1: the renderer has to tell those of two slides apart.
void NextSlide::take(SlidePreview preview) {
    if (preview.picture) preview.picture = std::make_shared<const Picture>(preview.picture->scene, ++pictures_);
    preview_ = std::move(preview);
}

void NextSlide::cancel() {
    if (!under_way_) return;
    under_way_->work->ask_to_stop();
    cancelled_.push_back(std::move(under_way_));
}

}  // namespace pliant::viewer
