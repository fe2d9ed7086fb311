#include <pliant/math/error.h>
#include <pliant/mesh_file/mesh_source.h>
#include <pliant/text/number_text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace pliant {
namespace {

constexpr bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
    return text;
}

}  // namespace

std::string MeshSource::printable(std::string_view text) {
    std::string clean(text.substr(0, 40));
    std::ranges::replace_if(
        clean, [](char c) { return static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126; }, '?');
    return clean;
}

void MeshSource::refuse(std::string_view what) const {
    const std::string where =
        binary_ ? fmt::format("byte {}", place_)
                : fmt::format(
                      "{}", 1 + std::count(bytes_.begin(),
                                           bytes_.begin() + static_cast<std::ptrdiff_t>(std::min(place_, bytes_.size())), '\n'));
    throw Refused(fmt::format("{}:{}: {}", path_, where, what));
}

void MeshSource::skip_space() {
    while (place_ < bytes_.size() && is_space(bytes_[place_])) ++place_;
}

std::string_view MeshSource::peek_line() const {
    return trimmed(bytes_.substr(place_, std::min(bytes_.find('\n', place_), bytes_.size()) - place_));
}

std::string_view MeshSource::line() {
    const std::size_t end = std::min(bytes_.find('\n', place_), bytes_.size());
    const std::string_view text = peek_line();
    place_ = std::min(end + 1, bytes_.size());
    return text;
}

std::string_view MeshSource::word() {
    skip_space();
    const std::size_t begin = place_;
    while (place_ < bytes_.size() && !is_space(bytes_[place_])) ++place_;
    if (begin == place_) refuse("the file ends where a number should stand");
    return bytes_.substr(begin, place_ - begin);
}

std::optional<std::string_view> MeshSource::peek_word() {
    skip_space();
    if (at_end()) return std::nullopt;
    const std::size_t before = place_;
    const std::string_view text = word();
    place_ = before;
    return text;
}

Real MeshSource::real_word() {
    const std::string_view text = word();
    const NumberText read = read_number(text);
    // A number too close to 0 is 0; one that is not finite is left to who knows which node it is of.
    if (!read.good() && read.error != std::errc::result_out_of_range)
        refuse(fmt::format("'{}' is not a number", printable(text)));
    return read.value;
}

Index MeshSource::whole_word() {
    const std::string_view text = word();
    const auto value = whole_number(text);
    if (!value) refuse(fmt::format("'{}' is not a whole number", printable(text)));
    return *value;
}

std::string_view MeshSource::quoted() {
    const std::string_view text = line();
    if (text.size() < 2 || text.front() != '"' || text.back() != '"')
        refuse(fmt::format("a name in quotes should stand here, not '{}'", printable(text)));
    return text.substr(1, text.size() - 2);
}

void MeshSource::skip_past(std::string_view end) {
    // In binary sections any bytes may lie between.
    const std::size_t found = bytes_.find(end, place_);
    if (found == std::string_view::npos) refuse(fmt::format("'{}' is missing", end));
    place_ = found + end.size();
    line();
}

void MeshSource::expect(std::string_view text) {
    skip_space();
    if (const std::string_view there = line(); there != text)
        refuse(fmt::format("'{}' should stand here, not '{}'", text, printable(there)));
}

template <class T>
T MeshSource::raw() {
    if (bytes_.size() - place_ < sizeof(T)) refuse("the file ends in the middle of a number");
    std::array<char, sizeof(T)> bytes;
    std::copy_n(bytes_.data() + place_, sizeof(T), bytes.data());
    if (swapped_) std::ranges::reverse(bytes);
    place_ += sizeof(T);
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
}

std::int32_t MeshSource::whole() {
    if (binary_) return raw<std::int32_t>();
    const Index value = whole_word();
    if (value < std::numeric_limits<std::int32_t>::min() || value > std::numeric_limits<std::int32_t>::max())
        refuse(fmt::format("{} is too large a number", value));
    return static_cast<std::int32_t>(value);
}

FileNumber MeshSource::number() {
    if (binary_) return raw<std::uint64_t>();
    const Index value = whole_word();
    if (value < 0) refuse(fmt::format("{} stands where a number from 0 on should be", value));
    return static_cast<FileNumber>(value);
}

template <class T>
Real MeshSource::raw_real() {
    return static_cast<Real>(raw<T>());
}

Real MeshSource::number_of(std::size_t bytes, bool is_real, bool is_signed) {
    if (is_real) return bytes == 4 ? raw_real<float>() : raw_real<double>();
    switch (bytes) {
        case 1:
            return is_signed ? raw_real<std::int8_t>() : raw_real<std::uint8_t>();
        case 2:
            return is_signed ? raw_real<std::int16_t>() : raw_real<std::uint16_t>();
        case 4:
            return is_signed ? raw_real<std::int32_t>() : raw_real<std::uint32_t>();
        default:
            return is_signed ? raw_real<std::int64_t>() : raw_real<std::uint64_t>();
    }
}

void MeshSource::skip(std::size_t bytes) {
    if (bytes > bytes_.size() - place_) refuse("the file ends before its numbers begin");
    place_ += bytes;
}

Real MeshSource::real() { return binary_ ? raw<double>() : real_word(); }

Index MeshSource::checked_count(Index count, std::string_view what, std::size_t least_bytes_each) const {
    const std::size_t left = bytes_.size() - std::min(place_, bytes_.size());
    if (count < 0 || static_cast<std::size_t>(count) > left / least_bytes_each + 1)
        refuse(fmt::format("{} {} are announced, but the file is too short for them", count, what));
    return count;
}

Index MeshSource::count(std::string_view what, std::size_t least_bytes_each) {
    const FileNumber n = number();
    if (n > static_cast<FileNumber>(std::numeric_limits<int>::max()))
        refuse(fmt::format("{} {} are more than can be read", n, what));
    return checked_count(static_cast<Index>(n), what, binary_ ? least_bytes_each : 2);
}

Index MeshSource::count_of_ints(std::string_view what, std::size_t least_bytes_each) {
    return checked_count(whole(), what, binary_ ? least_bytes_each : 2);
}

}  // namespace pliant
