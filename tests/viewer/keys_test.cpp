// Keys of several keyboards, as the window's library tells of them: the key by its name or, where that is no ASCII letter or
// sign, by its place on a US keyboard, and the character that it types.
#include <imgui.h>
#include <pliant/text/file.h>
#include <catch2/catch_test_macros.hpp>

#include "panels/keys.h"

#include <algorithm>
#include <regex>
#include <set>
#include <string>
#include <vector>

using namespace pliant;
using namespace pliant::viewer;
using Actions = std::vector<Action>;

namespace {

struct Press {
    ImGuiKey key;
    bool shift = false, alt_gr = false, ctrl = false;
    unsigned character = 0;
};

class Keyboard {
public:
    Keyboard() {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {800, 600};
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
        frame();
    }
    ~Keyboard() { ImGui::DestroyContext(); }
    Keyboard(const Keyboard&) = delete;
    Keyboard& operator=(const Keyboard&) = delete;

    Actions frame() {
        Actions done;
        ImGui::GetIO().DeltaTime = 1.0f / 60;
        ImGui::NewFrame();
        handle_keys({}, [&](Action a) { done.push_back(a); });
        ImGui::EndFrame();
        return done;
    }
    // The key goes down and, some frames later, up.
    Actions press(const Press& p) {
        modify(p, true);
        ImGui::GetIO().AddKeyEvent(p.key, true);
        if (p.character) ImGui::GetIO().AddInputCharacter(p.character);
        Actions all = frame();
        for (int i = 0; i < 3; ++i) append(all, frame());
        ImGui::GetIO().AddKeyEvent(p.key, false);
        modify(p, false);
        for (int i = 0; i < 3; ++i) append(all, frame());
        return all;
    }
    // Held for a second, while the system repeats the character.
    Actions hold(const Press& p) {
        ImGui::GetIO().AddKeyEvent(p.key, true);
        Actions all;
        for (int i = 0; i < 60; ++i) {
            if (i == 0 || (i > 30 && i % 3 == 0)) ImGui::GetIO().AddInputCharacter(p.character);
            append(all, frame());
        }
        ImGui::GetIO().AddKeyEvent(p.key, false);
        append(all, frame());
        return all;
    }

private:
    static void append(Actions& all, const Actions& more) { all.insert(all.end(), more.begin(), more.end()); }
    static void modify(const Press& p, bool down) {
        ImGuiIO& io = ImGui::GetIO();
        const auto send = [&](ImGuiKey mod, ImGuiKey key) { io.AddKeyEvent(mod, down), io.AddKeyEvent(key, down); };
        if (p.shift) send(ImGuiMod_Shift, ImGuiKey_LeftShift);
        if (p.ctrl) send(ImGuiMod_Ctrl, ImGuiKey_LeftCtrl);
        if (p.alt_gr) send(ImGuiMod_Alt, ImGuiKey_RightAlt);
    }
};

}  // namespace

TEST_CASE("signs are keys on a US, a German and a French keyboard") {
    const std::vector<std::pair<Press, Action>> presses{
        // US
        {{.key = ImGuiKey_Period, .character = '.'}, Action::step},
        {{.key = ImGuiKey_Comma, .character = ','}, Action::stage_back},
        {{.key = ImGuiKey_Comma, .shift = true, .character = '<'}, Action::step_back},
        {{.key = ImGuiKey_Slash, .character = '/'}, Action::stage},
        {{.key = ImGuiKey_Semicolon, .character = ';'}, Action::pass},
        {{.key = ImGuiKey_Apostrophe, .character = '\''}, Action::pass_back},
        {{.key = ImGuiKey_LeftBracket, .character = '['}, Action::previous_lesson},
        {{.key = ImGuiKey_RightBracket, .character = ']'}, Action::next_lesson},
        // German: / is Shift 7, ; Shift comma, ' Shift #, the brackets AltGr 8 and 9
        {{.key = ImGuiKey_Period, .character = '.'}, Action::step},
        {{.key = ImGuiKey_Comma, .character = ','}, Action::stage_back},
        {{.key = ImGuiKey_7, .shift = true, .character = '/'}, Action::stage},
        {{.key = ImGuiKey_Comma, .shift = true, .character = ';'}, Action::pass},
        {{.key = ImGuiKey_Backslash, .shift = true, .character = '\''}, Action::pass_back},
        {{.key = ImGuiKey_8, .alt_gr = true, .character = '['}, Action::previous_lesson},
        {{.key = ImGuiKey_9, .alt_gr = true, .character = ']'}, Action::next_lesson},
        // the same where AltGr is Ctrl and Alt
        {{.key = ImGuiKey_9, .alt_gr = true, .ctrl = true, .character = ']'}, Action::next_lesson},
        // French: . is Shift ;, / Shift :, ' the key 4, the brackets AltGr 5 and )
        {{.key = ImGuiKey_Semicolon, .shift = true, .character = '.'}, Action::step},
        {{.key = ImGuiKey_Comma, .character = ','}, Action::stage_back},
        {{.key = ImGuiKey_Period, .shift = true, .character = '/'}, Action::stage},
        {{.key = ImGuiKey_Semicolon, .character = ';'}, Action::pass},
        {{.key = ImGuiKey_Apostrophe, .character = '\''}, Action::pass_back},
        {{.key = ImGuiKey_5, .alt_gr = true, .character = '['}, Action::previous_lesson},
        {{.key = ImGuiKey_Minus, .alt_gr = true, .character = ']'}, Action::next_lesson},
        // and the digits of its first row, without Shift and with it
        {{.key = ImGuiKey_2, .character = 0xe9}, Action::beside},
        {{.key = ImGuiKey_2, .shift = true, .character = '2'}, Action::beside},
    };
    Keyboard keyboard;
    for (const auto& [press, action] : presses) {
        CAPTURE(press.key, static_cast<char>(press.character));
        CHECK(keyboard.press(press) == Actions{action});
    }
}

