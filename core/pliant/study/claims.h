// The ledger of claims: what the lectures say of a method, each as an experiment that measures whether it is so. A claim is
// declared beside its lesson and registers itself; the command line, the lab, the tests and the page of the documentation follow
// from it.
#pragma once
#include <pliant/math/types.h>

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pliant {

enum class Verdict {
    reproduced,  // the figure meets its criterion
    qualified,   // it does under a condition that the experiment finds
    refuted
};
std::string_view name_of(Verdict verdict);

// What an experiment found. Throws nothing of its own: an experiment that cannot be made throws as its solver does.
struct Finding {
    Real figure = 0;  // in the unit of the claim
    Verdict verdict = Verdict::refuted;
    std::string text;         // one or two sentences with the numbers that were measured
    std::string condition{};  // of a qualified claim: where it stops being true
};

struct Claim {
    std::string_view id;          // "E7": a letter for the chapter, and a number
    std::string_view lesson;      // "elasticity/poisson"
    std::string_view statement;   // of the lecture, in our words
    std::string_view source;      // which lecture, which slide: "U, T: Poisson's ratio"
    std::string_view experiment;  // what is done, in a sentence
    std::string_view figure;      // what the number is: "largest |measured − exact| / exact"
    std::string_view unit = "";
    std::string_view criterion;  // "≤ 10⁻⁹"
    // Asked before it is run: a question, answers to choose from, and the number of the right one, from 0.
    std::string_view question;
    std::vector<std::string_view> answers;
    int right_answer = 0;
    // Parameters of the lesson that show it.
    std::vector<std::pair<std::string, std::string>> scene;
    Verdict expected = Verdict::reproduced;  // the tests ask for this one
    bool timed = false;  // wall time enters the figure: it differs from run to run, and generated pages leave it out
    std::function<Finding()> measure;
};

// All claims, chapter by chapter in the order of the lectures (E, I, M, P, R, F), then by number.
const std::vector<Claim>& claims();

// Those of one lesson ("elasticity/moduli"), in the same order.
std::vector<const Claim*> claims_of(std::string_view lesson);

// By id, in either case. Throws Refused with the ids there are.
const Claim& find_claim(std::string_view id);

// What the letter of its id stands for: "Elasticity".
std::string_view chapter_of(const Claim& claim);

void register_claim(const Claim& claim);

// At namespace scope of <lesson>_claims.cpp:  const ClaimRegistration e7{{.id = "E7", ...}};
struct ClaimRegistration {
    explicit ClaimRegistration(const Claim& claim) { register_claim(claim); }
};

}  // namespace pliant
