// The ledger of claims: what the lectures say of a method, each as an experiment that measures whether it is so. Its words lie
// beside the lesson as claims.md (claims_reader.h), and a function that registers itself makes the experiment; the command line,
// the lab, the tests and the page of the documentation follow from both.
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
    std::string id;          // "E7": a letter for the chapter, and a number
    std::string lesson;      // "elasticity/poisson"
    std::string statement;   // of the lecture, in our words
    std::string source;      // which lecture, which slide: "U, T: Poisson's ratio"
    std::string experiment;  // what is done, in a sentence
    std::string figure;      // what the number is: "largest |measured − exact| / exact"
    std::string unit = "";
    std::string criterion;  // "≤ 10⁻⁹"
    // Asked before it is run: a question, answers to choose from, and the number of the right one, from 0.
    std::string question;
    std::vector<std::string> answers;
    int right_answer = 0;
    // Parameters of the lesson that show it.
    std::vector<std::pair<std::string, std::string>> scene;
    Verdict expected = Verdict::reproduced;  // the tests ask for this one
    std::function<Finding()> measure;
};

// All claims, chapter by chapter in the order of the lectures (E, I, M, P, R, F), then by number. Throws Refused when a text
// cannot be read, and for words that nothing measures as for an experiment without words; the program asks before anything else.
const std::vector<Claim>& claims();

// Those of one lesson ("elasticity/moduli"), in the same order.
std::vector<const Claim*> claims_of(std::string_view lesson);

// By id, in either case. Throws Refused with the ids there are.
const Claim& find_claim(std::string_view id);

// What the letter of its id stands for: "Elasticity".
std::string_view chapter_of(const Claim& claim);

// Makes the experiment of a claim. At namespace scope of <lesson>_claims.cpp:  const ClaimRegistration e7{"E7", contraction};
struct ClaimRegistration {
    ClaimRegistration(std::string_view id, std::function<Finding()> measure);
};

// The claims of these texts (lesson and text) with what measures them, in the order of the lectures. Throws as claims() does.
using ClaimTexts = std::vector<std::pair<std::string_view, std::string_view>>;
using ClaimMeasures = std::vector<std::pair<std::string_view, std::function<Finding()>>>;
std::vector<Claim> joined_claims(const ClaimTexts& texts, const ClaimMeasures& measures);

}  // namespace pliant
