// Plays random inputs on the lab, through ImGui's own queue of events, and looks at the lab after each.
#pragma once
#include "../process/process.h"
#include "app/lab.h"

#include <deque>
#include <memory>
#include <random>
#include <string>
#include <string_view>

namespace pliant::test {

class Monkey {
public:
    // It lives in a scratch folder, where whatever it saves goes. The same seed plays the same inputs.
    Monkey(std::string_view lesson, unsigned seed);
    ~Monkey();
    Monkey(const Monkey&) = delete;
    Monkey& operator=(const Monkey&) = delete;

    // One input and its frame: what is wrong afterwards, "" when nothing is.
    std::string play();
    // The lesson from its defaults, reset.
    std::string reset();
    // With the seed and the latest inputs.
    std::string report(const std::string& wrong) const;

private:
    static constexpr std::size_t remembered = 30;

    int upto(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    float part() { return static_cast<float>(random_() % 10001) / 10000.f; }

    void note(std::string what);
    void act();
    void press_key();
    void move_mouse();
    void press_mouse();
    void turn_wheel();
    void type_text();
    void type_a_number();
    void take_extreme();
    void change_place();
    void ask_why();
    void set_stops();
    void leave_dialogs();
    std::optional<viewer::Rectangle> some_control();
    bool costly(float x, float y);

    std::string frame();
    std::string look();

    Scratch scratch_;
    fs::path before_ = fs::current_path();
    unsigned seed_;
    std::mt19937 random_;
    std::unique_ptr<viewer::Context> context_;
    std::unique_ptr<viewer::Lab> lab_;
    std::deque<std::string> inputs_;
    long count_ = 0;
    float x_ = 0, y_ = 0;
    bool down_ = false;
};

}  // namespace pliant::test
