#include <pliant/math/error.h>
#include <pliant/text/json_positions.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

TextPlace place_of(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const auto newline = before.rfind('\n');
    return {1 + static_cast<int>(std::ranges::count(before, '\n')),
            1 + static_cast<int>(newline == std::string_view::npos ? before.size() : before.size() - newline - 1)};
}

// An input iterator that tells how far the parser has read.
struct CountingIterator {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    const char* at = nullptr;
    std::size_t* read = nullptr;

    reference operator*() const { return *at; }
    CountingIterator& operator++() {
        ++at;
        if (read) ++*read;
        return *this;
    }
    CountingIterator operator++(int) {
        CountingIterator old = *this;
        ++*this;
        return old;
    }
    bool operator==(const CountingIterator& other) const { return at == other.at; }
    bool operator!=(const CountingIterator& other) const { return at != other.at; }
};

// Follows the parser's events and notes where each key and array element is.
class PlaceRecorder : public nlohmann::json_sax<Json> {
public:
    PlaceRecorder(std::string_view text, std::string_view path, const std::size_t& read)
        : text_(text), path_(path), read_(read) {}
    std::map<std::string, TextPlace> places;

    bool key(std::string& name) override {
        Level& level = levels_.back();
        level.pointer = level.base + "/" + pointer_part(name);
        const TextPlace p = place_of(text_, opening_quote());
        if (!places.emplace(level.pointer, p).second) {
            throw Refused(fmt::format("{}:{}:{}: the key '{}' is given twice: keep one", path_, p.line, p.column, name));
        }
        return true;
    }
    bool start_object(std::size_t) override { return open(false); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(true); }
    bool end_array() override { return close(); }
    bool null() override { return element(); }
    bool boolean(bool) override { return element(); }
    bool number_integer(number_integer_t) override { return element(); }
    bool number_unsigned(number_unsigned_t) override { return element(); }
    bool number_float(number_float_t, const string_t&) override { return element(); }
    bool string(string_t&) override { return element(); }
    bool binary(binary_t&) override { return element(); }
    bool parse_error(std::size_t offset, const std::string& token, const nlohmann::detail::exception& e) override {
        const TextPlace p = place_of(text_, offset == 0 ? 0 : offset - 1);
        throw Refused(
            fmt::format("{}:{}:{}: this is not JSON at '{}': {}", path_, p.line, p.column, token, explanation(e.what())));
    }

private:
    struct Level {
        bool array;
        std::string base, pointer;
        std::size_t count = 0;
    };
    // Of the key whose closing quote the parser has just read. A quote inside the key has a backslash before it.
    std::size_t opening_quote() const {
        std::size_t at = read_ - 1;
        do at = text_.rfind('"', at - 1);
        while (at > 0 && text_[at - 1] == '\\');
        return at;
    }
    // The parser's own words, without the name of its exception and its place.
    static std::string explanation(const std::string& what) {
        const auto place = what.find(" at line "), start = what.find(place == std::string::npos ? "] " : ": ");
        return start == std::string::npos ? what : what.substr(start + 2);
    }
    bool element() {
        if (!levels_.empty() && levels_.back().array) {
            Level& level = levels_.back();
            level.pointer = level.base + "/" + std::to_string(level.count++);
            places.emplace(level.pointer, place_of(text_, read_ == 0 ? 0 : read_ - 1));
        }
        return true;
    }
    bool open(bool array) {
        element();
        if (levels_.size() > 100) {
            const TextPlace p = place_of(text_, read_ - 1);
            throw Refused(fmt::format("{}:{}:{}: nested deeper than any scene file is", path_, p.line, p.column));
        }
        levels_.push_back({array, levels_.empty() ? "" : levels_.back().pointer, {}});
        return true;
    }
    bool close() {
        levels_.pop_back();
        return true;
    }

    std::string_view text_, path_;
    const std::size_t& read_;
    std::vector<Level> levels_;
};

}  // namespace

std::string pointer_part(std::string_view key) {
    std::string text;
    for (const char c : key) text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return text;
}

TextPlace PlacedJson::at(const std::string& pointer) const {
    const auto found = places.find(pointer);
    return found == places.end() ? TextPlace{} : found->second;
}

PlacedJson parse_json(std::string_view text, std::string_view path) {
    // The parser would take it for the end.
    if (const auto at = text.find('\0'); at != std::string_view::npos) {
        const TextPlace p = place_of(text, at);
        throw Refused(fmt::format("{}:{}:{}: this is not JSON: a NUL byte stands here", path, p.line, p.column));
    }
    std::size_t read = 0;
    PlaceRecorder recorder(text, path, read);
    const CountingIterator first{text.data(), &read}, last{text.data() + text.size(), nullptr};
    Json::sax_parse(first, last, &recorder);
    return {Json::parse(text), std::move(recorder.places)};
}

}  // namespace pliant
