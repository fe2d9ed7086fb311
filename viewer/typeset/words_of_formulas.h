// What a single word of a sentence may be in a formula.
#pragma once
#include <cstddef>
#include <string_view>
#include <vector>

namespace pliant::viewer {

// A word of the sentence without the punctuation around it.
struct Token {
    std::size_t begin, end;            // in the sentence
    std::size_t core_begin, core_end;  // without punctuation
    std::size_t closed;                // without commas and the like, but with parentheses that other words opened

    bool bare_before() const { return core_begin == begin; }
    bool bare_behind() const { return core_end == end; }
};
std::vector<Token> tokens_of(std::string_view text);

// How many parentheses stay open behind the text; −1 when one is closed that was not opened.
int open_behind(std::string_view text);

bool is_sign_word(std::string_view word);      // stands between two operands: = + ≤
bool is_function_name(std::string_view word);  // sin, det
bool is_number(std::string_view word);
bool is_unit_of_number(std::string_view word);  // may stand behind a number, and is no symbol then
bool has_word(std::string_view text);           // three letters or more that are no function and no short index
bool is_symbol(std::string_view word);
bool may_be_symbol(std::string_view word);  // a letter or two that are one where a sign stands beside them

}  // namespace pliant::viewer
