// The claims of the ledger as a person goes through them: a prediction, then the experiment, which is made beside the window. It
// draws nothing.
#pragma once
#include <pliant/math/background.h>
#include <pliant/math/watch.h>
#include <pliant/study/claims_report.h>

#include <chrono>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pliant::viewer {

class Session;

class ClaimBook {
public:
    enum class Phase { asked, predicted, waiting, measuring, measured, failed };

    ClaimBook() = default;
    ClaimBook(const ClaimBook&) = delete;
    ClaimBook& operator=(const ClaimBook&) = delete;
    // An experiment that is under way is called off and waited for; those that wait for it are not made.
    ~ClaimBook() { watch_.cancel(); }

    Phase phase(const Claim& claim) const;
    std::optional<int> prediction(const Claim& claim) const;  // the number of the answer, from 0
    const ClaimResult* result(const Claim& claim) const;      // null until it is measured
    // Was the prediction right? Empty without one, and until the claim is measured.
    std::optional<bool> was_right(const Claim& claim) const;

    // Only while it is asked or predicted. Throws Refused for an answer that there is none of.
    void predict(const Claim& claim, int answer);
    // Each after those asked for before it; at once and in this thread with `now`.
    void measure(const Claim& claim);
    void measure_now(const Claim& claim);
    // One that waits, or is under way: that ends at the next place where it can, and is then as before.
    void cancel(const Claim& claim);
    // What is under way.
    const Watch& watch() const { return watch_; }
    Real seconds() const { return std::chrono::duration<Real>(Clock::now() - since_).count(); }  // since it began
    // Asks anew, unless it is being measured.
    void forget(const Claim& claim);

    // Takes up what has been measured, and begins with the next: call it in every frame.
    void update();
    bool busy() const { return under_way_ || !waiting_.empty(); }

    // --- what is looked at ---
    bool all = false;  // the claims of all lessons, not only of the open one
    std::vector<const Claim*> listed(std::string_view lesson) const;
    // The card that is unfolded: the one chosen if it is listed, else the first; null when none is.
    const Claim* unfolded(std::string_view lesson) const;
    void unfold(const Claim& claim) { chosen_ = claim.id; }

private:
    using Clock = std::chrono::steady_clock;
    struct Card {
        std::optional<int> prediction;
        std::optional<ClaimResult> result;
    };
    const Card& card(const Claim& claim) const;

    std::map<std::string_view, Card> cards_;  // by id
    std::deque<const Claim*> waiting_;
    const Claim* measuring_ = nullptr;
    std::string_view chosen_;
    Watch watch_;
    Clock::time_point since_{};
    std::optional<Background<ClaimResult>> under_way_;
};

std::string_view name_of(ClaimBook::Phase phase);

// The lesson of a claim with the parameters that show it; a static one is solved at once. A refusal becomes a message.
void open_as_scene(Session& session, const Claim& claim);

}  // namespace pliant::viewer
