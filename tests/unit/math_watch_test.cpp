// What a long computation tells, and how it is called off.
#include <pliant/math/conjugate_gradients.h>
#include <pliant/math/watch.h>
#include <catch2/catch_test_macros.hpp>

#include <thread>

using namespace pliant;

TEST_CASE("watch: a computation that nobody watches tells nothing and is never left") {
    CHECK_NOTHROW(cancel_point());
    CHECK_NOTHROW(tell_progress("sweep", 3, 10));
}

TEST_CASE("watch: it knows which part is under way, how far it is and how long it will take") {
    Watch watch;
    watch.begin();
    CHECK(watch.progress().what.empty());
    const Watched watched(watch);
    tell_progress("sweep", 3, 12);
    const Watch::Progress p = watch.progress();
    CHECK(p.what == "sweep");
    CHECK(p.done == 3);
    CHECK(*p.share() == 0.25);
    CHECK(Watch::Progress{"sweep", 3, 12, 6}.seconds_left() == 18);
    CHECK(Watch::Progress{"sweep", 12, 12, 6}.seconds_left() == 0);
    // Nobody can tell before anything is done, or of how much.
    CHECK_FALSE(Watch::Progress{"sweep", 0, 12, 6}.seconds_left());
    tell_progress("newton", 7);
    CHECK_FALSE(watch.progress().share());
    CHECK_FALSE(watch.progress().seconds_left());
    watch.begin();
    CHECK(watch.progress().done == 0);
}

TEST_CASE("watch: what is cancelled ends at its next place to, once") {
    Watch watch;
    const Watched watched(watch);
    watch.cancel();
    CHECK(watch.cancelling());
    CHECK_THROWS_AS(cancel_point(), Cancelled);
    CHECK_NOTHROW(cancel_point());
    watch.cancel();
    {
        const Uncancelled now;
        CHECK_FALSE(watch.cancellable());
        CHECK_NOTHROW(cancel_point());
        CHECK_NOTHROW(tell_progress("sweep", 1));
    }
    CHECK(watch.cancellable());
    CHECK_THROWS_AS(tell_progress("sweep", 2), Cancelled);
}

TEST_CASE("watch: it is that of one thread, and the innermost counts") {
    Watch outer, inner;
    const Watched of_outer(outer);
    outer.cancel();
    {
        const Watched of_inner(inner);
        CHECK_NOTHROW(cancel_point());
        bool left = false;
        std::thread([&] {
            try {
                cancel_point();
            } catch (const Cancelled&) {
                left = true;
            }
        }).join();
        CHECK_FALSE(left);
    }
    CHECK_THROWS_AS(cancel_point(), Cancelled);
}

TEST_CASE("watch: a linear system that is being solved can be left") {
    constexpr Index n = 200;
    SparseMatrix laplacian(n, n);
    for (Index i = 0; i < n; ++i) {
        laplacian.insert(i, i) = 2;
        if (i > 0) laplacian.insert(i, i - 1) = -1;
        if (i + 1 < n) laplacian.insert(i, i + 1) = -1;
    }
    laplacian.makeCompressed();
    ConjugateGradients cg(laplacian, {});
    cg.begin(VecX::Ones(n), VecX::Zero(n));
    Watch watch;
    const Watched watched(watch);
    watch.cancel();
    CHECK_THROWS_AS(cg.solve(), Cancelled);
    cg.solve();
    CHECK(cg.converged());
}
