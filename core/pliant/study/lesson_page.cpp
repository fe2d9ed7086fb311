#include <pliant/document/report.h>
#include <pliant/study/claims.h>
#include <pliant/study/lesson_page.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace pliant {

std::string lesson_text(const LessonEntry& entry) {
    std::string text = describe_text(entry);
    const auto stated = claims_of(entry.info.id);
    if (!stated.empty()) text += "\nClaims\n";
    for (const Claim* c : stated)
        text += fmt::format("  {:<5} {}\n  {:<5} {}: {}\n", c->id, c->statement, "", c->figure, c->criterion);
    return text;
}

std::string lesson_json(const LessonEntry& entry) {
    auto j = nlohmann::ordered_json::parse(describe_json(entry));
    auto& list = j["claims"] = nlohmann::ordered_json::array();
    for (const Claim* c : claims_of(entry.info.id))
        list.push_back({{"id", c->id},
                        {"statement", c->statement},
                        {"source", c->source},
                        {"experiment", c->experiment},
                        {"figure", c->figure},
                        {"unit", c->unit},
                        {"criterion", c->criterion},
                        {"expected", name_of(c->expected)},
                        {"question", c->question},
                        {"answers", c->answers},
                        {"right_answer", c->right_answer}});
    return j.dump(2) + "\n";
}

}  // namespace pliant
