// What a person keeps of a session to hand in: predictions as they are judged, and what is noted by hand. It draws nothing.
#pragma once
#include <pliant/document/hand_in.h>

#include <string>
#include <string_view>

namespace pliant {
class WalkthroughPlayer;
}

namespace pliant::viewer {

class Notebook {
public:
    const HandIn& hand_in() const { return hand_in_; }
    void set_name(std::string name);
    // Counts the changes, so that whoever keeps it in a file knows when to write.
    long changes() const { return changes_; }

    // What was predicted or answered on the slide whose answer shows, and what came; nothing where nothing was. A slide that is
    // answered again takes the place of its earlier answer.
    void note_slide(const Runner& runner, const WalkthroughPlayer& player);
    // Of a claim, by its question.
    void note_claim(std::string_view lesson, std::string_view claim, std::string_view question, std::string_view predicted,
                    std::string_view came, bool right);
    // The number of this probe where the run stands. Throws Refused where it has none.
    void note_number(const Runner& runner, std::string_view probe);
    // In words of the person's own, to the question of the slide, where there is one.
    void note_answer(const Runner& runner, const WalkthroughPlayer* player, std::string text);
    // The bytes of a PNG file.
    void note_picture(const Runner& runner, std::string_view png);
    void erase(std::size_t n);
    void clear();
    // Goes on with what was kept.
    void take(HandIn hand_in);

private:
    void add(HandInEntry entry);
    // In the place of an earlier one of the same kind, to the same question.
    void add_anew(HandInEntry entry);

    HandIn hand_in_;
    long changes_ = 0;
};

}  // namespace pliant::viewer