TEST_CASE("keys of other keyboards that type nothing of the table do nothing") {
    Keyboard keyboard;
    // ö, ä and ü stand where a US keyboard has ; ' and [, the French : where it has a point.
    CHECK(keyboard.press({.key = ImGuiKey_Semicolon, .character = 0xf6}).empty());
    CHECK(keyboard.press({.key = ImGuiKey_Apostrophe, .character = 0xe4}).empty());
    CHECK(keyboard.press({.key = ImGuiKey_LeftBracket, .character = 0xfc}).empty());
    CHECK(keyboard.press({.key = ImGuiKey_Period, .character = ':'}).empty());
    // AltGr and a letter or digit is another character, or nothing.
    CHECK(keyboard.press({.key = ImGuiKey_2, .alt_gr = true, .character = '~'}).empty());
}

TEST_CASE("what takes more than one key on some keyboards has a function key, or a letter, as well") {
    const std::vector<std::tuple<ImGuiKey, bool, Action>> twins{
        {ImGuiKey_F2, false, Action::step},        {ImGuiKey_F2, true, Action::step_back},
        {ImGuiKey_F3, false, Action::stage},       {ImGuiKey_F3, true, Action::stage_back},
        {ImGuiKey_F4, false, Action::pass},        {ImGuiKey_F4, true, Action::pass_back},
        {ImGuiKey_F7, false, Action::next_lesson}, {ImGuiKey_F7, true, Action::previous_lesson},
        {ImGuiKey_F8, false, Action::larger},      {ImGuiKey_F8, true, Action::smaller}};
    Keyboard keyboard;
    for (const auto& [key, shift, action] : twins) CHECK(keyboard.press({.key = key, .shift = shift}) == Actions{action});
    std::set<Action> with_twin;
    for (const KeyBinding& b : key_bindings())
        if ((b.key >= ImGuiKey_F1 && b.key <= ImGuiKey_F12) || (b.key >= ImGuiKey_A && b.key <= ImGuiKey_Z))
            with_twin.insert(b.action);
    for (const KeyBinding& b : key_bindings())
        if (b.character) CHECK(with_twin.contains(b.action));
}

TEST_CASE("a sign that is held is repeated where its key is, and every press of a slow frame counts") {
    Keyboard keyboard;
    CHECK(keyboard.hold({.key = ImGuiKey_RightBracket, .character = ']'}) == Actions{Action::next_lesson});
    CHECK(keyboard.hold({.key = ImGuiKey_Period, .character = '.'}).size() > 5);
    for (int i = 0; i < 3; ++i) ImGui::GetIO().AddInputCharacter('.');
    CHECK(keyboard.frame() == Actions{Action::step, Action::step, Action::step});
}

TEST_CASE("no two keys of one place mean different things") {
    std::set<std::tuple<int, bool, bool, char, Where>> seen;
    for (const KeyBinding& b : key_bindings())
        if (b.key != ImGuiKey_None || b.character) CHECK(seen.emplace(b.key, b.ctrl, b.shift, b.character, b.where).second);
}

TEST_CASE("README teaches keys of the table, and its page has all of them") {
    std::set<std::string> known{"Shift"};
    for (const KeyRow& row : key_rows())
        for (const std::string_view key : row.keys) known.emplace(key);
    const std::string readme = read_file(PLIANT_SOURCE_DIR "/README.md");
    const std::regex bold(R"(\*\*([^*\n]{1,12})\*\*)");
    int taught = 0;
    for (auto it = std::sregex_iterator(readme.begin(), readme.end(), bold); it != std::sregex_iterator(); ++it, ++taught) {
        INFO("README teaches " << (*it)[1]);
        CHECK(known.contains((*it)[1]));
    }
    CHECK(taught >= 20);
    CHECK(read_file(PLIANT_SOURCE_DIR "/docs/keys.md") == keys_markdown());
}
