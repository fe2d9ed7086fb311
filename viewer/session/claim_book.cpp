#include "session/claim_book.h"

#include <pliant/math/error.h>

#include "session/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace pliant::viewer {
const ClaimBook::Card& ClaimBook::card(const Claim& claim) const {
    static const Card untouched;
    const auto found = cards_.find(claim.id);
    return found == cards_.end() ? untouched : found->second;
}

ClaimBook::Phase ClaimBook::phase(const Claim& claim) const {
    const Card& c = card(claim);
    if (c.result) return c.result->finding ? Phase::measured : Phase::failed;
    if (measuring_ == &claim) return Phase::measuring;
    if (std::ranges::find(waiting_, &claim) != waiting_.end()) return Phase::waiting;
    return c.prediction ? Phase::predicted : Phase::asked;
}

std::optional<int> ClaimBook::prediction(const Claim& claim) const { return card(claim).prediction; }

const ClaimResult* ClaimBook::result(const Claim& claim) const {
    const Card& c = card(claim);
    return c.result ? &*c.result : nullptr;
}

std::optional<bool> ClaimBook::was_right(const Claim& claim) const {
    const Card& c = card(claim);
    if (!c.prediction || !c.result) return std::nullopt;
    return *c.prediction == claim.right_answer;
}

void ClaimBook::predict(const Claim& claim, int answer) {
    if (answer < 0 || answer >= static_cast<int>(claim.answers.size()))
        throw Refused(fmt::format("{} has no answer {}: give 0 to {}", claim.id, answer, claim.answers.size() - 1));
    if (phase(claim) == Phase::asked || phase(claim) == Phase::predicted) cards_[claim.id].prediction = answer;
}

void ClaimBook::measure(const Claim& claim) {
    if (phase(claim) != Phase::asked && phase(claim) != Phase::predicted) return;
    waiting_.push_back(&claim);
    update();
}

void ClaimBook::measure_now(const Claim& claim) { cards_[claim.id].result = measured(claim); }

void ClaimBook::forget(const Claim& claim) {
    if (phase(claim) == Phase::measuring) return;
    std::erase(waiting_, &claim);
    cards_.erase(claim.id);
}

void ClaimBook::cancel(const Claim& claim) {
    if (measuring_ == &claim) watch_.cancel();
    std::erase(waiting_, &claim);
}

void ClaimBook::update() {
    if (under_way_ && under_way_->done()) {
        try {
            cards_[measuring_->id].result = under_way_->take();
        } catch (const Cancelled&) {
            // The card is as it was.
        }
        under_way_.reset();
        measuring_ = nullptr;
    }
    if (under_way_ || waiting_.empty()) return;
    measuring_ = waiting_.front();
    waiting_.pop_front();
    watch_.begin();
    since_ = Clock::now();
    under_way_.emplace([this, claim = measuring_](const std::stop_token&) {
        const Watched watched(watch_);
        return measured(*claim);
    });
}

std::vector<const Claim*> ClaimBook::listed(std::string_view lesson) const {
    if (!all) return claims_of(lesson);
    std::vector<const Claim*> list;
    for (const Claim& c : claims()) list.push_back(&c);
    return list;
}

const Claim* ClaimBook::unfolded(std::string_view lesson) const {
    const auto list = listed(lesson);
    const auto found = std::ranges::find(list, chosen_, [](const Claim* c) { return c->id; });
    return found != list.end() ? *found : list.empty() ? nullptr : list.front();
}

std::string_view name_of(ClaimBook::Phase phase) {
    switch (phase) {
        case ClaimBook::Phase::asked:
            return "asked";
        case ClaimBook::Phase::predicted:
            return "predicted";
        case ClaimBook::Phase::waiting:
            return "waiting";
        case ClaimBook::Phase::measuring:
            return "measuring";
        case ClaimBook::Phase::measured:
            return "measured";
        case ClaimBook::Phase::failed:
            return "failed";
    }
    return "";
}

void open_as_scene(Session& session, const Claim& claim) {
    session.later([&session, &claim] {
        session.open(find_lesson(claim.lesson), claim.scene);
        if (session.runner().is_static()) session.step();
    });
}

}  // namespace pliant::viewer
