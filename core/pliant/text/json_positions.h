// Where each key and element of a JSON text stands, so that an error can name line and column.
#pragma once
#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <string_view>

namespace pliant {

struct TextPlace {
    int line = 1, column = 1;  // from 1; columns count bytes
};

struct PlacedJson {
    nlohmann::ordered_json value;
    std::map<std::string, TextPlace> places;  // by JSON pointer: of the key, or of the element's end in an array

    TextPlace at(const std::string& pointer) const;
};

// A key as it stands in a JSON pointer, with '~' and '/' spelt out (RFC 6901, section 3).
std::string pointer_part(std::string_view key);

// Throws Refused as "path:line:column: ..." for text that is not one JSON value alone, and for a key given twice.
PlacedJson parse_json(std::string_view text, std::string_view path);

}  // namespace pliant
